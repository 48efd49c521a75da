#pragma once

#include <vector>

#include "app/session/claims/checks.hpp"

/// What an author proposes to try, carried out.
namespace jw {

/// One result per [[try]] of the lesson, in the order of the file: it holds if every experiment can be
/// carried out and the story then goes to its end, unless the author says that it breaks.
std::vector<ClaimResult> check_trials(const Lesson& lesson);

}  // namespace jw
