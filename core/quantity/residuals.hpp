#pragma once

#include "core/quantity/evaluate.hpp"

/// Residuals of single equations; used by evaluate.cpp only.
namespace jw {

QuantityValue residual_at(const ResidualQuantity& quantity, const Instant& instant, int highest);

}  // namespace jw
