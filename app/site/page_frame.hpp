#pragma once

#include <string>
#include <string_view>

#include "app/site/site_course.hpp"

/// Parts that all pages of a site share. Pages are HTML that is also well-formed XML, so that tests can read
/// them. They use only scripts and files of the site, and their content security policy says so.
namespace jw::site {

/// Path, title and description of a page.
struct PageFrame {
    std::string path;         ///< below the top of the site, with slashes: "lessons/loops/four-bar.html"
    std::string title;        ///< in Unicode
    std::string description;  ///< for search engines, in Unicode; may be empty
};

std::string page_html(const SiteCourse& course, const PageFrame& page, const std::string& content);

/// Relative path from a page to the top of the site: "../../"; empty for pages at the top.
std::string way_to_top(std::string_view path);

/// Text with formulas between dollar signs, in one line or several, as HTML without paragraphs.
std::string words_html(const std::string& words);
/// Such a text as HTML with paragraphs: a blank line begins the next one.
std::string paragraphs_html(const std::string& words);
/// Such a text in plain Unicode, in one line.
std::string words_plain(const std::string& words);

std::string link_html(const std::string& address, const std::string& content, const char* classes = "");

/// Path of a file for an address: "a b/c#.html" becomes "a%20b/c%23.html".
std::string path_in_address(const std::string& path);

/// "slides 3, 8; book ch. 7" with a link from each slide to its part of slides.html.
std::string source_html(const std::string& source, const std::string& top);

}  // namespace jw::site
