#pragma once

#include <string>
#include <string_view>

#include "app/site/site_course.hpp"

/// Parts that all pages of a site share. Pages are HTML that is well-formed XML, too, so that tests can read
/// them; they run no script and load no file but the site's own, which their content security policy says.
namespace jw::site {

/// A page and its place.
struct PageFrame {
    std::string path;         ///< below the top of the site, with slashes: "lessons/loops/four-bar.html"
    std::string title;        ///< in Unicode
    std::string description;  ///< for search engines, in Unicode; may be empty
};

std::string page_html(const SiteCourse& course, const PageFrame& page, const std::string& content);

/// Way from a page to the top of the site: "../../", empty for pages there.
std::string way_to_top(std::string_view path);

/// Words with formulas between dollar signs, in one line of an editor or several, as HTML of one line.
std::string words_html(const std::string& words);
/// Words likewise, in paragraphs: a blank line begins the next.
std::string paragraphs_html(const std::string& words);
/// Words in Unicode alone, in one line.
std::string words_plain(const std::string& words);

std::string link_html(const std::string& address, const std::string& content, const char* classes = "");

/// Path of a file for an address: "a b/c#.html" becomes "a%20b/c%23.html".
std::string path_in_address(const std::string& path);

/// "slides 3, 8; book ch. 7" with links to what the site knows of each slide.
std::string source_html(const std::string& source, const std::string& top);

}  // namespace jw::site
