#include "app/site/lesson_page.hpp"

#include "app/host/lesson/address.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/wording/messages.hpp"
#include "app/site/index_page.hpp"
#include "app/site/lesson_parts.hpp"

namespace jw::site {

namespace {

/// Place of a lesson in the chapter that it belongs to.
struct PlaceInCourse {
    const SiteChapter* chapter = nullptr;
    std::size_t number = 0;  ///< from 1
};

PlaceInCourse place_in_course(const SiteCourse& course, std::size_t index) {
    for (const SiteChapter& chapter : course.chapters) {
        for (std::size_t k = 0; k < chapter.lessons.size(); ++k) {
            if (chapter.lessons[k] == index) { return {&chapter, k + 1}; }
        }
    }
    return {};
}

std::string head_html(const SiteCourse& course, std::size_t index, const std::string& top) {
    const SiteLesson& lesson = course.lessons[index];
    const PlaceInCourse place = place_in_course(course, index);
    std::string html = "<header class=\"lesson\">\n";
    if (place.chapter != nullptr) {
        html += "<p class=\"chapter\">" +
                link_html(
                    top + "index.html#" + id_of_chapter(course, *place.chapter),
                    words_html(place.chapter->title)) +
                " · " + markup_text(tr("{0} of {1}", place.number, place.chapter->lessons.size())) + "</p>\n";
    }
    html += "<h1>" + words_html(lesson.lesson.title) + "</h1>\n";
    if (!lesson.lesson.source.empty()) {
        html += "<p class=\"source\">" + source_html(lesson.lesson.source, top) + "</p>\n";
    }
    return html + paragraphs_html(lesson.lesson.text) + "</header>\n";
}

/// The live figure; it is a picture until it comes into view, and where it cannot run.
std::string live_html(const SiteLesson& lesson, const Story& story, const std::string& top) {
    host::Address address;
    address.lesson = lesson.address;
    address.at = std::to_string(story.last_assembled() + 1);
    const std::string live = top + live_address(fragment_of(address));
    return "<figure class=\"live\" id=\"live\">\n<div class=\"screen\">" +
           link_html(
               live, "<img src=\"" + top + path_in_address(path_of_frame(lesson)) +
                         "\" width=\"1280\" height=\"720\" alt=\"" +
                         markup_text(tr("The lesson in the program: {0}", words_plain(lesson.lesson.title))) +
                         "\" />") +
           "</div>\n<figcaption><span class=\"state\">" +
           markup_text(tr("Picture of the program; it runs here once it is loaded.")) + "</span> " +
           link_html(live, markup_text(tr("Open in its own window")), "own") + "</figcaption>\n</figure>\n";
}

std::string neighbours_html(const SiteCourse& course, std::size_t index, const std::string& top) {
    const auto neighbour = [&](std::size_t other, const char* kind, const char* words) {
        const SiteLesson& lesson = course.lessons[other];
        return "<a class=\"" + std::string(kind) + "\" rel=\"" + kind + "\" href=\"" + top +
               path_in_address(path_of_page(lesson)) + "\"><span>" + markup_text(words) + "</span> " +
               words_html(lesson.lesson.title) + "</a>\n";
    };
    std::string html;
    if (index > 0) { html += neighbour(index - 1, "prev", tr("Previous lesson")); }
    if (index + 1 < course.lessons.size()) { html += neighbour(index + 1, "next", tr("Next lesson")); }
    return html.empty() ? html
                        : "<nav class=\"neighbours\" aria-label=\"" +
                              markup_text(tr("Previous and next lesson")) + "\">\n" + html + "</nav>\n";
}

std::string foot_html(const SiteCourse& course, const SiteLesson& lesson, const std::string& top) {
    return "<p class=\"file\">" +
           link_html(
               top + path_in_address(path_of_source(course, lesson)),
               markup_text(tr("The file of this lesson"))) +
           "</p>\n";
}

std::string name_of_folder(const SiteLesson& lesson) { return "pictures/" + lesson.name + '/'; }

}  // namespace

std::string path_of_page(const SiteLesson& lesson) { return "lessons/" + lesson.name + ".html"; }
std::string path_of_frame(const SiteLesson& lesson) { return name_of_folder(lesson) + "frame.png"; }
std::string path_of_card(const SiteLesson& lesson) { return name_of_folder(lesson) + "card.png"; }
std::string path_of_picture(const SiteLesson& lesson, const Station& station) {
    return name_of_folder(lesson) + station.id + ".png";
}
std::string path_of_source(const SiteCourse& course, const SiteLesson& lesson) {
    return "course/" + lessons_folder_of(course) + '/' + lesson.name + ".toml";
}

std::string live_address(const std::string& fragment) { return "live/index.html#" + fragment; }

std::string lesson_page(
    const SiteCourse& course, std::size_t index, const Story& story, const std::vector<Station>& stations) {
    const SiteLesson& lesson = course.lessons[index];
    PageFrame page;
    page.path = path_of_page(lesson);
    page.title = words_plain(lesson.lesson.title) + " – " + words_plain(course.title);
    page.description = words_plain(lesson.lesson.text);
    const std::string top = way_to_top(page.path);
    const LessonParts parts{lesson, story, top};
    const std::string content = "<div class=\"lesson\">\n" + head_html(course, index, top) +
                                live_html(lesson, story, top) + "<article>\n" + parts.stations(stations) +
                                parts.questions() + parts.summary() + parts.trials() + parts.exercises() +
                                parts.claims() + foot_html(course, lesson, top) + "</article>\n</div>\n" +
                                neighbours_html(course, index, top);
    return page_html(course, page, content);
}

}  // namespace jw::site
