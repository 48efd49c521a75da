#pragma once

#include <string>

#include "app/session/story/story.hpp"

/// Sentences that say what happened in a step, with the actual numbers.
namespace jw {

/// Title of a step: "Joint C · revolute · coupler – rocker"
std::string title_of(const Lesson& lesson, const Step& step);

/// @param rank of the step's pose
std::string sentence_of(const Lesson& lesson, const Step& step, const RankReport& rank);

/// "Joint D cannot be closed", or how far the motion could be followed, of a step that failed.
std::string what_failed(const Lesson& lesson, const Step& step);

/// What the rank of an unassembled pose becomes: "Rank 11 here, 10 once assembled: ..."
std::string once_assembled_text(int here, int once);

/// Why the story ends at a step; empty if it does not.
std::string failure_text(const Step& step);

}  // namespace jw
