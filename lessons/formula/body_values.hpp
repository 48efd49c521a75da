#pragma once

#include <optional>

#include "core/quantity/evaluate.hpp"
#include "lessons/formula/symbol.hpp"
#include "lessons/formula/value.hpp"

/// Symbols of one body at an instant, with their derivatives.
namespace jw::formula {

/// r, p, A, G, L, ω, ω′ of a body.
struct BodyValues {
    Value r;
    Value p;
    Value G;
    Value L;
    Value A;
    Value omega;
    Value omega_local;
};
BodyValues values_of_body(const Instant& instant, int body);

/// A vector fixed in the body, in the global frame: A s′.
Value global_vector(const BodyValues& body, const Vec3& s_local);

/// Value of a symbol of the body, without its index: r, p, e, e_0 to e_3 (index "0" to "3"), A, G, L, ω, ω′.
std::optional<Value> value_of_body_symbol(const BodyValues& body, const Symbol& symbol);

}  // namespace jw::formula
