#include "tests/fuzz/tasks.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "lessons/exercise/read_exercises.hpp"
#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

namespace {

struct Wanted {
    const char* file;
    const char* name;
};
constexpr std::array kWanted{Wanted{"vectors", "n1-value"},       Wanted{"vectors", "d-vector"},
                             Wanted{"vectors", "skew-matrix"},    Wanted{"vectors", "n2-which"},
                             Wanted{"vectors", "proof-order"},    Wanted{"vectors", "dropped-component"},
                             Wanted{"vectors", "dropped-code"},   Wanted{"orientation", "pose-of-gate"},
                             Wanted{"orientation", "angle-of-p"}, Wanted{"building", "hang-a-door"},
                             Wanted{"clinic", "rope-too-long"},   Wanted{"experiments", "drop-what-fails"}};

Exercise read(const Wanted& wanted) {
    const std::string file = std::string(JW_SOURCE_ROOT) + "/lessons/exercises/" + wanted.file + ".toml";
    const ExercisesRead read = read_exercise_file(file);
    const auto found = std::ranges::find(read.exercises, wanted.name, &Exercise::name);
    if (found == read.exercises.end()) { throw std::runtime_error(file + " has no exercise " + wanted.name); }
    return *found;
}

std::vector<Task> made() {
    // static, because tasks point to their exercises
    static const std::vector<Exercise> exercises = [] {
        std::vector<Exercise> all;
        std::ranges::transform(kWanted, std::back_inserter(all), read);
        return all;
    }();
    std::vector<Task> all;
    for (const Exercise& exercise : exercises) {
        all.push_back(TaskMaker(exercise).make(1));
        if (!all.back().problem.empty()) {
            throw std::runtime_error(exercise.name + ": " + all.back().problem);
        }
    }
    return all;
}

}  // namespace

const std::vector<Task>& tasks() {
    static const std::vector<Task> all = made();
    return all;
}

Judged judged(const Task& task, const Handed& handed) {
    const Judged verdict = kind_of(task.exercise().kind).judge(task, handed);
    const std::string& name = task.exercise().name;
    promise(verdict.share >= 0.0 && verdict.share <= 1.0, name + ": a share of the points");
    promise(verdict.right == (verdict.share == 1.0), name + ": all points exactly if it is right");
    promise(
        verdict.understood || (!verdict.right && verdict.share == 0.0),
        name + ": no points for what nobody understands");
    promise(verdict.right || !verdict.feedback.empty(), name + ": a sentence for what is not right");
    return verdict;
}

}  // namespace jw::fuzz
