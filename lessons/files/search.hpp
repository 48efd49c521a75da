#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson/lesson.hpp"

/// Searching lessons by words: the same on the command line and in the window.
namespace jw {

/// Slides `first` to `last`, both included.
struct SlideRange {
    int first = 0;
    int last = 0;

    bool operator==(const SlideRange&) const = default;
};

/// The slides that a source names: "slides 4-6, 8; book ch. 7" has 4-6 and 8.
std::vector<SlideRange> slides_in(std::string_view source);

/// The words and slides by which a search finds a lesson.
struct Searchable {
    std::string words;  ///< its texts and names, in lower case
    std::vector<SlideRange> slides;
};

/// Title and text of a lesson, the texts of its steps, its chapter, its source, the name of its file, and the
/// types and names of its joints.
Searchable searchable_of(const Lesson& lesson, const std::filesystem::path& file);
/// A file that cannot be read is found by its name.
Searchable searchable_of(const std::filesystem::path& file);

/// True if the lesson has everything that `search` asks for, ignoring case: each word as a part of its texts,
/// and for "slide 5", "slides 4-6", "slides 4, 8" one of these slides in its source.
bool fits(const Searchable& lesson, std::string_view search);

}  // namespace jw
