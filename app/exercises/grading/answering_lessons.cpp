#include "app/exercises/grading/answering_lessons.hpp"

#include <algorithm>

#include "app/session/encoding/html_words.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/exercise/exercise_index.hpp"

namespace jw {

namespace {

/// "vectors/frames" as "lesson-vectors-frames"
std::string anchor_of(const SlideLesson& lesson) {
    std::string anchor = "lesson-" + lesson_name(lesson.file);
    std::ranges::replace(anchor, '/', '-');
    return anchor;
}

}  // namespace

const SlideLesson* AnsweringLessons::find(const std::string& exercise, const std::string& slide) const {
    if (const SlideLesson* const of_slide = lesson_of_slide(*lessons_, slide)) { return of_slide; }
    const auto asked = std::ranges::find(*exercises_, exercise, &Exercise::name);
    if (asked == exercises_->end()) { return nullptr; }
    const auto own = std::ranges::find_if(
        *lessons_, [&](const SlideLesson& lesson) { return lesson_name(lesson.file) == asked->lesson; });
    return own != lessons_->end() ? &*own : lesson_of_slide(*lessons_, asked->source);
}

std::string lesson_link(const SlideLesson& lesson, const std::string& slide) {
    return "<a href=\"#" + markup_text(anchor_of(lesson)) + "\">" +
           (slide.empty() ? "" : markup_text(shown_slides(slide)) + ": ") + html_words(lesson.title) + "</a>";
}

std::string lesson_section(const SlideLesson& lesson) {
    const std::string name = lesson_name(lesson.file);
    std::string html = "<h3 id=\"" + markup_text(anchor_of(lesson)) + "\">" + html_words(lesson.title) +
                       " <small>(" + markup_text(name) + ")</small></h3>\n<p>" + html_words(lesson.text) +
                       "</p>\n";
    if (!lesson.summary.empty()) { html += "<p><b>" + html_words(lesson.summary) + "</b></p>\n"; }
    return html + "<p>" + markup_text(tr("In the program:")) + " <code>jointwise open lessons/catalogue/" +
           markup_text(name) + ".toml</code></p>\n";
}

}  // namespace jw
