#include "app/site/page_frame.hpp"

#include <algorithm>

#include "app/session/encoding/base64.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw::site {

namespace {

constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; frame-src 'self'; connect-src "
    "'self'; worker-src 'self'; base-uri 'none'; form-action 'none'";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Paragraphs of a text, which blank lines separate, each in one line.
std::vector<std::string> paragraphs_of(const std::string& text) {
    std::vector<std::string> paragraphs;
    std::size_t begin = 0;
    std::size_t line = 0;
    while (line <= text.size()) {
        const std::size_t end = std::min(text.find('\n', line), text.size());
        const bool blank = std::all_of(
            text.begin() + static_cast<std::ptrdiff_t>(line), text.begin() + static_cast<std::ptrdiff_t>(end),
            is_blank);
        if (blank || end == text.size()) {
            std::string paragraph = in_one_line(text.substr(begin, end - begin));
            if (!paragraph.empty()) { paragraphs.push_back(std::move(paragraph)); }
            begin = end;
        }
        line = end + 1;
    }
    return paragraphs;
}

std::string head_html(const SiteCourse& course, const PageFrame& page, const std::string& top) {
    std::string html =
        "<head>\n<meta charset=\"utf-8\" />\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
        std::string(kPolicy) + "\" />\n<title>" + markup_text(page.title) + "</title>\n";
    if (!page.description.empty()) {
        html += "<meta name=\"description\" content=\"" + markup_text(page.description) + "\" />\n";
    }
    return html + "<meta name=\"generator\" content=\"" + markup_text(course.program) +
           "\" />\n<link rel=\"icon\" href=\"" + top + "icon.svg\" type=\"image/svg+xml\" />\n" +
           "<link rel=\"stylesheet\" href=\"" + top + "site.css\" />\n<script src=\"" + top +
           "site.js\" defer=\"defer\"></script>\n</head>\n";
}

}  // namespace

std::string way_to_top(std::string_view path) {
    std::string way;
    for (const char c : path) {
        if (c == '/') { way += "../"; }
    }
    return way;
}

std::string words_html(const std::string& words) { return html_words(in_one_line(words)); }

std::string paragraphs_html(const std::string& words) {
    std::string html;
    for (const std::string& paragraph : paragraphs_of(words)) {
        html += "<p>" + html_words(paragraph) + "</p>\n";
    }
    return html;
}

std::string words_plain(const std::string& words) { return in_one_line(math::plain_words(words)); }

std::string link_html(const std::string& address, const std::string& content, const char* classes) {
    const std::string kind = *classes == '\0' ? std::string() : " class=\"" + std::string(classes) + '"';
    return "<a" + kind + " href=\"" + markup_text(address) + "\">" + content + "</a>";
}

std::string path_in_address(const std::string& path) { return percent_encoded(path, "-._~/"); }

std::string source_html(const std::string& source, const std::string& top) {
    const std::string shown = shown_slides(source);
    const std::vector<int> slides = slide_numbers(source);
    // after the semicolon come books, whose numbers are not slides
    const std::size_t end = std::min(shown.find(';'), shown.size());
    std::string html;
    for (std::size_t k = 0; k < shown.size();) {
        std::size_t next = k;
        while (next < end && is_digit(shown[next])) { ++next; }
        const std::string number = shown.substr(k, next - k);
        // longer numbers cannot be in `slides`
        const bool known = !number.empty() && number.size() < 6 &&
                           std::ranges::find(slides, std::stoi(number)) != slides.end();
        if (known) {
            html += link_html(top + "slides.html#slide-" + number, number);
            k = next;
        } else {
            next = std::max(next, k + 1);
            while (next < shown.size() && !is_digit(shown[next])) { ++next; }
            html += markup_text(shown.substr(k, next - k));
            k = next;
        }
    }
    return html;
}

std::string page_html(const SiteCourse& course, const PageFrame& page, const std::string& content) {
    const std::string top = way_to_top(page.path);
    return "<!DOCTYPE html>\n<html lang=\"" + std::string(language()) + "\">\n" +
           head_html(course, page, top) + "<body>\n" +
           link_html("#content", markup_text(tr("Skip to the content")), "skip") +
           "\n<header class=\"site\">\n" + link_html(top + "index.html", words_html(course.title), "course") +
           "\n<nav aria-label=\"" + markup_text(tr("Course")) + "\">\n" +
           link_html(top + "index.html", markup_text(tr("Lessons"))) + "\n" +
           link_html(top + "slides.html", markup_text(tr("Slides"))) + "\n" +
           link_html(top + "live/index.html", markup_text(tr("Program"))) +
           "\n</nav>\n</header>\n<main id=\"content\">\n" + content + "</main>\n<footer>" +
           markup_text(course.program) + "</footer>\n</body>\n</html>\n";
}

}  // namespace jw::site
