#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/exercises/asked.hpp"
#include "app/exercises/random.hpp"

/// Exercises in the form in which students get them.
namespace jw {

/// An exercise of one student. Mistakes that always give the same answer are merged; the answers of the
/// others differ from the right answer and from each other by more than ten tolerances.
struct Task {
    Variant variant;
    Asked asked;
    std::vector<std::string> shown;  ///< choices or items in the order in which they are shown
    std::vector<int> place;          ///< their places in the exercise: shown[k] is number place[k]
    int draws = 1;                   ///< how many variants were drawn before this one was accepted
    std::string problem;             ///< why there is no task; empty if there is one

    const Exercise& exercise() const { return *variant.exercise; }
};

/// Makes the tasks of one exercise. `exercise` must outlive this and its tasks.
class TaskMaker {
public:
    explicit TaskMaker(const Exercise& exercise);
    /// A maker that does not tell its mistakes apart until `learn` has finished.
    static TaskMaker unlearned(const Exercise& exercise);
    /// Draws one of the variants that tell mistakes apart. @return true while there is more to do
    bool learn();

    /// Task of a seed, always the same: from the exercise or from one of its alternatives.
    Task make(std::uint64_t seed) const;
    /// Reason why no task can be made; empty otherwise.
    const std::string& problem() const { return problem_; }

private:
    friend class TaskDraft;
    struct Unlearned {};
    TaskMaker(const Exercise& exercise, Unlearned);

    bool draw_sample();
    void find_groups();
    bool accept(Task& task, std::string& why) const;
    const TaskMaker& chosen_by(std::uint64_t seed) const;

    const Exercise* exercise_;
    std::shared_ptr<const FormulaPlan> plan_;
    std::vector<Asked> samples_;
    int samples_drawn_ = 0;
    bool is_learned_ = false;
    /// For each mistake, the first one that always gives the same answer; −1: it is not a mistake here, since
    /// its answer is the right one or has another shape.
    std::vector<int> leader_;
    std::string problem_;
    std::vector<TaskMaker> alternatives_;
};

/// A task that is being made: variants are drawn until one can be used.
class TaskDraft {
public:
    /// `maker` must outlive this, and its `learn` must have finished.
    TaskDraft(const TaskMaker& maker, std::uint64_t seed);
    /// Draws one variant. @return true while there is more to do
    bool draw();
    /// The task, once there is nothing more to do; it may have a problem.
    const Task& task() const { return task_; }

private:
    const TaskMaker* maker_;
    std::uint64_t seed_;  ///< of the next variant
    Random random_;
    Task task_;
    std::string why_;  ///< why the last variant could not be used
};

}  // namespace jw
