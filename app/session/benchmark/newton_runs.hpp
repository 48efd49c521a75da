#pragma once

#include <string>
#include <vector>

#include "app/session/benchmark/newton_comparison.hpp"
#include "app/session/output/json.hpp"
#include "core/poses/newton_methods.hpp"
#include "lessons/lesson/enum_words.hpp"

/// Newton's method in several ways from the same start in a story: the comparison of newton_comparison.hpp
/// with its numbers.
namespace jw {

/// The requested comparison: all methods in one choice of coordinates, or one method in all choices.
struct NewtonPlan {
    bool by_method = true;
    CoordinateChoice choice = CoordinateChoice::modified_euler_parameters;  ///< if methods are compared
    NewtonMethod method = NewtonMethod::stepwise_limited;                   ///< if coordinates are compared
    bool normalisation_rows = true;

    bool operator==(const NewtonPlan&) const = default;
};

inline constexpr std::array kNewtonMethods{
    EnumWord<NewtonMethod>{NewtonMethod::stepwise_limited, "limited", tr_later("turns limited to 0.5 rad")},
    EnumWord<NewtonMethod>{NewtonMethod::plain, "plain", tr_later("plain Newton")},
    EnumWord<NewtonMethod>{NewtonMethod::damped, "damped", tr_later("damped (line search)")},
    EnumWord<NewtonMethod>{
        NewtonMethod::levenberg_marquardt, "levenberg-marquardt", tr_later("Levenberg-Marquardt")}};

/// Index of the step from which a joint or driver is closed, -1 if the story does not reach it.
int start_of_closing(const Story& story, const Addition& subject);

/// Index of the step from which that joint or driver is closed that shows most about Newton's method: a wrong
/// branch is left, or else the most iterations happen. The first of several; -1 if nothing is added.
int start_of_telling_closing(const Story& story);

struct NewtonRuns {
    std::string title;  ///< "Closing D from the same start, methods in rp-modified"
    std::vector<std::string> names;
    std::vector<NewtonTrace> traces;
    std::vector<std::string> wrong_branches;  ///< in words, empty where there is none
    NewtonComparison comparison;
};

/// @param start  index of a step of kind equations
NewtonRuns run_newton(const Story& story, int start, const NewtonPlan& plan);

/// Runs the next way of a comparison, for callers that do other work in between.
/// @param runs  empty at first; the comparison is made with the last way
/// @return false if all ways have been run already
bool run_next_way(const Story& story, int start, const NewtonPlan& plan, NewtonRuns& runs);
std::size_t ways_of(const NewtonPlan& plan);

std::string describe(const NewtonRuns& runs);
Json json_of(const NewtonRuns& runs, const Lesson& lesson);

}  // namespace jw
