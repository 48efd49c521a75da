#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/site/site_course.hpp"

/// A course as a static site: a page for each lesson, an index, and the program as a page beside them.
namespace jw::site {

struct SiteOutput {
    std::filesystem::path out;
    std::filesystem::path page;    ///< folder of the program as a page
    std::filesystem::path slides;  ///< file to copy to SiteCourse::slides; empty: none
};

/// Writes the site of a course. It replaces a site that is already in the folder; after a failure the old
/// site is still there.
/// @param progress  called with the fraction that is done, 0 to 1
/// @throws std::runtime_error if something cannot be read, drawn or written
void write_site(
    const SiteCourse& course, const SiteOutput& output, const std::function<void(double)>& progress);

}  // namespace jw::site
