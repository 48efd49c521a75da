#pragma once

#include <vector>

#include "app/session/claims/checks.hpp"
#include "core/quantity/evaluate.hpp"

/// Proves formulas by evaluating both sides.
namespace jw {

/// Random states of the mechanism of `instant`, with its masses: the same at every run.
std::vector<Instant> arbitrary_instants(const Instant& instant);

/// A formula holds if its sides agree, up to rounding, at every instant; a misprint must fail plainly at one.
void judge_formula(const FormulaClaim& claim, const std::vector<Instant>& instants, ClaimResult& result);

}  // namespace jw
