#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session/output/json.hpp"
#include "app/session/try/session.hpp"

/// Experiments that are possible in a lesson, and the effect of each on the equations at the present step.
namespace jw {

/// Numbers of all present equations, at the same pose.
struct Effect {
    int rows = 0;
    int rank = 0;
    int dof = 0;
    double condition =
        0.0;  ///< largest / smallest singular value that is not zero, (r, ω′), scaled; 0 without rows

    int redundant() const { return rows - rank; }
};

struct PossibleExperiment {
    std::string text;   ///< to be typed: "form hinge drop x"
    bool now = false;   ///< the lesson is like this already
    bool free = false;  ///< taking it out costs no rank
    std::optional<Effect> effect;
};

struct FreeMotionVerdict : FreedomJudgement {
    std::string text;    ///< "follow 1"
    std::string motion;  ///< in words
    std::string leaves;  ///< in words, as leaving_text
};

/// Experiments with one joint or driver.
struct ExperimentGroup {
    std::string title;  ///< "A · revolute · ground – crank"
    std::vector<PossibleExperiment> experiments;
};

struct PossibleExperiments {
    std::string moment;  ///< "after D"
    int step = 0;
    Effect present;
    std::vector<ExperimentGroup> groups;
    std::vector<std::string> removable;  ///< rows that can be taken out one at a time without loss of rank
    std::vector<std::string> combinations;
    std::vector<FreeMotionVerdict> free_motions;
    ExperimentGroup coordinates;
};

/// Receives the results while they are found: each effect needs a rank.
struct ExperimentsListener {
    /// Everything that is known from the start; experiments have no effects yet.
    std::function<void(const PossibleExperiments& outline)> begin;
    /// Each group with its effects, in the order of PossibleExperiments::groups.
    std::function<void(const ExperimentGroup& group)> group;
};

/// Experiments possible at the step that `session` shows; while a joint is being closed, at the step before
/// it.
PossibleExperiments possible_experiments_of(const Session& session, const ExperimentsListener& listener = {});

std::string describe(const PossibleExperiments& experiments, const Lesson& lesson);
Json json_of(const PossibleExperiments& experiments, const Lesson& lesson);

/// The same text in pieces: the head, each group, what follows the groups.
class ExperimentsText {
public:
    /// @param outline  with the texts of all experiments, of which the widest sets the columns
    ExperimentsText(const PossibleExperiments& outline, const Lesson& lesson);

    const std::string& head() const { return head_; }
    std::string group(const ExperimentGroup& group) const;
    std::string rest(const PossibleExperiments& all) const;

private:
    int widest_ = 0;
    std::string head_;
};

}  // namespace jw
