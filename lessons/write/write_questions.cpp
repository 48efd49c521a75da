#include "core/numerics/variants.hpp"
#include "core/quantity/names.hpp"
#include "lessons/lesson/enum_words.hpp"
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
        write_point(a.quantity, a.text, lines);
        lines.key("at_s", a.when.t);
        write_values(a.quantity, a.derivative, a.in_degrees, {{"tolerance", a.tolerance}}, lines);
    }
    void operator()(const ChoiceAnswer& a) const {
        lines.texts("choices", a.choices);
        lines.key("answer", std::to_string(a.right + 1));
    }
    void operator()(const PointedAnswer& a) const {
        lines.key("click", string_text(word_of(kThings, a.kind)));
        if (a.found) { return lines.key("rows", string_text(word_of(kRowsFound, *a.found))); }
        const auto name = [&](const Thing& t) { return string_text(name_of(t, written.lesson->mechanism)); };
        lines.key("right", list_text(a.right, name));
    }
    void operator()(const PoseAnswer& a) const {
        lines.key("pose", string_text(written.body(a.body)));
        if (a.when) { lines.key("at_s", a.when->t); }
        lines.key("tolerance", a.tolerance_m);
        lines.angle("tolerance", a.tolerance_rad);
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
        lines.key("do", list_text(trial.actions, string_text));
        if (trial.breaks) { lines.key("breaks", "true"); }
    }
}

}  // namespace jw::writing
