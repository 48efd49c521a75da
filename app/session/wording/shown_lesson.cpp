#include "app/session/wording/shown_lesson.hpp"

#include <string_view>

#include "app/session/wording/messages.hpp"
#include "lessons/lesson/in_language.hpp"

namespace jw {

Lesson shown_lesson(Lesson lesson) { return in_language(std::move(lesson), language()); }

Exercise shown_exercise(Exercise exercise) {
    for_each_text(exercise, [](Text& text) { text.show(language()); });
    return exercise;
}

Text shown_text(Text text) {
    text.show(language());
    return text;
}

std::string shown_slides(const std::string& source) {
    constexpr std::string_view kOne = "slide ";
    constexpr std::string_view kSeveral = "slides ";
    if (source.starts_with(kOne)) { return tr("slide {0}", source.substr(kOne.size())); }
    if (source.starts_with(kSeveral)) { return tr("slides {0}", source.substr(kSeveral.size())); }
    return source;
}

}  // namespace jw
