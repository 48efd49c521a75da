#pragma once

#include <vector>

#include "app/session/claims/checks.hpp"
#include "core/quantity/evaluate.hpp"

/// Proves formulas by evaluating both sides.
namespace jw {

/// Random states of the mechanism of `instant`, with its masses; the same in every run.
std::vector<Instant> arbitrary_instants(const Instant& instant);

/// Judges a formula. It holds if its sides agree, up to rounding, at every instant; a formula that is claimed
/// not to hold must fail clearly at one instant.
void judge_formula(const FormulaClaim& claim, const std::vector<Instant>& instants, ClaimResult& result);

}  // namespace jw
