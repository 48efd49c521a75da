#include "app/exercises/slide_lessons.hpp"

#include <algorithm>

#include "app/session/wording/shown_lesson.hpp"
#include "lessons/course.hpp"
#include "lessons/reader.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

int slides_in_all(const std::vector<SlideRange>& slides) {
    int count = 0;
    for (const SlideRange& range : slides) { count += range.last - range.first + 1; }
    return count;
}

bool has_slide(const SlideLesson& lesson, const SlideRange& wanted) {
    return std::ranges::any_of(lesson.slides, [&](const SlideRange& range) {
        return range.first <= wanted.first && wanted.first <= range.last;
    });
}

}  // namespace

std::vector<SlideLesson> lessons_of_slides(const fs::path& lessons_folder, const std::stop_token& stop) {
    std::vector<SlideLesson> found;
    for (const CourseLessons::Entry& entry : course_lessons(lessons_folder).lessons) {
        if (stop.stop_requested()) { break; }
        const ReadResult read = read_lesson_file(entry.file);
        if (!read.lesson) { continue; }
        const Lesson lesson = shown_lesson(*read.lesson);
        found.push_back({entry.file, lesson.title, lesson.text, lesson.summary, slides_in(lesson.source)});
    }
    return found;
}

const SlideLesson* lesson_of_slide(const std::vector<SlideLesson>& lessons, const std::string& slide) {
    const std::vector<SlideRange> wanted = slides_in(slide);
    const SlideLesson* best = nullptr;
    for (const SlideLesson& lesson : lessons) {
        if (wanted.empty() || !has_slide(lesson, wanted.front())) { continue; }
        const bool is_better = best == nullptr || slides_in_all(lesson.slides) < slides_in_all(best->slides);
        if (is_better) { best = &lesson; }
    }
    return best;
}

}  // namespace jw
