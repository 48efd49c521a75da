#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "lessons/diagnostics.hpp"
#include "lessons/read_text.hpp"

/// The order of a course: the file `course.toml` beside the folders of its chapters.
namespace jw {

inline constexpr const char* kCourseFile = "course.toml";

struct Chapter {
    std::string name;  ///< of its folder
    Text title;
    Text about;
    std::vector<std::string> needs;    ///< names of chapters before this one
    std::vector<std::string> lessons;  ///< names of files, in order
};

struct Course {
    std::vector<Chapter> chapters;  ///< in order

    /// Index of a chapter, their number for one that is not named.
    std::size_t place_of_chapter(const std::string& name) const;
    /// Index of a file in its chapter, the number of those named there for others.
    std::size_t place_of_lesson(const std::string& chapter, const std::string& file) const;
};

/// A course; one without chapters where something is wrong with the file, or where there is none.
struct CourseRead {
    Course course;
    std::vector<Diagnostic> diagnostics;  ///< by position
    std::string source;
    std::vector<ReadText> texts;  ///< all texts for people in it

    std::string report() const;
};

/// Never throws for bad input. Whether there are lessons of these names is not asked.
/// @param folder  where the folders of chapters must be; empty: that is not asked either
CourseRead read_course(std::string source, std::string file_name, const std::filesystem::path& folder = {});
enum class ChapterFolders { must_be_there, not_asked };
/// The course of a folder; without `course.toml` there is nothing wrong.
CourseRead read_course_of(
    const std::filesystem::path& folder, ChapterFolders chapters = ChapterFolders::must_be_there);

/// Lessons below a folder in the order of their course.
struct CourseLessons {
    struct Entry {
        std::filesystem::path file;
        std::string folder;  ///< of its chapter, empty where it is in none
        Text chapter_title;  ///< empty where no course names the chapter
    };
    std::vector<Entry> lessons;
    std::vector<Chapter> chapters;              ///< those named by a course that have lessons here, in order
    std::string report;                         ///< what is wrong with the courses met, empty if nothing is
    std::vector<std::filesystem::path> faulty;  ///< courses with mistakes
};

/// All lessons below `folder`, each by the nearest course around it, which may be that of the folder above.
/// Lessons that it does not name come last in their chapter, chapters that it does not name come last, both
/// by path.
CourseLessons course_lessons(const std::filesystem::path& folder);

}  // namespace jw
