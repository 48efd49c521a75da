#pragma once

#include <optional>

#include "core/quantity/evaluate.hpp"
#include "lessons/formula/symbol.hpp"
#include "lessons/formula/value.hpp"

/// Symbols of a body, of a joint and of the whole mechanism at an instant, with their derivatives.
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

/// Mass properties and applied forces of a body: m, J′, J, f, n′, n.
std::optional<Value> value_of_mass_symbol(const Instant& instant, int body, const Symbol& symbol);

/// Symbols of a joint: its vectors, Φ, blocks of Φq, γ.
/// @param role  primitive whose Φ is meant; nothing: all primitives of the joint
std::optional<Value> value_of_joint_symbol(
    const Instant& instant, int joint, std::optional<Role> role, const Symbol& symbol);

/// Symbols of the whole mechanism: Φ, Φq, q̇, q̈, γ, Φ_t, and with masses M, Q, λ. Values are in the columns of
/// `coordinates`, moving bodies only; (r, p) also has a row pᵀp − 1 for each body.
std::optional<Value> value_of_system_symbol(
    const Instant& instant, CoordinateChoice coordinates, const Symbol& symbol);

}  // namespace jw::formula
