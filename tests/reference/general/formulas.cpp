#include "tests/reference/general/measures.hpp"

namespace jw::reference::general {

namespace {

/// f(a), whose derivatives by a are given.
Taylor chain(const Taylor& a, Real f, Real first, Real second) {
    return {f, first * a.rate, second * a.rate * a.rate + first * a.second};
}

Taylor reciprocal(const Taylor& a) {
    const Real x = 1.0L / a.value;
    return chain(a, x, -x * x, 2.0L * x * x * x);
}

}  // namespace

Taylor value_of(const FormulaTree& f, const std::vector<Taylor>& variables) {
    if (f.operation == "number") { return {f.number}; }
    if (f.operation == "variable") { return variables.at(static_cast<std::size_t>(f.number)); }
    const Taylor a = value_of(f.of.at(0), variables);
    const Real x = a.value;
    if (f.of.size() == 2) {
        const Taylor b = value_of(f.of[1], variables);
        if (f.operation == "+") { return a + b; }
        if (f.operation == "-") { return a - b; }
        return f.operation == "*" ? a * b : a * reciprocal(b);
    }
    if (f.operation == "negative" || (f.operation == "abs" && x < 0.0L)) { return -1.0L * a; }
    if (f.operation == "abs") { return a; }
    if (f.operation == "power") {
        const Real n = f.number;
        const auto term = [&](Real k, Real m) { return k == 0.0L ? 0.0L : k * std::pow(x, m); };
        return chain(a, std::pow(x, n), term(n, n - 1.0L), term(n * (n - 1.0L), n - 2.0L));
    }
    const Real s = std::sin(x);
    const Real c = std::cos(x);
    if (f.operation == "sin") { return chain(a, s, c, -s); }
    if (f.operation == "cos") { return chain(a, c, -s, -c); }
    if (f.operation == "tan") { return chain(a, s / c, 1.0L / (c * c), 2.0L * s / (c * c * c)); }
    if (f.operation == "exp") { return chain(a, std::exp(x), std::exp(x), std::exp(x)); }
    if (f.operation == "ln") { return chain(a, std::log(x), 1.0L / x, -1.0L / (x * x)); }
    if (f.operation == "sqrt") {
        const Real r = std::sqrt(x);
        return chain(a, r, 0.5L / r, -0.25L / (r * x));
    }
    if (f.operation == "arctan") {
        const Real q = 1.0L / (1.0L + x * x);
        return chain(a, std::atan(x), q, -2.0L * x * q * q);
    }
    const Real q = 1.0L - x * x;
    const Real slope = (f.operation == "arcsin" ? 1.0L : -1.0L) / std::sqrt(q);
    return chain(a, f.operation == "arcsin" ? std::asin(x) : std::acos(x), slope, slope * x / q);
}

}  // namespace jw::reference::general
