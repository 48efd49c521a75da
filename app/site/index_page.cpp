#include "app/site/index_page.hpp"

#include <map>

#include "app/session/encoding/html_words.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"
#include "app/site/lesson_page.hpp"

namespace jw::site {

namespace {

std::string card_html(const SiteLesson& lesson) {
    std::string html = "<li data-lesson=\"" + markup_text(lesson.name) + "\"><a href=\"" +
                       path_in_address(path_of_page(lesson)) +
                       "\"><img loading=\"lazy\" width=\"400\" height=\"250\" alt=\"\" src=\"" +
                       path_in_address(path_of_card(lesson)) + "\" />\n<span class=\"title\">" +
                       words_html(lesson.lesson.title) + "</span></a>\n";
    std::string about;
    if (!lesson.lesson.source.empty()) { about = source_html(lesson.lesson.source, ""); }
    if (!lesson.exercises.empty()) {
        about +=
            (about.empty() ? "" : " · ") +
            markup_text(tr_count(static_cast<int>(lesson.exercises.size()), "{0} exercise", "{0} exercises"));
    }
    return html + "<p class=\"source\">" + about + "</p></li>\n";
}

std::string chapter_html(const SiteCourse& course, const SiteChapter& chapter) {
    const std::string id = id_of_chapter(course, chapter);
    std::string html = "<section class=\"chapter\" id=\"" + id + "\">\n<h2>" + words_html(chapter.title) +
                       "</h2>\n" + paragraphs_html(chapter.about);
    std::string needs;
    for (const std::string& needed : chapter.needs) {
        needs += (needs.empty() ? "" : ", ") + words_html(needed);
    }
    if (!needs.empty()) {
        html += "<p class=\"needs\">" + markup_text(tr("Comes after:")) + ' ' + needs + "</p>\n";
    }
    html += "<ul class=\"cards\">\n";
    for (const std::size_t lesson : chapter.lessons) { html += card_html(course.lessons[lesson]); }
    return html + "</ul>\n</section>\n";
}

std::string search_html() {
    // hidden until site.js shows it: the search needs scripts
    return "<form class=\"search\" role=\"search\" hidden=\"hidden\">\n<label for=\"search\">" +
           markup_text(tr("Search the lessons")) +
           "</label>\n<input id=\"search\" type=\"search\" placeholder=\"" +
           markup_text(tr("screw, Bennett, slide 8 …")) +
           "\" autocomplete=\"off\" />\n<p id=\"found\" role=\"status\" data-none=\"" +
           markup_text(tr("No lesson has all of these words.")) + "\" data-one=\"" +
           markup_text(tr("1 lesson")) + "\" data-several=\"" + markup_text(tr("{0} lessons", "#")) +
           "\"></p>\n</form>\n";
}

}  // namespace

std::string id_of_chapter(const SiteCourse& course, const SiteChapter& chapter) {
    return "chapter-" + std::to_string(&chapter - course.chapters.data() + 1);
}

std::string index_page(const SiteCourse& course) {
    PageFrame page;
    page.path = "index.html";
    page.title = words_plain(course.title);
    std::string chapters;
    std::string content;
    for (const SiteChapter& chapter : course.chapters) {
        page.description += (page.description.empty() ? "" : ", ") + words_plain(chapter.title);
        chapters +=
            "<li>" + link_html('#' + id_of_chapter(course, chapter), words_html(chapter.title)) + "</li>\n";
        content += chapter_html(course, chapter);
    }
    const std::string contents = course.chapters.size() < 2
                                     ? std::string()
                                     : "<nav class=\"chapters\" aria-label=\"" + markup_text(tr("Chapters")) +
                                           "\">\n<ol>\n" + chapters + "</ol>\n</nav>\n";
    return page_html(
        course, page,
        "<div class=\"index\">\n<h1>" + words_html(course.title) + "</h1>\n" + search_html() + contents +
            content + "</div>\n");
}

std::string search_data(const SiteCourse& course) {
    Json lessons = Json::array();
    for (const SiteLesson& lesson : course.lessons) {
        Json slides = Json::array();
        for (const int slide : slide_numbers(lesson.lesson.source)) { slides.push_back(slide); }
        lessons.push_back({{"name", lesson.name}, {"words", lesson.searchable.words}, {"slides", slides}});
    }
    // the document ends with a line feed, which is cut off
    std::string data = json_document(lessons, -1);
    return "window.jointwiseLessons = " + data.substr(0, data.size() - 1) + ";\n";
}

std::string slides_page(const SiteCourse& course) {
    PageFrame page;
    page.path = "slides.html";
    page.title = tr("Slides") + (" – " + words_plain(course.title));
    std::map<int, std::string> by_slide;
    for (const SiteLesson& lesson : course.lessons) {
        const std::string address = path_in_address(path_of_page(lesson));
        for (const int slide : slide_numbers(lesson.lesson.source)) {
            by_slide[slide] += "<li>" + link_html(address, words_html(lesson.lesson.title)) + "</li>\n";
        }
        for (const Exercise& exercise : lesson.exercises) {
            for (const int slide : slide_numbers(exercise.source)) {
                by_slide[slide] +=
                    "<li>" + markup_text(tr("Exercise:")) + ' ' +
                    link_html(address + "#exercise-" + exercise.name, words_html(exercise.title)) + "</li>\n";
            }
        }
    }
    std::string content =
        "<div class=\"slides\">\n<h1>" + markup_text(tr("Slides")) + "</h1>\n<p>" +
        markup_text(
            by_slide.empty() ? tr("No lesson names a slide as its source.")
                             : tr("The slides of the lecture, with the lessons and exercises about them.")) +
        "</p>\n";
    for (const auto& [slide, items] : by_slide) {
        const std::string title = markup_text(tr("Slide {0}", slide));
        content +=
            "<section id=\"slide-" + std::to_string(slide) + "\">\n<h2>" +
            (course.slides.empty() ? title
                                   : link_html(course.slides + "#page=" + std::to_string(slide), title)) +
            "</h2>\n<ul>\n" + items + "</ul>\n</section>\n";
    }
    return page_html(course, page, content + "</div>\n");
}

}  // namespace jw::site
