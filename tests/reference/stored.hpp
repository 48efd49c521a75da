#pragma once

#include <filesystem>
#include <optional>

#include "tests/reference/scene.hpp"

/// Trajectories as lessons/reference/NAME.csv: a line that says how they were computed, names of columns, 101
/// rows.
namespace jw::reference {

void write_trajectory(
    const std::filesystem::path& file, const std::string& header, Real duration,
    const Trajectory& trajectory);

/// Nothing if there is no such file or a row is not seven numbers.
std::optional<Trajectory> read_trajectory(const std::filesystem::path& file);

}  // namespace jw::reference
