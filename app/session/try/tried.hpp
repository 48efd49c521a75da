#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/session/try/experiments.hpp"

/// The edits that lead from a lesson as it was written to the lesson as it is: few, and told exactly.
namespace jw {

/// A lesson before and after edits.
struct Change {
    const Lesson& written;  ///< where all edits begin
    const Lesson& before;
    const Lesson& now;
};

/// `edits` with `more` behind them. An edit about the same thing as a later one is left out wherever the
/// sentences of the others lead to the same lesson, every number of it; what changes nothing is left out, and
/// nothing is left where it is the lesson as it was written.
/// @param edits  lead from change.written to change.before
/// @param more   lead from there to change.now
std::vector<Experiment> tried_with(
    std::vector<Experiment> edits, std::span<const Experiment> more, const Change& change);

/// Each of the edits as a sentence (experiment_text.hpp) about the lesson that those before have made.
std::vector<std::string> sentences_of(std::span<const Experiment> edits, const Lesson& written);

}  // namespace jw
