#pragma once

#include <string>
#include <vector>

#include "app/exercises/slide_lessons.hpp"
#include "lessons/lesson/exercise.hpp"

/// Lessons that answer the mistakes of a class, within the page about it.
namespace jw {

class AnsweringLessons {
public:
    /// Both must outlive it.
    AnsweringLessons(const std::vector<SlideLesson>& lessons, const std::vector<Exercise>& exercises)
        : lessons_(&lessons), exercises_(&exercises) {}

    /// The lesson of the slide that a mistake names, else the lesson that its exercise belongs to, else the
    /// lesson of the exercise's source; nullptr if there is none.
    const SlideLesson* find(const std::string& exercise, const std::string& slide) const;

private:
    const std::vector<SlideLesson>* lessons_;
    const std::vector<Exercise>* exercises_;
};

/// A link to the section of a lesson; with the slide before it if there is one.
std::string lesson_link(const SlideLesson& lesson, const std::string& slide);
/// The first text of a lesson, its summary, and how to open it.
std::string lesson_section(const SlideLesson& lesson);

}  // namespace jw
