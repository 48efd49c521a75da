#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/session/claims/checks.hpp"
#include "lessons/files/search.hpp"
#include "lessons/lesson/exercise.hpp"
#include "lessons/lesson/lesson.hpp"

/// A course as its site shows it: checked lessons in their order, with their exercises.
namespace jw::site {

struct SiteLesson {
    std::filesystem::path file;
    std::string name;     ///< of its file below the folder of the course: "loops/four-bar"
    std::string address;  ///< its name in addresses (app/host/lesson/address.hpp)
    Lesson lesson;        ///< its texts are in the language of the reader
    Searchable searchable;
    std::vector<ClaimResult> claims;  ///< all hold
    std::vector<Exercise> exercises;  ///< from its file and from files of exercises; texts likewise
};

struct SiteChapter {
    std::string name;   ///< of its folder
    std::string title;  ///< with formulas between dollar signs, like `about`
    std::string about;
    std::vector<std::string> needs;    ///< titles of the chapters that it needs
    std::vector<std::size_t> lessons;  ///< indices into SiteCourse::lessons
};

struct SiteCourse {
    std::string title;
    std::string program;  ///< name and version of the program that made it
    std::string slides;   ///< path of the slides from the top of the site, or a URL; empty: none
    std::filesystem::path folder;
    std::vector<std::filesystem::path> exercise_files;
    std::vector<SiteChapter> chapters;
    std::vector<SiteLesson> lessons;  ///< in the order of the chapters
};

struct SiteCourseRead {
    SiteCourse course;
    std::string report;              ///< mistakes in files, as their readers report them; empty if none
    std::string failed_claims;       ///< claims that do not hold, one per line
    std::vector<std::string> notes;  ///< sentences about exercises that belong to no lesson
};

/// Reads all lessons below a folder and proves their claims.
/// @param exercises  folder of files of exercises; empty: `exercises` beside the lessons, if it exists
/// @param progress   called with the fraction that is done, 0 to 1
SiteCourseRead read_site_course(
    const std::filesystem::path& folder, const std::filesystem::path& exercises,
    const std::function<void(double)>& progress);

/// Name of the folder of lessons below `course` of a site; the folder of exercises is beside it.
std::string lessons_folder_of(const SiteCourse& course);

/// Numbers of the slides that the source of a lesson or exercise names.
std::vector<int> slide_numbers(const std::string& source);

}  // namespace jw::site
