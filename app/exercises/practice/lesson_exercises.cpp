#include "app/exercises/practice/lesson_exercises.hpp"

#include <algorithm>

#include "lessons/course.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/reader.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

/// Adds the exercises of a file that belong to the lesson.
void add_exercises_of(const fs::path& file, const std::string& lesson, LessonExercises& found) {
    ExercisesRead read = read_exercise_file(file);
    if (read.exercises.empty() && !read.diagnostics.empty()) {
        found.problem += (found.problem.empty() ? "" : "\n") + file.filename().string() + ": " +
                         read.diagnostics.front().message;
    }
    for (Exercise& exercise : read.exercises) {
        if (exercise.lesson != lesson) { continue; }
        const std::string key = record_key(file, exercise.name);
        found.exercises.push_back({std::make_shared<const Exercise>(std::move(exercise)), key});
    }
}

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

std::string record_key(const fs::path& file, const std::string& name) {
    return lesson_name(file) + "/" + name;
}

LessonExercises exercises_to_practise(
    const fs::path& lesson_file, const fs::path& lessons_folder, const std::stop_token& stop) {
    const std::string lesson = lesson_name(lesson_file);
    std::vector<fs::path> files{lesson_file};
    const std::vector<fs::path> beside = exercise_files_of(lessons_folder);
    files.insert(files.end(), beside.begin(), beside.end());
    LessonExercises found;
    for (const fs::path& file : files) {
        // reading a file costs more than looking which lessons it names
        const bool has_some = !exercises_of_lesson(exercises_named_in(file), lesson).empty();
        if (has_some && !stop.stop_requested()) { add_exercises_of(file, lesson, found); }
    }
    return found;
}

std::vector<SlideLesson> lessons_of_slides(const fs::path& lessons_folder, const std::stop_token& stop) {
    std::vector<SlideLesson> found;
    for (const CourseLessons::Entry& entry : course_lessons(lessons_folder).lessons) {
        if (stop.stop_requested()) { break; }
        const ReadResult read = read_lesson_file(entry.file);
        if (!read.lesson) { continue; }
        std::vector<SlideRange> slides = slides_in(read.lesson->source);
        if (!slides.empty()) { found.push_back({entry.file, read.lesson->title, std::move(slides)}); }
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
