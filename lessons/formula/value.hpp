#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// Numbers, vectors and matrices of a formula, each with its first and second time derivative. The product
/// rule is applied here, so that a dot in a formula is a true derivative.
namespace jw::formula {

/// Accuracy of a value of the motion relative to its largest term: poses are assembled to 1e-13, and
/// velocities are solved to some digits less. A wrong sign, dot or index changes a formula by about the size
/// of its terms.
constexpr double kKnown = 1e-9;

/// Error: the shapes do not fit, or a derivative is not known.
class Mismatch : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Error: a function does not have a value there, as for a division by zero or a root of a negative number.
class NoValue : public Mismatch {
public:
    using Mismatch::Mismatch;
};

struct Value {
    enum class Kind {
        matrix,
        zero,      ///< of any shape
        identity,  ///< of any size, times the 1x1 matrix in `d`
    };
    Kind kind = Kind::matrix;
    int order = 2;                ///< derivatives that are known: 0, 1 or 2
    std::array<MatrixX, 3> d;     ///< value, rate, acceleration
    std::array<double, 3> scale;  ///< largest term of the sum that gives each; rounding is relative to it
    bool is_literal = false;      ///< made of written numbers only: its only error is rounding

    Eigen::Index rows() const { return d[0].rows(); }
    Eigen::Index cols() const { return d[0].cols(); }
    bool is_number() const { return kind == Kind::matrix && rows() == 1 && cols() == 1; }
    bool is_vector() const { return kind == Kind::matrix && rows() == 3 && cols() == 1; }

    /// A number that is written in a formula; 0 is a zero of any shape.
    static Value written(double number);
    static Value unit_matrix();
    double written_number() const { return d[0](0, 0); }
};

Value constant(const MatrixX& value);
Value number(double value);
/// A number that is written in the formula.
Value literal(double value);
/// @param order of the last derivative that is known
Value moving(const MatrixX& value, const MatrixX& rate, const MatrixX& acceleration, int order);
Value zero();
Value identity();

/// Accuracy of a value relative to its largest term: kKnown; for literals, what rounding leaves.
double known_share(const Value& a);

/// "3 x 4", "a number"
std::string shape_text(const Value& value);

Value sum(const Value& a, const Value& b);
Value negative(const Value& a);
Value difference(const Value& a, const Value& b);
Value product(const Value& a, const Value& b);
Value quotient(const Value& a, const Value& b);
Value cross(const Value& a, const Value& b);
/// Scalar product of two vectors; otherwise the product.
Value dot(const Value& a, const Value& b);
Value transposed(const Value& a);
Value inverse(const Value& a);
/// 3x3 skew matrix of a vector.
Value skew(const Value& a);
/// 4x4 minus operator of slide 21 of a vector.
Value minus_operator(const Value& a);
Value determinant(const Value& a);
/// The same value, with rounding relative to its own size, not to the terms that it was computed from.
Value known(Value a);
Value derivative(const Value& a);
Value component(const Value& a, Eigen::Index row);
/// Blocks in rows and columns; zeros and identities take the shape that is needed.
Value stacked(const std::vector<std::vector<Value>>& blocks);

/// Difference of two values.
struct Comparison {
    double difference = 0.0;  ///< largest entry
    double scale = 0.0;       ///< largest term of either side; literals count in proportion to their error
};
/// @throws Mismatch if the shapes differ
Comparison compared(const Value& a, const Value& b);

/// A function of the number `a`, from its value and first two derivatives at `a`.
Value function_of(const Value& a, double value, double first, double second);

/// Power of a number, or of a matrix if the exponent is whole.
/// @throws NoValue for a root of a negative number and a division by zero
Value power(const Value& a, double n);
Value square_root(const Value& a);
/// Length of a vector, absolute value of a number.
Value length(const Value& a);
/// The number 0 for a zero of any shape; any other value unchanged.
Value as_number(const Value& a);

/// Angle of a vector (x, y), without derivatives.
Value arc_tangent_of_two(const Value& y, const Value& x);

/// A function by its name: sin, det, rank; nothing if there is none of that name.
/// @throws Mismatch if the argument has the wrong shape, NoValue if the function has no value there
std::optional<Value> value_of_function(const std::string& name, const Value& argument);

}  // namespace jw::formula
