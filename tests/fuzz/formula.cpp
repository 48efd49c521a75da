#include <memory>
#include <string>

#include "core/equations/system.hpp"
#include "core/quantity/names.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"
#include "lessons/read/reader.hpp"
#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

namespace {

const Instant& instant() {
    static const Lesson lesson =
        read_lesson_file(std::string(JW_SOURCE_ROOT) + "/lessons/exercises/scenes/four-bar.toml")
            .lesson.value();
    static const Instant arbitrary = formula::arbitrary_instant(
        std::make_shared<const System>(lesson.mechanism, everything(lesson.mechanism)), 1);
    return arbitrary;
}

/// LaTeX without its braces, since braces around nothing come and go.
std::string without_braces(std::string latex) {
    std::erase_if(latex, [](char c) { return c == '{' || c == '}'; });
    return latex;
}

/// In LaTeX alone: two numbers side by side are one number there, as they are on paper.
void promise_same_in_latex(const math::Row& row) {
    const std::string latex = math::write_latex(row);
    const math::Reading again = math::read_math(latex);
    promise(!again.problem, "'" + latex + "' that was written can be read");
    promise(
        without_braces(math::write_latex(again.row)) == without_braces(latex),
        "'" + latex + "' that was written reads the same");
    math::write_plain(row);
    promise(math::write_mathml(row, true).ends_with("</math>"), "it has an element of MathML");
}

void promise_evaluated_or_explained(const std::string& source) {
    formula::Subject of_joint;
    of_joint.joint = 0;
    for (const formula::Subject& subject : {of_joint, formula::Subject{}}) {
        const formula::Outcome outcome = formula::evaluate_at({source, {}, subject}, instant());
        if (!outcome.problem) { continue; }
        promise(outcome.problem->at <= source.size(), "a problem is inside the formula");
        promise(!outcome.problem->message.empty(), "a problem has words");
    }
}

/// Promises about the same bytes, read as the name of a quantity.
void promise_same_name(const std::string& text) {
    const Mechanism& m = instant().system->mechanism();
    const auto read = read_name(text, m);
    if (!read || read->wants_point) { return; }
    const std::string name = name_of(read->named.quantity, read->named.derivative, m);
    const auto again = read_name(name, m);
    promise(again.has_value(), "the name '" + name + "' of '" + text + "' is one");
    promise(
        name_of(again->named.quantity, again->named.derivative, m) == name, "'" + name + "' names itself");
}

}  // namespace

bool check_formula(const std::string& input) {
    promise_same_name(input);
    const math::Reading reading = math::read_math(input);
    if (reading.problem) {
        promise(reading.problem->at <= input.size(), "a problem is inside the formula");
        promise(!reading.problem->message.empty(), "a problem has words");
        return false;
    }
    promise_same_in_latex(reading.row);
    promise_evaluated_or_explained(input);
    return true;
}

}  // namespace jw::fuzz
