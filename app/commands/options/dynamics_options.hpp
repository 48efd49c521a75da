#pragma once

#include <optional>
#include <string>

#include "core/integrate/simulation.hpp"

namespace CLI {
class App;
}

/// Options of all commands that integrate.
namespace jw {

struct DynamicsOptions {
    std::string method;       ///< empty: the lesson's
    std::string treatment;    ///< empty: the lesson's
    std::string coordinates;  ///< empty: those of joints where they are faster
    std::optional<double> tolerance;
    std::optional<double> step;
};

void add_dynamics_options(CLI::App& command, DynamicsOptions& options);

/// @throws CommandError (bad_input) for numbers that are not positive
void apply(const DynamicsOptions& options, SimulationSettings& settings);

}  // namespace jw
