#pragma once

#include <filesystem>
#include <stdexcept>

#include "jointwise/analysis.hpp"

/// Lesson files, as docs/writing-a-lesson.md describes them.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// One mistake in a lesson. Line and column count from 1; line 0 stands for the whole file.
struct Mistake {
    std::string file;
    int line = 0;
    int column = 0;       ///< in characters
    std::string code;     ///< "JW201", as `jointwise explain` takes it
    std::string message;  ///< what is wrong; what was expected
    std::string hint;     ///< what to do, may be empty
};

/// Mistakes in a lesson: `what()` is the program's report, with line and column.
class LessonError : public std::runtime_error {
public:
    LessonError(const std::string& report, std::vector<Mistake> mistakes)
        : std::runtime_error(report), mistakes_(std::move(mistakes)) {}
    /// The mistakes in the order of the file, at least one.
    const std::vector<Mistake>& mistakes() const { return mistakes_; }

private:
    std::vector<Mistake> mistakes_;
};

/// A lesson that was read; it can be copied.
class Lesson {
public:
    const std::string& title() const { return title_; }
    const std::string& text() const { return text_; }
    const Mechanism& mechanism() const { return mechanism_; }
    /// Times of the motion that the lesson shows [s], as in `jointwise solve`; empty if it shows none.
    std::vector<double> motion_times() const;
    /// Times of the motion by masses and forces [s], as in `jointwise simulate`; empty if there is no such
    /// motion.
    std::vector<double> simulation_times() const;
    /// Method, tolerance and step of the lesson; the default ones if it gives none.
    Simulation simulation() const;
    /// Warnings of the reader; empty if there are none.
    const std::string& warnings() const { return warnings_; }

    struct Inside;  ///< only for the library
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
/// @param name  the name of the file in messages
Lesson read_lesson_text(const std::string& toml, const std::string& name = "lesson.toml");

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
