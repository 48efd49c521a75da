#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "lessons/diagnostics/read_text.hpp"

/// The order of a course: the file `course.toml` beside the folders of its chapters.
namespace jw {

inline constexpr const char* kCourseFile = "course.toml";

struct Chapter {
    std::string name;  ///< name of its folder
    Text title;
    Text about;
    std::vector<std::string> needs;    ///< names of chapters before this one
    std::vector<std::string> lessons;  ///< names of files, in order
};

struct Course {
    std::vector<Chapter> chapters;  ///< in order

    /// Index of a chapter; the number of chapters if the course does not name it.
    std::size_t place_of_chapter(const std::string& name) const;
    /// Index of a file in its chapter; the number of files that the chapter names if this file is not one of
    /// them.
    std::size_t place_of_lesson(const std::string& chapter, const std::string& file) const;
};

/// A course; it has no chapters if the file has mistakes or does not exist.
struct CourseRead : FileRead {
    Course course;
};

/// Reads a course; never throws for bad input. Does not check that the lessons exist.
/// @param folder  must contain the folders of the chapters; empty: this is not checked
CourseRead read_course(std::string source, std::string file_name, const std::filesystem::path& folder = {});
enum class ChapterFolders { must_be_there, not_asked };
/// The course of a folder. A folder without `course.toml` is not a mistake.
CourseRead read_course_of(
    const std::filesystem::path& folder, ChapterFolders chapters = ChapterFolders::must_be_there);

/// Lessons below a folder in the order of their course.
struct CourseLessons {
    struct Entry {
        std::filesystem::path file;
        std::string folder;  ///< folder of its chapter; empty if it is not in a chapter
        Text chapter_title;  ///< empty where no course names the chapter
    };
    std::vector<Entry> lessons;
    std::vector<Chapter> chapters;              ///< those named by a course that have lessons here, in order
    std::string report;                         ///< mistakes in the courses; empty if there are none
    std::vector<std::filesystem::path> faulty;  ///< courses with mistakes
};

/// All lessons below `folder`, each in the order of the nearest course around it, which may be that of the
/// folder above. Lessons that the course does not name come last in their chapter, and chapters that it does
/// not name come last; both are sorted by path.
CourseLessons course_lessons(const std::filesystem::path& folder);

}  // namespace jw
