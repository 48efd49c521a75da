#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lessons/diagnostics/read_text.hpp"
#include "lessons/lesson/lesson.hpp"

/// Lesson files: TOML as described in docs/writing-a-lesson.md.
namespace jw {

/// A lesson, or the mistakes in the file: with a lesson there are at most warnings; without one there is at
/// least one error.
struct ReadResult : FileRead {
    std::optional<Lesson> lesson;

    /// The first 50 diagnostics in compiler style, and the number of the others.
    std::string report() const;
};

/// Reads a lesson; never throws for bad input.
ReadResult read_lesson(std::string source, std::string file_name);
/// The same, with the claims of the lesson replaced by `claims`, tables [[expect]] in TOML. Questions, trials
/// and exercises of the lesson are left out. Mistakes in the claims are reported without a place.
ReadResult read_lesson_with_claims(std::string source, std::string file_name, const std::string& claims);
ReadResult read_lesson_file(const std::filesystem::path& path);

/// Version of the TOML parser, "3.3.0".
std::string toml_version();

}  // namespace jw
