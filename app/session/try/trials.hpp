#pragma once

#include <vector>

#include "app/session/claims/checks.hpp"

/// What an author proposes to try, carried out.
namespace jw {

/// One result per [[try]] of the lesson, in the order of the file: it holds if every experiment can be
/// carried out and the story then goes to its end; where the author says that it breaks, if the story then
/// fails or what is put together has more freedoms than before.
std::vector<ClaimResult> check_trials(const Lesson& lesson);

}  // namespace jw
