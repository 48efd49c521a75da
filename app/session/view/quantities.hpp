#pragma once

#include <string>
#include <vector>

#include "app/session/story/story.hpp"
#include "core/quantity/evaluate.hpp"

/// Quantities of a step; core/quantity defines them and their names.
namespace jw {

/// A measured quantity of a joint or driver during the motion.
struct QuantityMotion {
    std::string name;  ///< "pivot.angle"
    std::string unit;  ///< "deg" or "m": of the value; rates are per second
    bool driven = false;
    double value = 0.0;
    double rate = 0.0;
    double acceleration = 0.0;
    std::string rate_name = {};  ///< "pivot.angle_dot"
    std::string acceleration_name = {};
};

/// Instant with all that is known at a step.
Instant instant_of(const Step& step);

/// Quantities that a person would measure first: those that drivers prescribe, then the measures of joints
/// that are not driven.
std::vector<QuantityMotion> quantities_of(const Step& step);

}  // namespace jw
