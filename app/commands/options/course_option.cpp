#include "app/commands/options/course_option.hpp"

#include <algorithm>

#include "app/session/wording/shown_lesson.hpp"
#include "lessons/exercise/read_exercises.hpp"

namespace jw {

ExerciseSet exercises_of(const std::vector<std::string>& files) {
    ExerciseSet set;
    std::string report;
    for (const std::string& file : files) {
        ExercisesRead read = read_exercise_file(file);
        report += read.report();
        if (set.title.empty()) { set.title = shown_text(read.title); }
        for (Exercise& exercise : read.exercises) {
            exercise = shown_exercise(std::move(exercise));
            if (std::ranges::find(set.exercises, exercise.name, &Exercise::name) != set.exercises.end()) {
                report += file + ": error: there are two exercises '" + exercise.name +
                          "' in these files; expected each name once\n";
            }
            set.exercises.push_back(std::move(exercise));
        }
    }
    if (!report.empty()) { throw CommandError(Exit::bad_input, report); }
    return set;
}

CourseKey key_of(const std::string& file) {
    CourseKey key = read_course_key(file);
    if (!key.problem.empty()) { throw CommandError(Exit::bad_input, key.problem); }
    return key;
}

ReadyCourse ready_or_refused(const CourseKey& key, const ExerciseSet& set) {
    ReadyCourse course = ready_course(key.secret, set.exercises);
    if (!course.problem.empty()) { throw bad_input("no variants can be drawn:\n" + course.problem); }
    return course;
}

}  // namespace jw
