#pragma once

#include <filesystem>
#include <stdexcept>

#include "jointwise/mechanism.hpp"

/// Lesson files, as docs/writing-a-lesson.md describes them.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// Mistakes in a lesson: `what()` is the report that the program would print, with line and column.
class LessonError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A lesson that was read; a value that can be copied.
class Lesson {
public:
    const std::string& title() const { return title_; }
    const std::string& text() const { return text_; }
    const Mechanism& mechanism() const { return mechanism_; }
    /// What the reader warned of; empty if of nothing.
    const std::string& warnings() const { return warnings_; }

    struct Inside;  ///< of the library alone
    const Inside& inside() const { return *inside_; }
    Lesson(std::shared_ptr<const Inside> inside, std::string warnings);

private:
    std::shared_ptr<const Inside> inside_;
    Mechanism mechanism_;
    std::string title_;
    std::string text_;
    std::string warnings_;
};

/// @throws LessonError
Lesson read_lesson(const std::filesystem::path& file);
/// @param name  that messages call it
Lesson read_lesson_text(const std::string& toml, const std::string& name = "lesson.toml");

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
