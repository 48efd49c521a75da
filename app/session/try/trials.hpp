#pragma once

#include <vector>

#include "app/session/claims/checks.hpp"

/// Carries out the experiments that an author proposes.
namespace jw {

/// One result per [[try]] of the lesson, in the order of the file. It holds if every experiment can be
/// carried out and the story then goes to its end; if the author says that it breaks, it holds if the story
/// then fails, or the assembled mechanism has more freedoms than before.
std::vector<ClaimResult> check_trials(const Lesson& lesson);

}  // namespace jw
