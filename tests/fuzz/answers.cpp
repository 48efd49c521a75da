#include <set>

#include "lessons/exercise/handed_in.hpp"
#include "tests/fuzz/diagnostics.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/tasks.hpp"

namespace jw::fuzz {

namespace {

bool is_answered_in_text(const Task& task) {
    const ExerciseKind kind = task.exercise().kind;
    return std::string(kind_of(kind).file).empty() && kind != ExerciseKind::experiment;
}

/// Promises that no answer is graded a second time under other words of the file.
void promise_graded_once(const HandedIn& handed) {
    std::set<std::string> graded;
    double points = 0.0;
    double most = 0.0;
    for (const Task& task : tasks()) {
        const auto answer = handed.answers.find(task.exercise().name);
        if (!is_answered_in_text(task) || answer == handed.answers.end()) { continue; }
        promise(graded.insert(answer->first).second, answer->first + " is graded once");
        points += judged(task, {answer->second.text, {}}).share * task.exercise().points;
        most += task.exercise().points;
    }
    promise(points <= most, "no more points than there are");
}

}  // namespace

bool check_answers(const std::string& input) {
    const HandedIn handed = read_answers_text(input);
    if (!handed.problem.empty()) {
        promise_reported_places(handed.problem, input);
        return false;
    }
    promise(fault_of_student(handed.student).empty(), "a submission has a student");
    promise_graded_once(handed);
    // a second table of answers must make the file invalid: nothing can be handed in twice
    const std::string twice = input + "\n[answers]\n";
    promise(!read_answers_text(twice).problem.empty(), "a second table of answers is refused");
    return true;
}

}  // namespace jw::fuzz
