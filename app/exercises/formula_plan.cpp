#include "app/exercises/formula_plan.hpp"

#include "lessons/formula/evaluate_formula.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

using math::Row;

void plan_in_formula(const FormulaMistake& mistake, FormulaPlan& plan) {
    for (const Altered& altered : mistake.alter(plan.found)) {
        plan.mistakes.push_back(
            {&mistake,
             {mistake.says, {altered.what}},
             math::write_latex(altered.row),
             altered.row,
             plan.where});
    }
}

/// Mistakes made in a definition: the formula stays as it is.
void plan_in_definition(const FormulaMistake& mistake, std::size_t k, FormulaPlan& plan) {
    const std::vector<Row> sides = formula::sides_of(plan.where[k]);
    const Row equals = math::own_math("=");
    for (const Altered& altered : mistake.alter(sides.back())) {
        std::vector<Row> where = plan.where;
        where[k] = sides.front();
        where[k].insert(where[k].end(), equals.begin(), equals.end());
        where[k].insert(where[k].end(), altered.row.begin(), altered.row.end());
        const std::string shown = math::write_latex(where[k]);
        const Message says = mistake.of_definition != nullptr
                                 ? Message{mistake.of_definition, {math::write_plain(sides.front())}}
                                 : Message{mistake.says, {altered.what}};
        plan.mistakes.push_back({&mistake, says, shown, plan.found, std::move(where)});
    }
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
        plan_in_formula(mistake, plan);
        for (std::size_t k = 0; k < plan.where.size(); ++k) { plan_in_definition(mistake, k, plan); }
    }
    return plan;
}

}  // namespace jw
