#pragma once

#include <filesystem>
#include <string>

#include "app/session/try/session.hpp"

/// Files made from the open lesson, and the messages about them.
namespace jw::host {

/// Task for the code that draws, kept until it is done.
enum class DrawingTask { none, save_picture, record };

/// End of the name of the file or folder that a task makes at a step: "-step-12.png", "-frames".
std::string suffix_of(DrawingTask task, int step);

/// "four-bar-2.png": a name in `folder` that is not taken.
/// @param lesson  its file
/// @param suffix  ".png", "-changed.toml"
std::filesystem::path free_name(
    const std::filesystem::path& folder, const std::filesystem::path& lesson, const std::string& suffix);

struct Saved {
    bool done = false;
    std::string said;  ///< message: saved, or why not
};
Saved save_text(const std::filesystem::path& path, const std::string& text);
/// Saves the lesson in its present state, if the file can be read back.
Saved save_lesson(const std::filesystem::path& path, const Session& session);

}  // namespace jw::host
