#pragma once

#include <functional>

#include "jointwise/analysis.hpp"

/// Motions moment by moment, for a receiver that collects them.
namespace jointwise {
inline namespace JOINTWISE_ABI {

using Receive = std::function<void(const Moment&)>;

/// @throws as follow and simulate of analysis.hpp do
void follow_into(
    const Mechanism& mechanism, const std::vector<double>& times, const Receive& receive,
    const std::function<bool()>& go_on = {});
void simulate_into(
    const Mechanism& mechanism, const std::vector<double>& times, const Simulation& settings,
    const Receive& receive);

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
