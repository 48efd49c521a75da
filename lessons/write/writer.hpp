#pragma once

#include <filesystem>
#include <string>

#include "lessons/lesson/lesson.hpp"

/// Writes lessons to lesson files: the inverse of reader.hpp.
namespace jw {

/// The lesson as a file of the format of docs/writing-a-lesson.md. Reading it gives the same lesson, every
/// double exactly; vectors are written in the frames of their bodies. Joints and drivers that are not in
/// Lesson::order are left out, with the drivers along such joints and the claims about either.
///
/// The lesson must be as the format demands (bodies[0] is the ground, |p| = 1 up to 0.001, sides
/// perpendicular to axes, names without dots); otherwise the reader refuses the text and says why.
/// @throws std::invalid_argument for a driver or a rotational spring that no lesson can describe, and for
/// numbers that are not finite
std::string lesson_text(const Lesson& lesson);

/// Writes `text` completely or not at all: to a file with another name in the same folder, which is then
/// renamed. Follows a link.
/// @return false, with the reason in `error`, if it cannot be written; an existing file then stays unchanged
bool write_lesson_file(const std::filesystem::path& path, const std::string& text, std::string& error);

}  // namespace jw
