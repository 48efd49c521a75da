#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lessons/files/search.hpp"

/// Lessons about slides of the lecture.
namespace jw {

/// A lesson and the slides that it is about, if any.
struct SlideLesson {
    std::filesystem::path file;
    std::string title;
    std::string text;  ///< its first text
    std::string summary;
    std::vector<SlideRange> slides;
};
/// Lesson of a file; nothing if it has mistakes.
std::optional<SlideLesson> slide_lesson_in(const std::filesystem::path& file);
/// The lessons of a course in their order.
std::vector<SlideLesson> lessons_of_slides(const std::filesystem::path& lessons_folder);

/// The lesson to look at for "slide 5": the one that is about the fewest other slides, or the first of
/// several; nullptr if there is none.
const SlideLesson* lesson_of_slide(const std::vector<SlideLesson>& lessons, const std::string& slide);

}  // namespace jw
