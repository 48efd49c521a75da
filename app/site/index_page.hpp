#pragma once

#include <string>

#include "app/site/page_frame.hpp"

/// Pages about the whole course.
namespace jw::site {

std::string id_of_chapter(const SiteCourse& course, const SiteChapter& chapter);

/// The lessons by chapter, with a search.
std::string index_page(const SiteCourse& course);
/// Words of all lessons as a script, for the search: the same words as those of `jointwise list`.
std::string search_data(const SiteCourse& course);
/// For each slide the lessons and exercises about it.
std::string slides_page(const SiteCourse& course);

}  // namespace jw::site
