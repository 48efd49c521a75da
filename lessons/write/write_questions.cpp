#include "core/numerics/variants.hpp"
#include "core/quantity/names.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/read/quantities.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writing.hpp"

namespace jw::writing {

namespace {

struct AnswerWriter {
    const Written& written;
    Lines& lines;

    void operator()(const CountAnswer& a) const {
        lines.key("count", string_text(word_of(kCounts, a.count)));
    }
    void operator()(const DroppedAnswer& a) const {
        const std::string name = written.name_of({Addition::Kind::joint, a.joint});
        lines.key("dropped", string_text(name + " " + std::string(word_of(a.role))));
    }
    void operator()(const QuantityAnswer& a) const {
        lines.key("quantity", string_text(a.text));
        const bool is_open = a.text.find('[') == std::string::npos;
        const auto* const point = std::get_if<PointQuantity>(&a.quantity);
        if (point != nullptr && is_open) { lines.key("point", point->s_local, "m"); }
        const auto* const speed = std::get_if<PointSpeedQuantity>(&a.quantity);
        if (speed != nullptr && is_open) { lines.key("point", speed->s_local, "m"); }
        lines.key("at_s", a.when.t);
        const std::vector<std::string> endings = reading::unit_endings(a.quantity, a.derivative);
        if (!a.in_degrees) { return lines.key("tolerance" + endings.back(), a.tolerance); }
        const AngleTexts typed = typed_angles({&a.tolerance, 1});
        lines.key("tolerance" + endings[typed.unit == "deg" ? 0 : 1], typed.values[0]);
    }
    void operator()(const ChoiceAnswer& a) const {
        lines.texts("choices", a.choices);
        lines.key("answer", std::to_string(a.right + 1));
    }
    void operator()(const PointedAnswer& a) const {
        lines.key("click", string_text(word_of(kThings, a.kind)));
        if (a.found) { return lines.key("rows", string_text(word_of(kRowsFound, *a.found))); }
        std::vector<std::string> names;
        for (const Thing& thing : a.right) { names.push_back(name_of(thing, written.lesson->mechanism)); }
        lines.key("right", list_of_texts(names));
    }
    void operator()(const PoseAnswer& a) const {
        lines.key("pose", string_text(written.body(a.body)));
        if (a.when) { lines.key("at_s", a.when->t); }
        lines.key("tolerance", a.tolerance_m);
        const AngleTexts turn = typed_angles({&a.tolerance_rad, 1});
        lines.key("tolerance_" + turn.unit, turn.values[0]);
    }
};

std::string place_text(const Question& question, const Written& written) {
    switch (question.place) {
        case Question::Place::bodies: return "bodies";
        case Question::Place::motion: return "motion";
        case Question::Place::addition: break;
    }
    return written.name_of(question.addition);
}

}  // namespace

void write_questions(const Written& written, Lines& lines) {
    const Lesson& lesson = *written.lesson;
    if (!lesson.questions.empty() || !lesson.trials.empty()) { lines.section("questions, and what to try"); }
    for (const Question& question : lesson.questions) {
        if (!applies(question, lesson)) { continue; }
        lines.table("[[question]]");
        lines.key("at", string_text(place_text(question, written)));
        lines.text("ask", question.ask);
        std::visit(AnswerWriter{written, lines}, question.answer);
        if (!question.why.own().empty()) { lines.text("why", question.why); }
    }
    for (const Trial& trial : lesson.trials) {
        lines.table("[[try]]");
        lines.text("text", trial.text);
        lines.key("do", list_of_texts(trial.actions));
        if (trial.breaks) { lines.key("breaks", "true"); }
    }
}

}  // namespace jw::writing
