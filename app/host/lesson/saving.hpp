#pragma once

#include <filesystem>
#include <string>

#include "app/session/try/session.hpp"

/// Files that are made of the open lesson, and what to say of them.
namespace jw::host {

/// Task for whoever draws, kept until it is done.
enum class DrawingTask { none, save_picture, record };

/// End of the name of what a task makes at a step: "-step-12.png", "-frames".
std::string suffix_of(DrawingTask task, int step);

/// "four-bar-2.png": a name in `folder` that is not taken.
/// @param lesson  its file
/// @param suffix  ".png", "-changed.toml"
std::filesystem::path free_name(
    const std::filesystem::path& folder, const std::filesystem::path& lesson, const std::string& suffix);

struct Saved {
    bool done = false;
    std::string said;  ///< that it was done, or why it was not
};
Saved save_text(const std::filesystem::path& path, const std::string& text);
/// The lesson as it stands, where it can be read back.
Saved save_lesson(const std::filesystem::path& path, const Session& session);

}  // namespace jw::host
