#include "app/host/tabs/exercise_labels.hpp"

#include "app/exercises/kinds.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/exercise/read_exercises.hpp"

namespace jw::host {

namespace {

std::string points_text(double points) {
    return points == 1.0 ? std::string(tr("1 point")) : tr("{0} points", number_text(points, 4));
}

/// "new", "tried", "solved 3 times, the last 2 in a row"
std::string record_text(const ExerciseRecord& record) {
    if (record.solved == 0) { return record.tried == 0 ? tr("new") : tr("tried"); }
    if (record.solved == 1) { return tr("solved"); }
    return record.streak > 1 ? tr("solved {0} times, the last {1} in a row", record.solved, record.streak)
                             : tr("solved {0} times", record.solved);
}

std::string how_without_unit(const Task& task) {
    const bool counts = task.asked.tolerance == 0.0;
    switch (task.exercise().kind) {
        case ExerciseKind::repair:
            return tr(
                "Mend the lesson: in this field, with 'Try it', or in an editor. Change as little as "
                "possible.");
        case ExerciseKind::build:
            return tr(
                "Add joints at the end of the lesson: in this field or in an editor. Leave the rest as it "
                "is.");
        case ExerciseKind::experiment:
            return tr(
                "Do experiments with the lesson in 'Try it'. Those that you do are listed here and judged.");
        case ExerciseKind::code:
            return tr("Write a program: .py, .cpp, .m or .js. It reads JSON and writes JSON.");
        case ExerciseKind::choose: return tr("Press the number of a choice, or type it.");
        case ExerciseKind::number:
            if (counts) { return tr("Write a whole number."); }
            break;
        default: break;
    }
    return tr(kind_of(task.exercise().kind).hand_in);
}

}  // namespace

std::string facts_of(const Exercise& exercise, const ExerciseRecord& record) {
    return std::string(tr(label_of(kExerciseKinds, exercise.kind))) + "   ·   " +
           points_text(exercise.points) + "   ·   " + record_text(record);
}

std::string what_is_allowed(const Exercise& exercise) {
    const std::string where = exercise.source.empty() ? "" : shown_slides(exercise.source) + "   ·   ";
    return where + (exercise.allowed == Allowed::paper ? tr("on paper: the answer cannot be read off here")
                                                       : tr("the program may be used"));
}

std::string inputs_of_program(const Exercise& exercise) {
    std::string names;
    for (const std::string& name : input_names(exercise)) { names += (names.empty() ? "" : ", ") + name; }
    return tr("Inputs of a case: {0}.", names);
}

std::string how_to_answer(const Task& task) {
    std::string how = how_without_unit(task);
    if (!task.asked.unit.empty()) { how += " " + tr("The answer is in {0}.", task.asked.unit); }
    if (is_of_numbers(task.exercise().kind)) {
        how += std::string(" ") + tr("Type the answer; Enter checks it.");
    }
    return how;
}

std::string title_of(const Judged& judged) {
    if (judged.right) { return tr("Right."); }
    if (!judged.title.empty()) { return tr("Not correct: {0}.", judged.title); }
    return judged.understood ? tr("Not correct.") : tr("Not understood.");
}

bool is_file(ExerciseKind kind) { return kind == ExerciseKind::repair || kind == ExerciseKind::build; }

bool is_of_numbers(ExerciseKind kind) {
    return is_measured(kind) || kind == ExerciseKind::choose || kind == ExerciseKind::order;
}

}  // namespace jw::host
