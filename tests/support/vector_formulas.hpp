#pragma once

#include <array>
#include <charconv>
#include <string>
#include <utility>
#include <vector>

#include "core/jets/formula_equation.hpp"

/// Formulas of the vectors between two bodies as authors write them, text and steps together: the steps are
/// those that the text has when a lesson is read.
namespace jw::test::authored {

/// Part of a formula.
struct Part {
    enum class Form { factor, product, sum };

    std::string text;
    std::vector<FormulaStep> steps;
    Form form = Form::factor;

    /// Text as an operand beside which nothing looser than `loosest` may stand.
    std::string within(Form loosest) const { return form > loosest ? "(" + text + ")" : text; }
};

/// The shortest text that reads back, without an exponent.
inline std::string digits_of(double x) {
    std::array<char, 400> digits;
    return {
        digits.data(),
        std::to_chars(digits.data(), digits.data() + digits.size(), x, std::chars_format::fixed).ptr};
}
inline Part number(double x) {
    return {x < 0.0 ? "(" + digits_of(x) + ")" : digits_of(x), {{FormulaStep::Kind::number, x}}};
}

inline Part joined(std::string text, Part a, const Part& b, FormulaStep::Kind kind, Part::Form form) {
    a.text = std::move(text);
    a.steps.insert(a.steps.end(), b.steps.begin(), b.steps.end());
    a.steps.push_back({kind, 0.0});
    a.form = form;
    return a;
}
inline Part of_one(std::string text, Part a, const FormulaStep& step) {
    a.text = std::move(text);
    a.steps.push_back(step);
    a.form = Part::Form::factor;
    return a;
}

inline Part operator+(const Part& a, const Part& b) {
    return joined(
        a.text + " + " + b.within(Part::Form::product), a, b, FormulaStep::Kind::sum, Part::Form::sum);
}
inline Part operator-(const Part& a, const Part& b) {
    return joined(
        a.text + " - " + b.within(Part::Form::product), a, b, FormulaStep::Kind::difference, Part::Form::sum);
}
inline Part operator*(const Part& a, const Part& b) {
    return joined(
        a.within(Part::Form::product) + " " + b.within(Part::Form::factor), a, b, FormulaStep::Kind::product,
        Part::Form::product);
}
inline Part operator/(const Part& a, const Part& b) {
    return joined(
        "\\frac{" + a.text + "}{" + b.text + "}", a, b, FormulaStep::Kind::quotient, Part::Form::factor);
}
inline Part sine(const Part& a) { return of_one("\\sin(" + a.text + ")", a, {FormulaStep::Kind::sine, 0.0}); }
inline Part cosine(const Part& a) {
    return of_one("\\cos(" + a.text + ")", a, {FormulaStep::Kind::cosine, 0.0});
}
inline Part square_root(const Part& a) {
    return of_one("\\sqrt{" + a.text + "}", a, {FormulaStep::Kind::square_root, 0.0});
}
/// @param n  neither 0.5 nor 1
inline Part power(const Part& a, double n) {
    return of_one("(" + a.text + ")^{" + digits_of(n) + "}", a, {FormulaStep::Kind::power, n});
}

/// Name of a vector, or that of the matrix of which it is a column.
struct Name {
    std::string letter;
    std::string index;  ///< "i", "j", none for d
    std::string mark;   ///< "P" or none
    int column = -1;    ///< of a matrix
};
inline Name name_of(FormulaVector vector) {
    using enum FormulaVector;
    switch (vector) {
        case s_i: return {"s", "i", "", -1};
        case s_j: return {"s", "j", "", -1};
        case u_i: return {"u", "i", "", -1};
        case u_j: return {"u", "j", "", -1};
        case d: return {"d", "", "", -1};
        case r_i: return {"r", "i", "", -1};
        case r_j: return {"r", "j", "", -1};
        case r_i_P: return {"r", "i", "P", -1};
        case r_j_P: return {"r", "j", "P", -1};
        case A_i_x:
        case A_i_y:
        case A_i_z: return {"A", "i", "", static_cast<int>(vector) - static_cast<int>(A_i_x)};
        case A_j_x:
        case A_j_y:
        case A_j_z: break;
    }
    return {"A", "j", "", static_cast<int>(vector) - static_cast<int>(A_j_x)};
}

/// \mathbf{s}_i, \mathbf{r}_j^P; a column as its matrix times a vector with a 1.
inline Part text_of(FormulaVector vector, bool transposed = false) {
    const Name name = name_of(vector);
    const std::string letter = "\\mathbf{" + name.letter + "}" + (name.index.empty() ? "" : "_" + name.index);
    if (name.column < 0) {
        const std::string above = name.mark + (transposed ? name.mark.empty() ? "T" : " T" : "");
        return {letter + (above.empty() ? "" : above.size() == 1 ? "^" + above : "^{" + above + "}"), {}};
    }
    std::string column;
    for (int k = 0; k < 3; ++k) {
        column += (k > 0 ? " \\\\ " : "") + std::string(k == name.column ? "1" : "0");
    }
    const std::string text = letter + " \\begin{bmatrix} " + column + " \\end{bmatrix}";
    if (transposed) { return {"(" + text + ")^T", {}}; }
    return {text, {}, Part::Form::product};
}

inline FormulaStep step_of(FormulaVector vector, int component) {
    return {FormulaStep::Kind::variable, static_cast<double>(variable_of(vector, component))};
}

/// Component of a vector that is no column.
inline Part component(FormulaVector vector, int k) {
    const Name name = name_of(vector);
    const std::string axis(1, "xyz"[k]);
    return {
        name.letter + "_{" + axis + name.index + "}" + (name.mark.empty() ? "" : "^" + name.mark),
        {step_of(vector, k)}};
}

/// aᵀ b
inline Part dot(FormulaVector a, FormulaVector b) {
    Part out{text_of(a, true).text + " " + text_of(b).within(Part::Form::factor), {}, Part::Form::product};
    for (int k = 0; k < 3; ++k) {
        out.steps.insert(out.steps.end(), {step_of(a, k), step_of(b, k), {FormulaStep::Kind::product, 0.0}});
        if (k > 0) { out.steps.push_back({FormulaStep::Kind::sum, 0.0}); }
    }
    return out;
}

/// The equation of an author: left = right.
inline ScalarFormula equation(const Part& left, double right) {
    ScalarFormula out{left.text + " = " + number(right).text, left.steps};
    if (right != 0.0) {
        out.steps.push_back({FormulaStep::Kind::number, right});
        out.steps.push_back({FormulaStep::Kind::difference, 0.0});
    }
    return out;
}

/// A formula of every vector, with a value at any poses where s_i and s_j are at most 2 long.
/// @param by  a number that changes it
inline Part of_all_vectors(double by) {
    using enum FormulaVector;
    return dot(s_i, s_j) * sine(number(0.5) * component(d, 0)) + square_root(number(20.0) + dot(d, d)) +
           dot(u_i, A_j_y) / (number(5.0) + power(dot(u_j, A_i_z), 2.0)) -
           number(0.125) * power(number(6.0) + dot(s_i, u_j), 1.5) + number(0.25) * dot(r_i, r_j_P) +
           (dot(A_i_x, A_j_z) - component(r_j, 1)) * number(by) +
           cosine(number(0.25) * component(r_i_P, 2)) * dot(A_i_y, A_j_x);
}

}  // namespace jw::test::authored
