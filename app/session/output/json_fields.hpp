#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/session/output/json.hpp"
#include "core/jets/formula_equation.hpp"
#include "lessons/lesson/enum_words.hpp"

/// Fields of a primitive (`for_each_field`) as JSON, for inspections and proofs.
namespace jw {

inline Json field(double value) { return number(value); }
inline Json field(bool value) { return value; }
inline Json field(const Vec3& value) { return json_of(value); }
inline Json field(ScrewAngleForm form) { return word_of(kAngleRows, form); }
inline Json field(WheelLine line) { return std::string(name_of(line)); }
inline Json field(const std::vector<std::array<double, 2>>& pairs) {
    return list_of(pairs, [](const auto& pair) -> Json { return {number(pair[0]), number(pair[1])}; });
}

/// Step of a formula: a number, or the name of a variable or an operation; a power with its exponent.
/// @param name_of  name of the variable with an index
template <class F>
Json step_json(const FormulaStep& step, F&& name_of) {
    using Kind = FormulaStep::Kind;
    switch (step.kind) {
        case Kind::number: return step.number;
        case Kind::variable: return name_of(static_cast<int>(step.number));
        case Kind::sum: return "+";
        case Kind::difference: return "-";
        case Kind::product: return "*";
        case Kind::quotient: return "/";
        case Kind::negative: return "negative";
        case Kind::power: return Json::array({"power", step.number});
        case Kind::sine: return "sin";
        case Kind::cosine: return "cos";
        case Kind::tangent: return "tan";
        case Kind::arc_sine: return "arcsin";
        case Kind::arc_cosine: return "arccos";
        case Kind::arc_tangent: return "arctan";
        case Kind::exponential: return "exp";
        case Kind::logarithm: return "ln";
        case Kind::square_root: return "sqrt";
        case Kind::absolute: return "abs";
    }
    return {};
}

/// Steps of a formula of vectors; component x of s_i is "s_i.x".
inline Json field(const ScalarFormula& formula) {
    constexpr std::array<const char*, kFormulaVectors> vectors{"s_i",   "s_j",   "u_i",   "u_j",   "d",
                                                               "r_i",   "r_j",   "r_i_P", "r_j_P", "A_i.x",
                                                               "A_i.y", "A_i.z", "A_j.x", "A_j.y", "A_j.z"};
    const auto name_of_variable = [&](int variable) {
        return std::string(vectors[at(variable / 3)]) + "." + "xyz"[variable % 3];
    };
    return list_of(formula.steps, [&](const FormulaStep& step) { return step_json(step, name_of_variable); });
}

}  // namespace jw
