#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/session/try/experiments.hpp"

/// The edits that lead from a lesson as it was written to the lesson as it is now: few and exact.
namespace jw {

/// A lesson before and after edits.
struct Change {
    const Lesson& written;  ///< where all edits begin
    const Lesson& before;
    const Lesson& now;
};

/// `edits` followed by `more`. An edit about the same thing as a later one is left out if the sentences of
/// the others lead to the same lesson with every number. Edits that change nothing are left out, too. If the
/// lesson is as it was written, the result is empty.
/// @param edits  lead from change.written to change.before
/// @param more   lead from there to change.now
std::vector<Experiment> tried_with(
    std::vector<Experiment> edits, std::span<const Experiment> more, const Change& change);

/// Each of the edits as a sentence (experiment_text.hpp) about the lesson that the edits before it have made.
std::vector<std::string> sentences_of(std::span<const Experiment> edits, const Lesson& written);

}  // namespace jw
