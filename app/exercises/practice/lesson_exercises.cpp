#include "app/exercises/practice/lesson_exercises.hpp"

#include <algorithm>
#include <utility>

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

LessonExercisesReader::LessonExercisesReader(const fs::path& lesson_file, const fs::path& lessons_folder)
    : lesson_(lesson_name(lesson_file)), files_(exercise_files_of(lessons_folder)) {
    std::ranges::reverse(files_);
    files_.push_back(lesson_file);
}

bool LessonExercisesReader::read() {
    if (files_.empty()) { return false; }
    const fs::path file = std::move(files_.back());
    files_.pop_back();
    // reading a whole file costs more than finding out which lessons it names
    if (!exercises_of_lesson(exercises_named_in(file), lesson_).empty()) {
        add_exercises_of(file, lesson_, found_);
    }
    return true;
}

}  // namespace jw
