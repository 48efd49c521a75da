#include <algorithm>

#include "core/quantity/names.hpp"
#include "lessons/diagnostics/text_place.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

void read_joint(Fields& fields, const Reading& reading, formula::Subject& subject) {
    const auto name = fields.text("joint");
    const Named* const joint = name ? reading.joint(*name) : nullptr;
    if (joint == nullptr || !joint->sound) { return; }
    subject.joint = joint->index;
    const JointType& type = *reading.lesson.mechanism.joints[static_cast<std::size_t>(joint->index)].type;
    std::vector<std::string> words;
    for (const Role role : type.roles) { words.emplace_back(word_of(role)); }
    if (const auto word = fields.word("primitive", words)) { subject.role = type.roles[*word]; }
}

formula::Subject read_subject(Fields& fields, const Reading& reading) {
    formula::Subject subject;
    fields.at_most_one({"joint", "body"});
    if (fields.has("joint")) {
        read_joint(fields, reading, subject);
    } else if (const auto name = fields.text("body")) {
        const Named* const body = reading.body(*name);
        if (body != nullptr) { subject.body = body->index; }
    } else {
        subject.coordinates = fields.word("coordinates", kChoices).value_or(subject.coordinates);
    }
    return subject;
}

/// Evaluates the formula in a random state, where only its symbols and shapes can be wrong.
void try_out(Fields& fields, const Reading& reading, const formula::Formula& formula, bool holds) {
    // other mistakes would only be reported twice
    if (reading.problems->errors_count() > 0) { return; }
    const Mechanism& mechanism = reading.lesson.mechanism;
    Instant instant =
        formula::arbitrary_instant(std::make_shared<const System>(mechanism, everything(mechanism)), 0);
    if (reading.lesson.dynamics) {
        instant.scene =
            std::make_shared<const Centroidal>(centroidal(mechanism, reading.lesson.dynamics->loads));
    }
    const formula::Outcome outcome = formula::evaluate_at(formula, instant);
    // shapes that do not fit may be the misprint; in other states, a function may have a value
    if (!outcome.problem || (outcome.misfit && !holds) || outcome.no_value) { return; }
    const math::Problem& problem = *outcome.problem;
    reading.problems->add(
        Code::formula_without_value,
        outcome.definition < 0 ? fields.place_in("formula", problem.at) : fields.span("where"),
        problem.message, problem.hint);
}

}  // namespace

std::optional<FormulaClaim> read_formula_claim(Fields& fields, const Reading& reading) {
    if (!fields.has("formula")) { return std::nullopt; }
    const int errors = reading.problems->errors_count();
    FormulaClaim claim;
    const auto source = fields.formula("formula");
    claim.formula.subject = read_subject(fields, reading);
    if (const auto where = fields.texts("where")) {
        for (const Located<std::string>& definition : where->value) {
            if (const auto problem = math::read_math(definition.value).problem) {
                reading.problems->add(
                    Code::unreadable_formula,
                    place_in_text(reading.problems->source(), definition.span, problem->at), problem->message,
                    problem->hint);
            }
            claim.formula.where.push_back(definition.value);
        }
    }
    if (const auto holds = fields.flag("holds")) { claim.holds = holds->value; }
    if (!source || reading.problems->errors_count() > errors) { return std::nullopt; }
    claim.formula.source = source->value;
    try_out(fields, reading, claim.formula, claim.holds);
    return claim;
}

}  // namespace jw::reading
