#include "lessons/formula/value.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/eigen/decompositions.hpp"
#include "core/elementary/elementary.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::formula {

namespace {

using Kind = Value::Kind;

// the highest power that is computed by repeated products: no formula has a higher one
constexpr double kHighestPower = 100.0;
// rounding of a square that should be zero, relative to its terms
constexpr double kRounding = 1e-12;

/// A derivative by the chain rule; it is zero for an argument at rest, however steep the function is.
double chained(double slope, double rate) { return rate == 0.0 ? 0.0 : slope * rate; }

/// Limits the scale of a function that is as steep as x^n at 0: an error d of its argument changes it by at
/// most d^n.
void limit_scale(Value& out, const Value& argument, double n) {
    const double share = known_share(argument);
    const double most = elementary::pow(share * argument.scale[0], n) / share;
    out.scale[0] = std::max(std::abs(out.d[0](0, 0)), std::min(out.scale[0], most));
}

/// @param name  of the function that is computed with it
Value arc_cosine(const Value& a, const std::string& name) {
    const double x = a.d[0](0, 0);
    if (std::abs(x) > 1.0 + kRounding * a.scale[0]) {
        throw NoValue(name + " is taken of a number that is not between -1 and 1");
    }
    const double s = std::sqrt(std::max(0.0, 1.0 - x * x));
    Value out = function_of(a, elementary::acos(std::clamp(x, -1.0, 1.0)), -1.0 / s, -x / (s * s * s));
    limit_scale(out, a, 0.5);
    return out;
}

Value rank(const Value& x) {
    Eigen::ColPivHouseholderQR<MatrixX> qr(x.d[0]);
    // entries are about 1 and known to 15 digits
    qr.setThreshold(1e-9);
    return number(static_cast<double>(qr.rank()));
}

/// The number of the component with the largest or smallest absolute value, from 1.
Value place_of_extreme(const Value& x, bool largest) {
    if (!x.is_vector()) {
        throw Mismatch("a component is chosen of " + shape_text(x) + "; expected a vector");
    }
    Eigen::Index place = 0;
    const VectorX sizes = x.d[0].col(0).cwiseAbs();
    if (largest) {
        sizes.maxCoeff(&place);
    } else {
        sizes.minCoeff(&place);
    }
    Value found = number(static_cast<double>(place + 1));
    found.order = 0;
    return found;
}

}  // namespace

Value function_of(const Value& a, double value, double first, double second) {
    if (a.rows() != 1 || a.cols() != 1) {
        throw Mismatch("a function is taken of " + shape_text(a) + "; expected a number");
    }
    const auto as_matrix = [](double x) -> MatrixX { return MatrixX::Constant(1, 1, x); };
    const double rate = a.order >= 1 ? a.d[1](0, 0) : 0.0;
    const double acceleration = a.order >= 2 ? a.d[2](0, 0) : 0.0;
    Value out = moving(
        as_matrix(value), as_matrix(chained(first, rate)),
        as_matrix(chained(second * rate, rate) + chained(first, acceleration)), a.order);
    out.is_literal = a.is_literal;
    // an argument that is a small difference of large terms passes on its rounding
    out.scale[0] = std::max(out.scale[0], std::abs(first) * a.scale[0]);
    out.scale[1] =
        std::max({out.scale[1], std::abs(first) * a.scale[1], std::abs(second * rate) * a.scale[0]});
    out.scale[2] =
        std::max({out.scale[2], std::abs(first) * a.scale[2], std::abs(second * rate) * a.scale[1]});
    return out;
}

Value power(const Value& a, double n) {
    const bool whole = n == std::floor(n);
    if (a.kind == Kind::zero) {
        if (n < 0.0) { throw NoValue("it is divided by zero"); }
        return n > 0.0 ? a : literal(1.0);
    }
    if (a.kind == Kind::identity || a.is_number()) {
        const double x = a.d[0](0, 0);
        if (x == 0.0 && n < 0.0) { throw NoValue("it is divided by zero"); }
        if (x < 0.0 && !whole) {
            throw NoValue("the power " + writing::number_text(n) + " of a negative number is taken");
        }
        const auto term = [x](double factor, double power) {
            return factor == 0.0 ? 0.0 : factor * elementary::pow(x, power);
        };
        Value out = function_of(a, elementary::pow(x, n), term(n, n - 1.0), term(n * (n - 1.0), n - 2.0));
        out.kind = a.kind;
        if (n > 0.0 && n < 1.0) { limit_scale(out, a, n); }
        return out;
    }
    if (n == -1.0) { return inverse(a); }
    if (!whole || n < 1.0 || n > kHighestPower) {
        throw Mismatch("the power " + writing::number_text(n) + " of " + shape_text(a));
    }
    Value out = a;
    for (int k = 1; k < static_cast<int>(n); ++k) { out = product(out, a); }
    return out;
}

Value square_root(const Value& a) {
    if (a.kind == Kind::zero) { return a; }
    if (!a.is_number()) { throw Mismatch("a root is taken of " + shape_text(a) + "; expected a number"); }
    const double x = a.d[0](0, 0);
    if (x < -kRounding * a.scale[0]) { throw NoValue("a root is taken of a negative number"); }
    const double r = std::sqrt(std::max(x, 0.0));
    Value out = function_of(a, r, 0.5 / r, -0.25 / (r * r * r));
    limit_scale(out, a, 0.5);
    return out;
}

Value length(const Value& a) {
    if (a.kind == Kind::zero) { return a; }
    if (a.kind != Kind::matrix) {
        throw Mismatch("the size of I is not known inside |...|; expected a vector");
    }
    if (a.is_number()) {
        const double x = a.d[0](0, 0);
        return function_of(a, std::abs(x), x < 0.0 ? -1.0 : 1.0, 0.0);
    }
    if (a.cols() != 1) { throw Mismatch("the length of " + shape_text(a) + " is taken; expected a vector"); }
    return square_root(product(transposed(a), a));
}

Value as_number(const Value& a) { return a.kind == Kind::zero ? literal(0.0) : a; }

Value arc_tangent_of_two(const Value& y, const Value& x) {
    if (!x.is_number() || !y.is_number()) { throw Mismatch("atan2 takes two numbers"); }
    Value angle = number(elementary::atan2(y.d[0](0, 0), x.d[0](0, 0)));
    angle.order = 0;
    return angle;
}

std::optional<Value> value_of_function(const std::string& name, const Value& argument) {
    const Value x = as_number(argument);
    if (name == "det") { return determinant(x); }
    if (name == "rank") { return rank(x); }
    if (name == "largest" || name == "smallest") { return place_of_extreme(x, name == "largest"); }
    if (!x.is_number()) { throw Mismatch(name + " is taken of " + shape_text(x) + "; expected a number"); }
    const double v = x.d[0](0, 0);
    const auto [sine, cosine] = elementary::sine_and_cosine(v);
    if (name == "sin") { return function_of(x, sine, cosine, -sine); }
    if (name == "cos") { return function_of(x, cosine, -sine, -cosine); }
    const double t = elementary::tan(v);
    if (name == "tan") { return function_of(x, t, 1.0 + t * t, 2.0 * t * (1.0 + t * t)); }
    if (name == "arctan") {
        const double q = 1.0 / (1.0 + v * v);
        return function_of(x, elementary::atan(v), q, -2.0 * v * q * q);
    }
    if (name == "arccos") { return arc_cosine(x, name); }
    if (name == "arcsin") { return difference(literal(0.5 * std::numbers::pi), arc_cosine(x, name)); }
    if (name == "exp") {
        const double e = elementary::exp(v);
        if (!std::isfinite(e)) { throw NoValue("the result of exp is too large"); }
        return function_of(x, e, e, e);
    }
    if (name == "ln") {
        if (v <= 0.0) { throw NoValue("a logarithm is taken of a number that is not positive"); }
        return function_of(x, elementary::log(v), 1.0 / v, -1.0 / (v * v));
    }
    return std::nullopt;
}

}  // namespace jw::formula
