#pragma once

#include <optional>

#include "core/quantity/evaluate.hpp"
#include "lessons/formula/symbol.hpp"
#include "lessons/formula/value.hpp"

/// Symbols of a whole mechanism at an instant: Φ, Φq, q̇, q̈, γ, Φ_t, and with masses M, Q, λ.
namespace jw::formula {

/// Value in the columns of `coordinates`, moving bodies only; (r, p) also has a row pᵀp − 1 for each body.
std::optional<Value> value_of_system_symbol(
    const Instant& instant, CoordinateChoice coordinates, const Symbol& symbol);

/// Mass properties and applied forces of a body: m, J′, J, f, n′, n.
std::optional<Value> value_of_mass_symbol(const Instant& instant, int body, const Symbol& symbol);

}  // namespace jw::formula
