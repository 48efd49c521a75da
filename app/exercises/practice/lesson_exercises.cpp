#include "app/exercises/practice/lesson_exercises.hpp"

#include "app/session/wording/shown_lesson.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/read_exercises.hpp"

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
        found.exercises.push_back(
            {std::make_shared<const Exercise>(shown_exercise(std::move(exercise))), key});
    }
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

}  // namespace jw
