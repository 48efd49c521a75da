#include "lessons/formula/steps_of_formula.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include "core/jets/formula_equation.hpp"
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
    static Term unit_matrix() { throw Mismatch("this formula can contain only numbers, not a unit matrix"); }
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
    if (!std::isfinite(number)) { throw NoValue("this number is not finite"); }
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
    throw Mismatch(std::string("this formula can contain only numbers, not ") + what);
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

/// Operations on vectors and matrices of such parts, for Evaluator.
namespace of_vectors {

namespace {

using of_numbers::Term;

Term plus(const Term& a, const Term& b) {
    const auto is_zero = [](const Term& x) { return x.is_literal && x.written_number() == 0.0; };
    return is_zero(a) ? b : is_zero(b) ? a : of_numbers::sum(a, b);
}
Term times(const Term& a, const Term& b) {
    const auto is = [](const Term& x, double number) { return x.is_literal && x.written_number() == number; };
    if (is(a, 0.0) || is(b, 0.0)) { return Term::written(0.0); }
    return is(a, 1.0) ? b : is(b, 1.0) ? a : of_numbers::product(a, b);
}

/// A number, a vector or a matrix.
struct Entries {
    Eigen::Index rows = 1;
    Eigen::Index cols = 1;
    std::vector<Term> all;  ///< row by row
    bool is_literal = false;

    const Term& at(Eigen::Index row, Eigen::Index col) const {
        return all[static_cast<std::size_t>(row * cols + col)];
    }
    bool is_number() const { return rows == 1 && cols == 1; }
    bool is_vector() const { return rows == 3 && cols == 1; }
    double written_number() const { return all.front().written_number(); }

    template <class F>
    static Entries built(Eigen::Index rows, Eigen::Index cols, F&& entry) {
        Entries out{rows, cols, {}, true};
        for (Eigen::Index r = 0; r < rows; ++r) {
            for (Eigen::Index c = 0; c < cols; ++c) { out.all.push_back(entry(r, c)); }
        }
        out.is_literal = std::ranges::all_of(out.all, &Term::is_literal);
        return out;
    }
    static Entries number(const Term& term) {
        return built(1, 1, [&](auto, auto) { return term; });
    }
    static Entries written(double x) { return number(Term::written(x)); }
    static Entries unit_matrix() {
        return built(3, 3, [](auto r, auto c) { return Term::written(r == c ? 1.0 : 0.0); });
    }
};

std::string shape_text(const Entries& a) {
    return a.is_number() ? "a number" : std::to_string(a.rows) + " x " + std::to_string(a.cols);
}

const Term& number_of(const Entries& a, const std::string& what) {
    if (!a.is_number()) { throw Mismatch(what + " is taken of " + shape_text(a) + "; expected a number"); }
    return a.all.front();
}
void require_vectors(const Entries& a, const Entries& b) {
    for (const Entries* x : {&a, &b}) {
        if (x->is_vector()) { continue; }
        throw Mismatch("a cross product is taken of " + shape_text(*x) + "; expected a vector of three");
    }
}

template <class F>
Entries by_entry(const Entries& a, const Entries& b, F&& operation) {
    if (a.rows != b.rows || a.cols != b.cols) {
        throw Mismatch(shape_text(a) + " and " + shape_text(b) + " are added");
    }
    return Entries::built(a.rows, a.cols, [&](auto r, auto c) { return operation(a.at(r, c), b.at(r, c)); });
}
template <class F>
Entries by_entry(const Entries& a, F&& operation) {
    return Entries::built(a.rows, a.cols, [&](auto r, auto c) { return operation(a.at(r, c)); });
}

Entries sum(const Entries& a, const Entries& b) { return by_entry(a, b, plus); }
Entries negative(const Entries& a) { return by_entry(a, of_numbers::negative); }
Entries difference(const Entries& a, const Entries& b) {
    return by_entry(a, b, [](const Term& x, const Term& y) {
        return y.is_literal && y.written_number() == 0.0 ? x : of_numbers::difference(x, y);
    });
}

Entries product(const Entries& a, const Entries& b) {
    if (a.is_number()) {
        return by_entry(b, [&](const Term& x) { return times(a.all.front(), x); });
    }
    if (b.is_number()) {
        return by_entry(a, [&](const Term& x) { return times(x, b.all.front()); });
    }
    if (a.cols != b.rows) { throw Mismatch(shape_text(a) + " is multiplied by " + shape_text(b)); }
    return Entries::built(a.rows, b.cols, [&](auto r, auto c) {
        Term out = Term::written(0.0);
        for (Eigen::Index k = 0; k < a.cols; ++k) { out = plus(out, times(a.at(r, k), b.at(k, c))); }
        return out;
    });
}

Entries transposed(const Entries& a) {
    return Entries::built(a.cols, a.rows, [&](auto r, auto c) { return a.at(c, r); });
}
Entries dot(const Entries& a, const Entries& b) {
    return product(a.is_vector() && b.is_vector() ? transposed(a) : a, b);
}
Entries skew(const Entries& a) {
    require_vectors(a, a);
    return Entries::built(3, 3, [&](auto r, auto c) {
        if (r == c) { return Term::written(0.0); }
        const Term& x = a.at(3 - r - c, 0);
        return (c - r + 3) % 3 == 1 ? of_numbers::negative(x) : x;
    });
}
Entries cross(const Entries& a, const Entries& b) {
    require_vectors(a, b);
    return product(skew(a), b);
}

Entries quotient(const Entries& a, const Entries& b) {
    const Term& below = number_of(b, "a quotient");
    return by_entry(a, [&](const Term& x) { return of_numbers::quotient(x, below); });
}
Entries square_root(const Entries& a) {
    return Entries::number(of_numbers::square_root(number_of(a, "a root")));
}
Entries power(const Entries& a, double n) {
    return Entries::number(of_numbers::power(number_of(a, "a power"), n));
}
Entries length(const Entries& a) {
    if (a.is_number()) { return Entries::number(of_numbers::length(a.all.front())); }
    return square_root(dot(a, a));
}
Entries component(const Entries& a, Eigen::Index row) { return Entries::number(a.at(row, 0)); }
Entries as_number(const Entries& a) { return a; }

Entries stacked(const std::vector<std::vector<Entries>>& blocks) {
    const auto cols = blocks.empty() ? 0 : static_cast<Eigen::Index>(blocks.front().size());
    return Entries::built(static_cast<Eigen::Index>(blocks.size()), cols, [&](auto r, auto c) {
        const auto& row = blocks[static_cast<std::size_t>(r)];
        if (static_cast<Eigen::Index>(row.size()) != cols) { throw Mismatch("the rows differ in length"); }
        return number_of(row[static_cast<std::size_t>(c)], "an entry of a matrix");
    });
}

std::optional<Entries> value_of_function(const std::string& name, const Entries& argument) {
    const auto value = of_numbers::value_of_function(name, number_of(argument, name));
    return value ? std::optional(Entries::number(*value)) : std::nullopt;
}
Entries arc_tangent_of_two(const Entries& y, const Entries& x) {
    return Entries::number(of_numbers::arc_tangent_of_two(number_of(y, "atan2"), number_of(x, "atan2")));
}
Entries minus_operator(const Entries& /*a*/) {
    throw Mismatch("the formula of a joint cannot contain a bar");
}
Entries derivative(const Entries& /*a*/) {
    throw Mismatch(
        "the formula of a joint cannot contain a derivative; expected positions and directions only");
}

Entries vector(FormulaVector v) {
    return Entries::built(
        3, 1, [&](auto r, auto) { return of_numbers::variable(variable_of(v, static_cast<int>(r)), -1); });
}

/// A symbol that a formula of a joint may contain, with its entries.
struct Meaning {
    Symbol symbol;
    Entries value;
};

std::vector<Meaning> meanings() {
    using enum FormulaVector;
    std::vector<Meaning> all{{{"d", 0, {}, {}}, vector(d)}};
    const auto of_body = [&](const std::string& index, FormulaVector s, FormulaVector u, FormulaVector r,
                             FormulaVector P, FormulaVector x) {
        all.push_back({{"s", 0, {}, index}, vector(s)});
        all.push_back({{"u", 0, {}, index}, vector(u)});
        all.push_back({{"r", 0, {}, index}, vector(r)});
        all.push_back({{"r", 0, "P", index}, vector(P)});
        all.push_back({{"s", 0, "P", index}, difference(vector(P), vector(r))});
        all.push_back({{"A", 0, {}, index}, Entries::built(3, 3, [&](auto row, auto col) {
                           const auto column = static_cast<FormulaVector>(static_cast<int>(x) + col);
                           return of_numbers::variable(variable_of(column, static_cast<int>(row)), -1);
                       })});
    };
    of_body("i", s_i, u_i, r_i, r_i_P, A_i_x);
    of_body("j", s_j, u_j, r_j, r_j_P, A_j_x);
    return all;
}

std::optional<Entries> meaning_of(const Symbol& symbol) {
    static const std::vector<Meaning> all = meanings();
    if (symbol == Symbol{"t", 0, {}, {}}) {
        throw Mismatch("the formula of a joint cannot contain the time t; a driver prescribes a motion");
    }
    const auto found = std::ranges::find(all, symbol, &Meaning::symbol);
    return found == all.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace

}  // namespace of_vectors

ScalarFormula constraint_formula(const std::string& source) {
    const math::Reading reading = math::read_math(source);
    if (reading.problem) { throw NotEvaluated(*reading.problem); }
    const std::vector<math::Row> sides = sides_of(reading.row);
    if (sides.size() > 2) { throw NotEvaluated({0, "it has more than one =; expected one equation", ""}); }
    const MeaningsOf<of_vectors::Entries> meanings{of_vectors::meaning_of, {}};
    const Evaluator<of_vectors::Entries> evaluator(meanings);
    of_vectors::Entries phi = evaluator.expression(sides.front());
    try {
        if (sides.size() == 2) { phi = difference(phi, evaluator.expression(sides.back())); }
    } catch (const Mismatch& mismatch) { throw NotEvaluated({0, mismatch.what(), ""}); }
    if (!phi.is_number()) {
        throw NotEvaluated(
            {0, "its value is " + of_vectors::shape_text(phi) + "; expected one number",
             "write a dot product, or a component such as s_{xi}; a joint has one equation"});
    }
    ScalarFormula formula{source, phi.all.front().steps};
    if (!formula.uses_any(0, 3 * static_cast<int>(kFormulaVectors))) {
        throw NotEvaluated({0, "it does not depend on the pose of its bodies", ""});
    }
    return formula;
}

std::span<const Variable> time_only() {
    static const std::array variables{Variable{Symbol{"t", 0, {}, {}}, 0, -1}};
    return variables;
}

ScalarFormula scalar_formula(
    const std::string& source, std::span<const Variable> variables,
    const std::function<std::optional<int>(const std::string& name)>& quantities) {
    const math::Reading reading = math::read_math(source);
    if (reading.problem) { throw NotEvaluated(*reading.problem); }
    const auto meaning = [&](const Symbol& symbol) -> std::optional<of_numbers::Term> {
        const auto found = std::ranges::find(variables, symbol, &Variable::symbol);
        if (found == variables.end()) { return std::nullopt; }
        return of_numbers::variable(found->index, found->rate);
    };
    const auto quantity = [&](const std::string& name) -> std::optional<of_numbers::Term> {
        const auto index = quantities ? quantities(name) : std::nullopt;
        return index ? std::optional(of_numbers::variable(*index, -1)) : std::nullopt;
    };
    return {source, Evaluator<of_numbers::Term>({meaning, quantity}).expression(reading.row).steps};
}

}  // namespace jw::formula
