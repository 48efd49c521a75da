#include "app/exercises/formulas/formula_plan.hpp"

#include <algorithm>
#include <set>

#include "lessons/formula/evaluate_formula.hpp"
#include "lessons/math/write_math.hpp"
#include "lessons/text/text.hpp"

namespace jw {

namespace {

using math::Row;

/// Two mistakes at once have this name, which is not a key of exercise files.
constexpr FormulaMistake kTwoTerms{
    kTwoTermsName, tr_later("two terms are wrong"), tr_later("{0} {1}"), "", nullptr};

void plan_in_formula(
    const FormulaMistake& mistake, const Row& formula, const std::vector<Row>& definitions,
    std::vector<PlannedMistake>& planned) {
    for (const Altered& altered : mistake.alter(formula)) {
        planned.push_back(
            {&mistake,
             {mistake.says, {altered.what}},
             math::write_latex(altered.row),
             altered.row,
             definitions});
    }
}

/// Adds mistakes made in a definition: the formula stays as it is.
void plan_in_definition(
    const FormulaMistake& mistake, std::size_t k, const Row& formula, const std::vector<Row>& definitions,
    std::vector<PlannedMistake>& planned) {
    const std::vector<Row> sides = formula::sides_of(definitions[k]);
    const Row equals = math::own_math("=");
    for (const Altered& altered : mistake.alter(sides.back())) {
        std::vector<Row> where = definitions;
        where[k] = sides.front();
        where[k].insert(where[k].end(), equals.begin(), equals.end());
        where[k].insert(where[k].end(), altered.row.begin(), altered.row.end());
        const std::string shown = math::write_latex(where[k]);
        const Message says = mistake.of_definition != nullptr
                                 ? Message{mistake.of_definition, {math::write_plain(sides.front())}}
                                 : Message{mistake.says, {altered.what}};
        planned.push_back({&mistake, says, shown, formula, std::move(where)});
    }
}

/// Adds a mistake at all of its places, in the formula and in its definitions.
void plan_mistake(
    const FormulaMistake& mistake, const Row& formula, const std::vector<Row>& definitions,
    std::vector<PlannedMistake>& planned) {
    plan_in_formula(mistake, formula, definitions, planned);
    for (std::size_t k = 0; k < definitions.size(); ++k) {
        plan_in_definition(mistake, k, formula, definitions, planned);
    }
}

bool is_in_terms(const FormulaMistake& mistake, const Exercise& exercise) {
    const std::string name = mistake.name;
    return (name == "term-sign" || name == "term-dropped") && looks_for(exercise, name);
}

std::string whole_latex(const PlannedMistake& planned) {
    std::string text = math::write_latex(planned.expression);
    for (const Row& definition : planned.where) { text += "\n" + math::write_latex(definition); }
    return text;
}

}  // namespace

FormulaPlan formula_plan(const Exercise& exercise) {
    FormulaPlan plan;
    const std::vector<Row> sides = formula::sides_of(math::read_math(exercise.formula).row);
    plan.asked = sides.front();
    plan.found = sides.back();
    for (const std::string& definition : exercise.where) {
        plan.where.push_back(math::read_math(definition).row);
    }
    for (const std::string& symbol : exercise.given) { plan.given.push_back(math::read_math(symbol).row); }
    for (const FormulaMistake& mistake : formula_mistakes()) {
        plan_mistake(mistake, plan.found, plan.where, plan.mistakes);
    }
    return plan;
}

bool looks_for(const Exercise& exercise, const std::string& mistake) {
    return exercise.only.empty() || std::ranges::find(exercise.only, mistake) != exercise.only.end();
}

FormulaPlan plan_of_two_terms(const FormulaPlan& plan, const Exercise& exercise) {
    FormulaPlan twice{plan.asked, plan.found, plan.where, plan.given, {}};
    std::set<std::string> known;
    for (const PlannedMistake& first : plan.mistakes) { known.insert(whole_latex(first)); }
    for (const PlannedMistake& first : plan.mistakes) {
        if (!is_in_terms(*first.mistake, exercise)) { continue; }
        std::vector<PlannedMistake> seconds;
        for (const FormulaMistake& mistake : formula_mistakes()) {
            if (is_in_terms(mistake, exercise)) {
                plan_mistake(mistake, first.expression, first.where, seconds);
            }
        }
        for (PlannedMistake& both : seconds) {
            if (!known.insert(whole_latex(both)).second) { continue; }
            both.says = {kTwoTerms.says, {tr(first.says), tr(both.says)}};
            both.mistake = &kTwoTerms;
            twice.mistakes.push_back(std::move(both));
        }
    }
    return twice;
}

}  // namespace jw
