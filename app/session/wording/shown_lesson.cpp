#include "app/session/wording/shown_lesson.hpp"

#include "app/session/wording/messages.hpp"
#include "lessons/exercise/exercise_texts.hpp"
#include "lessons/in_language.hpp"

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

}  // namespace jw
