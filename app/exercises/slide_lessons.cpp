#include "app/exercises/slide_lessons.hpp"

#include <algorithm>
#include <utility>

#include "app/session/wording/shown_lesson.hpp"
#include "lessons/files/course.hpp"
#include "lessons/read/reader.hpp"

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

std::optional<SlideLesson> slide_lesson_in(const fs::path& file) {
    const ReadResult read = read_lesson_file(file);
    if (!read.lesson) { return {}; }
    const Lesson lesson = shown_lesson(*read.lesson);
    return SlideLesson{file, lesson.title, lesson.text, lesson.summary, slides_in(lesson.source)};
}

std::vector<SlideLesson> lessons_of_slides(const fs::path& lessons_folder) {
    std::vector<SlideLesson> found;
    for (const CourseLessons::Entry& entry : course_lessons(lessons_folder).lessons) {
        if (auto lesson = slide_lesson_in(entry.file)) { found.push_back(std::move(*lesson)); }
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
