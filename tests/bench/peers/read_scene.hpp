#pragma once

#include <filesystem>
#include <optional>

#include "lessons/lesson/lesson.hpp"
#include "tests/bench/peers/peer_scene.hpp"

namespace jw::peers {

/// @param lesson must outlive the result
/// @return the scene with its stored reference, or in `why_not` the reason why other engines cannot run it
std::optional<PeerScene> read_scene(
    const Lesson& lesson, const std::filesystem::path& reference, std::string& why_not);

}  // namespace jw::peers
