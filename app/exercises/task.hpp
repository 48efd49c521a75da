#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "app/exercises/asked.hpp"

/// Exercises as students get them.
namespace jw {

/// An exercise of one student. Mistakes that always give the same answer are one; all that are left differ
/// from the right answer and from each other by more than ten tolerances.
struct Task {
    Variant variant;
    Asked asked;
    std::vector<std::string> shown;  ///< choices or items in the order in which they are shown
    std::vector<int> place;          ///< of those in the exercise: shown[k] is the place[k]-th
    int draws = 1;                   ///< how many variants were drawn before this one was accepted
    std::string problem;             ///< why there is none; empty if there is one

    const Exercise& exercise() const { return *variant.exercise; }
};

/// Makes the tasks of one exercise. `exercise` must outlive it and its tasks.
class TaskMaker {
public:
    /// @param stop  who no longer wants tasks asks for this: the maker then has a problem
    explicit TaskMaker(const Exercise& exercise, const std::stop_token& stop = {});

    /// Task of a seed, always the same: of the exercise or of one of its alternatives. It has a problem where
    /// it was stopped.
    Task make(std::uint64_t seed, const std::stop_token& stop = {}) const;
    /// Why no task can be made; empty otherwise.
    const std::string& problem() const { return problem_; }

private:
    void find_groups(const std::stop_token& stop);
    bool accept(Task& task, std::string& why) const;

    const Exercise* exercise_;
    std::shared_ptr<const FormulaPlan> plan_;
    /// For each mistake the first one that always gives the same answer; −1: it is none here, since its
    /// answer is the right one, or has another shape.
    std::vector<int> leader_;
    std::string problem_;
    std::vector<TaskMaker> alternatives_;
};

}  // namespace jw
