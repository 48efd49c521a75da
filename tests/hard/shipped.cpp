#include "tests/hard/shipped.hpp"

#include <stdexcept>

#include "app/session/story/story.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"

namespace jw::hard {

Lesson shipped_lesson(std::string_view name) {
    const ReadResult read = read_lesson_file(catalogue_folder() / name);
    if (!read.lesson) { throw std::runtime_error(read.report()); }
    return *read.lesson;
}

State assembled(const Lesson& lesson) {
    const Story story(lesson, poses_only());
    if (story.failure() != nullptr) { throw std::runtime_error("the lesson does not close"); }
    return story.steps().back().state;
}

}  // namespace jw::hard
