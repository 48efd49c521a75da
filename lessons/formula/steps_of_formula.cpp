#include "lessons/formula/steps_of_formula.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include "lessons/formula/evaluator.hpp"

namespace jw::formula {

/// Operations on parts of a formula of numbers, for Evaluator.
namespace of_numbers {

namespace {

using Kind = FormulaStep::Kind;

/// Part of a formula: a written number, a variable, or the steps that compute it.
struct Term {
    std::vector<FormulaStep> steps;
    std::size_t depth = 1;  ///< numbers on the stack at once
    bool is_literal = false;
    int rate = -1;  ///< of a variable: index of its rate

    bool is_number() const { return true; }
    bool is_vector() const { return false; }
    double written_number() const { return steps.front().number; }

    static Term written(double number) { return {{{Kind::number, number}}, 1, true, -1}; }
    static Term unit_matrix() { throw Mismatch("a unit matrix stands in a formula of numbers"); }
};

/// Largest number of steps: more are data, not a formula.
constexpr std::size_t kMostSteps = 400;

Term with_step(Term a, FormulaStep step) {
    a.steps.push_back(step);
    a.is_literal = false;
    a.rate = -1;
    if (a.steps.size() > kMostSteps) { throw Mismatch("the formula is too long; expected fewer operations"); }
    return a;
}

Term with_step(Term a, const Term& b, Kind kind) {
    a.steps.insert(a.steps.end(), b.steps.begin(), b.steps.end());
    a.depth = std::max(a.depth, b.depth + 1);
    if (a.depth > ScalarFormula::kDeepest) { throw Mismatch("the formula is nested too deeply"); }
    return with_step(std::move(a), {kind, 0.0});
}

Term computed(double number) {
    if (!std::isfinite(number)) { throw NoValue("this number does not exist"); }
    return Term::written(number);
}

Term sum(const Term& a, const Term& b) {
    if (a.is_literal && b.is_literal) { return computed(a.written_number() + b.written_number()); }
    return with_step(a, b, Kind::sum);
}
Term difference(const Term& a, const Term& b) {
    if (a.is_literal && b.is_literal) { return computed(a.written_number() - b.written_number()); }
    return with_step(a, b, Kind::difference);
}
Term negative(const Term& a) {
    return a.is_literal ? computed(-a.written_number()) : with_step(a, {Kind::negative, 0.0});
}
Term product(const Term& a, const Term& b) {
    if (a.is_literal && b.is_literal) { return computed(a.written_number() * b.written_number()); }
    return with_step(a, b, Kind::product);
}
Term dot(const Term& a, const Term& b) { return product(a, b); }
Term quotient(const Term& a, const Term& b) {
    if (b.is_literal && b.written_number() == 0.0) { throw NoValue("it is divided by zero"); }
    if (a.is_literal && b.is_literal) { return computed(a.written_number() / b.written_number()); }
    return with_step(a, b, Kind::quotient);
}

Term square_root(const Term& a) {
    return a.is_literal ? computed(std::sqrt(a.written_number())) : with_step(a, {Kind::square_root, 0.0});
}

Term power(const Term& a, double n) {
    if (a.is_literal) { return computed(elementary::pow(a.written_number(), n)); }
    if (std::abs(n) > FormulaStep::kHighestPower) { throw Mismatch("a power beyond 100"); }
    return n == 0.5 ? square_root(a) : with_step(a, {Kind::power, n});
}

Term as_number(const Term& a) { return a; }

[[noreturn]] Term refuse(const char* what) {
    throw Mismatch(std::string(what) + " stands in a formula of numbers");
}
Term cross(const Term& /*a*/, const Term& /*b*/) { refuse("a product × of vectors"); }
Term transposed(const Term& /*a*/) { refuse("a transpose"); }
Term skew(const Term& /*a*/) { refuse("a tilde"); }
Term minus_operator(const Term& /*a*/) { refuse("a bar"); }
Term variable(int index, int rate) {
    return {{{Kind::variable, static_cast<double>(index)}}, 1, false, rate};
}
Term derivative(const Term& a) { return a.rate >= 0 ? variable(a.rate, -1) : refuse("a derivative"); }
Term stacked(const std::vector<std::vector<Term>>& /*blocks*/) { refuse("a matrix"); }
Term component(const Term& /*a*/, Eigen::Index /*row*/) { refuse("a component"); }
Term length(const Term& a) {
    return a.is_literal ? computed(std::abs(a.written_number())) : with_step(a, {Kind::absolute, 0.0});
}
Term arc_tangent_of_two(const Term& /*y*/, const Term& /*x*/) {
    throw Mismatch("atan2 jumps by a turn; expected arctan");
}

struct FunctionName {
    std::string_view name;
    Kind kind;
};
constexpr std::array kNames{
    FunctionName{"sin", Kind::sine},          FunctionName{"cos", Kind::cosine},
    FunctionName{"tan", Kind::tangent},       FunctionName{"arcsin", Kind::arc_sine},
    FunctionName{"arccos", Kind::arc_cosine}, FunctionName{"arctan", Kind::arc_tangent},
    FunctionName{"exp", Kind::exponential},   FunctionName{"ln", Kind::logarithm}};

std::optional<Term> value_of_function(const std::string& name, const Term& argument) {
    const auto* const found = std::ranges::find(kNames, name, &FunctionName::name);
    if (found == kNames.end()) { return std::nullopt; }
    return with_step(argument, {found->kind, 0.0});
}

}  // namespace

}  // namespace of_numbers

std::span<const Variable> time_only() {
    static const std::array variables{Variable{Symbol{"t", 0, {}, {}}, 0, -1}};
    return variables;
}

ScalarFormula scalar_formula(const std::string& source, std::span<const Variable> variables) {
    const math::Reading reading = math::read_math(source);
    if (reading.problem) { throw NotEvaluated(*reading.problem); }
    const auto meaning = [&](const Symbol& symbol) -> std::optional<of_numbers::Term> {
        const auto found = std::ranges::find(variables, symbol, &Variable::symbol);
        if (found == variables.end()) { return std::nullopt; }
        return of_numbers::variable(found->index, found->rate);
    };
    return {source, Evaluator<of_numbers::Term>({meaning, {}}).expression(reading.row).steps};
}

}  // namespace jw::formula
