#pragma once

#include <filesystem>
#include <string>

#include "app/site/site_course.hpp"

/// The program as a page in a site: the files that ./dev web has built, with the lessons of a course in place
/// of those that come with it.
namespace jw::site {

/// Content of a file. @throws std::runtime_error if it cannot be read
std::string file_text(const std::filesystem::path& file);

/// Problem with a folder that should hold the files of the page; empty if there is none.
std::string problem_of_page(const std::filesystem::path& folder);

/// The files of a course as the page reads them: lessons, course.toml and exercises by their paths there.
/// @throws std::runtime_error if a file cannot be read
std::string lessons_bundle(const SiteCourse& course);

/// Writes the page into `into`, a folder that does not exist yet. The page gets its own version, because
/// browsers keep the files of a version, and this page has other lessons.
/// @throws std::runtime_error if a file cannot be read or written
void write_live_page(
    const std::filesystem::path& page, const std::string& bundle, const std::filesystem::path& into);

/// Copies lessons and exercises into a folder, with the paths that they have in the page.
/// @throws std::runtime_error if a file cannot be read or written, or if exercises do not find their scenes
///         there
void write_course_files(const SiteCourse& course, const std::filesystem::path& into);

}  // namespace jw::site
