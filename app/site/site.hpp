#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/site/site_course.hpp"

/// A course as a static site: a page for each lesson, an index, and the program as a page beside them.
namespace jw::site {

struct SiteOutput {
    std::filesystem::path out;
    std::filesystem::path page;    ///< files of the program as a page
    std::filesystem::path slides;  ///< a file to be copied to where the course says; empty: none
};

/// Writes the site of a course; a folder that has one gets the new one in its place, or keeps it.
/// @param progress  told the share that is done, 0 to 1
/// @throws std::runtime_error if something cannot be read, drawn or written
void write_site(
    const SiteCourse& course, const SiteOutput& output, const std::function<void(double)>& progress);

}  // namespace jw::site
