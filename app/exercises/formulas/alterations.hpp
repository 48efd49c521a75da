#pragma once

#include <vector>

#include "app/exercises/formulas/alter.hpp"

/// Formulas with one mistake: one altered formula for each place where the mistake can be made, and often one
/// with the mistake made everywhere.
namespace jw::alterations {

using Alterations = std::vector<Altered>;

Alterations wrong_sign(const math::Row& right);
Alterations sign_of_term(const math::Row& right);
Alterations dropped_term(const math::Row& right);
Alterations exchanged_bodies(const math::Row& right);
Alterations wrong_body(const math::Row& right);
Alterations local_for_global(const math::Row& right);
Alterations global_for_local(const math::Row& right);
Alterations forgotten_matrix(const math::Row& right);
Alterations transposed_matrix(const math::Row& right);
Alterations transposed(const math::Row& right);
Alterations other_frame(const math::Row& right);
Alterations g_for_l(const math::Row& right);
Alterations lost_factor(const math::Row& right);
Alterations lost_square(const math::Row& right);
Alterations lost_dot(const math::Row& right);
Alterations lost_tilde(const math::Row& right);
Alterations exchanged_factors(const math::Row& right);
Alterations other_point(const math::Row& right);
Alterations other_jacobian(const math::Row& right);
Alterations not_normalised(const math::Row& right);
Alterations other_function(const math::Row& right);
Alterations degrees_in_function(const math::Row& right);
Alterations forgotten_inverse(const math::Row& right);
Alterations other_component(const math::Row& right);

}  // namespace jw::alterations
