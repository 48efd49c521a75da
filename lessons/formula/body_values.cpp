#include "lessons/formula/part_values.hpp"

#include "core/jets/euler_parameters.hpp"

namespace jw::formula {

namespace {

/// Applies a linear map to p and its derivatives.
template <class F>
Value linear_in(const Value& p, F&& f) {
    Value out = p;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(p.order); ++k) {
        out.d[k] = f(Vec4(p.d[k]));
        out.scale[k] = p.scale[k];
    }
    return out;
}

Value twice(const Value& a, const Value& b) { return product(number(2.0), product(a, b)); }

}  // namespace

BodyValues values_of_body(const Instant& instant, int body) {
    const std::size_t b = jw::at(body);
    const bool accelerated = instant.acceleration.has_value();
    const int order = accelerated ? 2 : 1;
    const Vec4& p = instant.state.p[b];
    const Vec3& omega_local = instant.velocity.omega_local[b];
    const Vec3 omega_local_dot = accelerated ? instant.acceleration->omega_local[b] : Vec3(Vec3::Zero());
    const Vec3 r_ddot = accelerated ? instant.acceleration->r_dot[b] : Vec3(Vec3::Zero());
    BodyValues values;
    values.r = moving(instant.state.r[b], instant.velocity.r_dot[b], r_ddot, order);
    values.p = moving(
        p, p_dot_of_omega_local(p, omega_local), p_ddot_of_omega_local(p, omega_local, omega_local_dot),
        order);
    values.G = linear_in(values.p, [](const Vec4& q) -> MatrixX { return G_of(q); });
    values.L = linear_in(values.p, [](const Vec4& q) -> MatrixX { return L_of(q); });
    values.A = known(product(values.G, transposed(values.L)));
    values.omega = known(twice(values.G, derivative(values.p)));
    values.omega_local = known(twice(values.L, derivative(values.p)));
    return values;
}

Value global_vector(const BodyValues& body, const Vec3& s_local) {
    return known(product(body.A, constant(s_local)));
}

std::optional<Value> value_of_body_symbol(const BodyValues& body, const Symbol& symbol) {
    const std::string& s = symbol.letter;
    if (!symbol.marks.empty()) { return std::nullopt; }
    if (s == "e" && symbol.primes == 0) {
        if (symbol.index.empty()) {
            return linear_in(body.p, [](const Vec4& q) -> MatrixX { return q.tail<3>(); });
        }
        const bool digit = symbol.index.size() == 1 && symbol.index[0] >= '0' && symbol.index[0] <= '3';
        return digit ? std::optional<Value>(component(body.p, symbol.index[0] - '0')) : std::nullopt;
    }
    if (!symbol.index.empty()) { return std::nullopt; }
    if (s == "ω" && symbol.primes < 2) { return symbol.primes == 0 ? body.omega : body.omega_local; }
    if (symbol.primes != 0) { return std::nullopt; }
    if (s == "r") { return body.r; }
    if (s == "p") { return body.p; }
    if (s == "A") { return body.A; }
    if (s == "G") { return body.G; }
    if (s == "L") { return body.L; }
    return std::nullopt;
}

}  // namespace jw::formula
