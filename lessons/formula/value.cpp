#include "lessons/formula/value.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/elementary/elementary.hpp"

namespace jw::formula {

namespace {

using Kind = Value::Kind;

// Accuracy of written numbers, as a share of kKnown: what the rounding of some operations leaves.
constexpr double kLiteral = 1e-5;

double largest(const MatrixX& m) { return m.size() == 0 ? 0.0 : m.cwiseAbs().maxCoeff(); }

MatrixX times(const MatrixX& a, const MatrixX& b) { return a * b; }

/// The largest term of the k-th derivative; that of a literal is reduced to its smaller error.
double known_scale(const Value& a, std::size_t k) { return a.scale[k] * (known_share(a) / kKnown); }

/// Bound of the entries of the k-th derivative: literals in a sum add less to `scale` than to the entries.
double size_of(const Value& a, std::size_t k) { return std::max(a.scale[k], largest(a.d[k])); }

/// Applies a linear map to value and derivatives.
template <class F>
Value mapped(const Value& a, F&& f) {
    Value out;
    out.is_literal = a.is_literal;
    out.order = a.order;
    out.scale = a.scale;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(a.order); ++k) { out.d[k] = f(a.d[k]); }
    return out;
}

void require_matrix(const Value& a, const std::string& what) {
    if (a.kind != Kind::matrix) {
        throw Mismatch(what + " cannot be taken of 0 or I, whose size is not known");
    }
}

void require_vector(const Value& a, const std::string& what) {
    if (!a.is_vector()) {
        throw Mismatch(what + " is taken of " + shape_text(a) + "; expected a vector of three");
    }
}

/// An identity or a zero as a matrix of this shape; any other value unchanged.
Value shaped(const Value& a, Eigen::Index rows, Eigen::Index cols) {
    if (a.kind == Kind::matrix) { return a; }
    if (a.kind == Kind::zero) { return constant(MatrixX::Zero(rows, cols)); }
    if (rows != cols) {
        throw Mismatch(
            "I is square, but " + std::to_string(rows) + " x " + std::to_string(cols) + " is needed");
    }
    return mapped(
        a, [&](const MatrixX& factor) -> MatrixX { return factor(0, 0) * MatrixX::Identity(rows, rows); });
}

/// Product with its derivatives. @param terms  of the sum that gives each entry
template <class F>
Value by_product_rule(const Value& a, const Value& b, double terms, F&& multiply) {
    Value out;
    out.is_literal = a.is_literal && b.is_literal;
    out.order = std::min(a.order, b.order);
    // each factor passes on its error, times the size of the other factor
    const auto scale = [&](std::size_t k, std::size_t l) {
        if (out.is_literal) { return a.scale[k] * b.scale[l]; }
        return std::max(size_of(a, k) * known_scale(b, l), known_scale(a, k) * size_of(b, l));
    };
    out.d[0] = multiply(a.d[0], b.d[0]);
    out.scale = {terms * scale(0, 0), 0.0, 0.0};
    if (out.order >= 1) {
        out.d[1] = multiply(a.d[1], b.d[0]) + multiply(a.d[0], b.d[1]);
        out.scale[1] = terms * (scale(1, 0) + scale(0, 1));
    }
    if (out.order >= 2) {
        out.d[2] = multiply(a.d[2], b.d[0]) + 2.0 * multiply(a.d[1], b.d[1]) + multiply(a.d[0], b.d[2]);
        out.scale[2] = terms * (scale(2, 0) + 2.0 * scale(1, 1) + scale(0, 2));
    }
    return out;
}

}  // namespace

double known_share(const Value& a) { return a.is_literal ? kLiteral * kKnown : kKnown; }

Value moving(const MatrixX& value, const MatrixX& rate, const MatrixX& acceleration, int order) {
    Value v;
    v.order = order;
    v.d = {value, rate, acceleration};
    v.scale = {largest(value), largest(rate), largest(acceleration)};
    return v;
}

Value constant(const MatrixX& value) {
    const MatrixX still = MatrixX::Zero(value.rows(), value.cols());
    return moving(value, still, still, 2);
}

Value number(double value) { return constant(MatrixX::Constant(1, 1, value)); }

Value literal(double value) {
    Value v = number(value);
    v.is_literal = true;
    return v;
}

Value zero() {
    Value v = literal(0.0);
    v.kind = Kind::zero;
    return v;
}

Value identity() {
    Value v = literal(1.0);
    v.kind = Kind::identity;
    return v;
}

Value Value::written(double number) { return number == 0.0 ? zero() : literal(number); }
Value Value::unit_matrix() { return identity(); }

std::string shape_text(const Value& value) {
    switch (value.kind) {
        case Kind::zero: return "0";
        case Kind::identity: return "I";
        case Kind::matrix: break;
    }
    if (value.is_number()) { return "a number"; }
    return std::to_string(value.rows()) + " x " + std::to_string(value.cols());
}

Value sum(const Value& a, const Value& b) {
    if (a.kind == Kind::zero) { return b; }
    if (b.kind == Kind::zero) { return a; }
    const bool both = a.kind == Kind::identity && b.kind == Kind::identity;
    const Value left = both ? a : shaped(a, b.rows(), b.cols());
    const Value right = both ? b : shaped(b, a.rows(), a.cols());
    if (left.rows() != right.rows() || left.cols() != right.cols()) {
        throw Mismatch(shape_text(a) + " and " + shape_text(b) + " are added");
    }
    Value out = left;
    out.order = std::min(left.order, right.order);
    out.is_literal = left.is_literal && right.is_literal;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(out.order); ++k) {
        out.d[k] = left.d[k] + right.d[k];
        out.scale[k] = out.is_literal ? std::max(left.scale[k], right.scale[k])
                                      : std::max(known_scale(left, k), known_scale(right, k));
    }
    return out;
}

Value negative(const Value& a) {
    Value out = mapped(a, [](const MatrixX& m) -> MatrixX { return -m; });
    out.kind = a.kind;
    return out;
}

Value difference(const Value& a, const Value& b) { return sum(a, negative(b)); }

Value product(const Value& a, const Value& b) {
    if (a.kind == Kind::zero || b.kind == Kind::zero) { return zero(); }
    const bool scales =
        a.is_number() || b.is_number() || a.kind == Kind::identity || b.kind == Kind::identity;
    if (scales) {
        const bool left = a.rows() == 1 && a.cols() == 1;
        Value out = by_product_rule(a, b, 1.0, [left](const MatrixX& x, const MatrixX& y) -> MatrixX {
            return left ? x(0, 0) * y : y(0, 0) * x;
        });
        const bool stays =
            (a.kind == Kind::identity || a.is_number()) && (b.kind == Kind::identity || b.is_number());
        if (stays && (a.kind == Kind::identity || b.kind == Kind::identity)) { out.kind = Kind::identity; }
        return out;
    }
    if (a.cols() != b.rows()) { throw Mismatch(shape_text(a) + " is multiplied by " + shape_text(b)); }
    return by_product_rule(a, b, static_cast<double>(a.cols()), times);
}

Value quotient(const Value& a, const Value& b) {
    if (!b.is_number()) { throw Mismatch("it is divided by " + shape_text(b) + "; expected a number"); }
    return product(a, power(b, -1));
}

Value cross(const Value& a, const Value& b) {
    require_vector(a, "a cross product");
    require_vector(b, "a cross product");
    return product(skew(a), b);
}

Value dot(const Value& a, const Value& b) {
    const bool columns = a.kind == Kind::matrix && b.kind == Kind::matrix && a.cols() == 1 && b.cols() == 1 &&
                         a.rows() > 1 && a.rows() == b.rows();
    return product(columns ? transposed(a) : a, b);
}

Value transposed(const Value& a) {
    if (a.kind != Kind::matrix) { return a; }
    return mapped(a, [](const MatrixX& m) -> MatrixX { return m.transpose(); });
}

Value inverse(const Value& a) {
    if (a.kind == Kind::identity) { return power(a, -1); }
    require_matrix(a, "the inverse");
    if (a.is_number()) { return power(a, -1); }
    if (a.rows() != a.cols()) { throw Mismatch("the inverse of " + shape_text(a) + " is taken"); }
    Value out;
    out.order = a.order;
    const MatrixX inverted = inverse_of(a.d[0]);
    if (!inverted.allFinite()) { throw NoValue("the inverse of a singular matrix is taken"); }
    out.d[0] = inverted;
    const MatrixX negative = -inverted;
    if (a.order >= 1) { out.d[1] = times(times(negative, a.d[1]), inverted); }
    if (a.order >= 2) { out.d[2] = times(negative, times(a.d[2], inverted) + 2.0 * times(a.d[1], out.d[1])); }
    for (std::size_t k = 0; k < 3; ++k) {
        out.scale[k] = largest(out.d[k]) * (1.0 + largest(inverted) * a.scale[0]);
    }
    return out;
}

Value skew(const Value& a) {
    if (a.kind == Kind::zero) { return a; }
    require_vector(a, "a tilde");
    return mapped(a, [](const MatrixX& m) -> MatrixX { return jw::tilde(Vec3(m)); });
}

Value minus_operator(const Value& a) {
    require_vector(a, "a bar");
    return mapped(a, [](const MatrixX& m) -> MatrixX { return jw::bar(Vec3(m)); });
}

Value determinant(const Value& a) {
    require_matrix(a, "the determinant");
    if (a.rows() != a.cols()) { throw Mismatch("the determinant of " + shape_text(a) + " is taken"); }
    Value out = number(determinant_of(a.d[0]));
    out.order = 0;
    out.scale[0] = std::max(1.0, elementary::pow(size_of(a, 0), static_cast<double>(a.rows())));
    return out;
}

Value known(Value a) {
    for (std::size_t k = 0; k <= static_cast<std::size_t>(a.order); ++k) { a.scale[k] = largest(a.d[k]); }
    return a;
}

Value derivative(const Value& a) {
    if (a.kind == Kind::zero) { return a; }
    if (a.order < 1) { throw Mismatch("a derivative is not known here"); }
    Value out = a;
    out.order = a.order - 1;
    std::rotate(out.d.begin(), out.d.begin() + 1, out.d.end());
    std::rotate(out.scale.begin(), out.scale.begin() + 1, out.scale.end());
    if (out.kind == Kind::identity) { out.kind = Kind::zero; }
    return out;
}

Value component(const Value& a, Eigen::Index row) {
    if (a.kind != Kind::matrix || a.cols() != 1 || row >= a.rows()) {
        throw Mismatch(shape_text(a) + " has no component " + std::to_string(row));
    }
    return mapped(a, [row](const MatrixX& m) -> MatrixX { return m.row(row); });
}

namespace {

using Blocks = std::vector<std::vector<Value>>;

struct Sizes {
    std::vector<Eigen::Index> heights;
    std::vector<Eigen::Index> widths;
};

/// Takes the size of a block, which must be that of the blocks before it. @param size  0 before the first
void agree(Eigen::Index& size, Eigen::Index of_block, const char* what) {
    if (size != 0 && size != of_block) {
        throw Mismatch(std::string("blocks of one ") + what + " differ in size");
    }
    size = of_block;
}

Sizes sizes_of(const Blocks& blocks) {
    const std::size_t columns = blocks.front().size();
    Sizes sizes{std::vector<Eigen::Index>(blocks.size()), std::vector<Eigen::Index>(columns)};
    bool numbers_only = true;
    for (std::size_t r = 0; r < blocks.size(); ++r) {
        for (const Value& v : blocks[r]) {
            numbers_only = numbers_only && (v.is_number() || v.kind != Kind::matrix);
            if (v.kind == Kind::matrix) { agree(sizes.heights[r], v.rows(), "row"); }
        }
    }
    for (std::size_t c = 0; c < columns; ++c) {
        for (const auto& row : blocks) {
            if (row[c].kind == Kind::matrix) { agree(sizes.widths[c], row[c].cols(), "column"); }
        }
    }
    // I is square
    for (std::size_t r = 0; r < blocks.size(); ++r) {
        for (std::size_t c = 0; c < columns; ++c) {
            if (blocks[r][c].kind != Kind::identity) { continue; }
            if (sizes.widths[c] == 0) { sizes.widths[c] = sizes.heights[r]; }
            if (sizes.heights[r] == 0) { sizes.heights[r] = sizes.widths[c]; }
        }
    }
    // blocks of unknown size have the size of a position or an angular velocity
    const Eigen::Index otherwise = numbers_only ? 1 : 3;
    for (Eigen::Index& size : sizes.heights) { size = size == 0 ? otherwise : size; }
    for (Eigen::Index& size : sizes.widths) { size = size == 0 ? otherwise : size; }
    return sizes;
}

}  // namespace

Value stacked(const Blocks& blocks) {
    if (blocks.empty() || blocks.front().empty()) { throw Mismatch("a matrix without entries"); }
    const Sizes sizes = sizes_of(blocks);
    const auto total = [](const auto& list) {
        return std::accumulate(list.begin(), list.end(), Eigen::Index{0});
    };
    Value out = constant(MatrixX::Zero(total(sizes.heights), total(sizes.widths)));
    Eigen::Index top = 0;
    for (std::size_t r = 0; r < blocks.size(); ++r) {
        Eigen::Index left = 0;
        for (std::size_t c = 0; c < blocks[r].size(); ++c) {
            const Value block = shaped(blocks[r][c], sizes.heights[r], sizes.widths[c]);
            out.order = std::min(out.order, block.order);
            for (std::size_t k = 0; k <= static_cast<std::size_t>(block.order); ++k) {
                out.d[k].block(top, left, sizes.heights[r], sizes.widths[c]) = block.d[k];
                out.scale[k] = std::max(out.scale[k], block.scale[k]);
            }
            left += sizes.widths[c];
        }
        top += sizes.heights[r];
    }
    return out;
}

Comparison compared(const Value& a, const Value& b) {
    const Value apart = difference(a, b);
    return {largest(apart.d[0]), std::max(known_scale(a, 0), known_scale(b, 0))};
}

}  // namespace jw::formula
