#pragma once

#include <string>
#include <vector>

#include "app/site/page_frame.hpp"
#include "app/site/stations.hpp"

/// The page of a lesson: its text with formulas, pictures of its stations, the live figure, its claims,
/// experiments and exercises.
namespace jw::site {

/// Path of the page of a lesson below the top of the site.
std::string path_of_page(const SiteLesson& lesson);
/// Paths of its pictures, also below the top: one with panels, shown until the live figure runs, a small one
/// for the index, and one for a station.
std::string path_of_frame(const SiteLesson& lesson);
std::string path_of_card(const SiteLesson& lesson);
std::string path_of_picture(const SiteLesson& lesson, const Station& station);
/// Path of its file, also below the top.
std::string path_of_source(const SiteCourse& course, const SiteLesson& lesson);

/// Address in the live figure, relative to the top of the site: "live/index.html#four-bar/23".
std::string live_address(const std::string& fragment);

/// @param index  place of the lesson in the course
/// @param story  of the lesson, with its motion
std::string lesson_page(
    const SiteCourse& course, std::size_t index, const Story& story, const std::vector<Station>& stations);

}  // namespace jw::site
