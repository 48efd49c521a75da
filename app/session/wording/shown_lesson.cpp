#include "app/session/wording/shown_lesson.hpp"

#include "app/session/wording/messages.hpp"
#include "lessons/in_language.hpp"

namespace jw {

Lesson shown_lesson(Lesson lesson) { return in_language(std::move(lesson), language()); }

Text shown_text(Text text) {
    text.show(language());
    return text;
}

}  // namespace jw
