#include "lessons/lesson/in_language.hpp"

namespace jw {

Lesson in_language(Lesson lesson, std::string_view tag) {
    for_each_text(lesson, [&](Text& text) { text.show(tag); });
    return lesson;
}

}  // namespace jw
