#pragma once

#include <string>
#include <vector>

#include "lessons/lesson/lesson.hpp"

/// Proves the claims of a lesson.
namespace jw {

struct ClaimResult {
    SourceSpan span;  ///< of the claim in the lesson file
    std::string why;  ///< the author's words
    bool holds = false;
    std::string moment;    ///< "after D", "at 0.25 s", "as given"
    std::string subject;   ///< "rank", "slider.x", "condition"
    std::string expected;  ///< "17", "0.458257569496 m ± 1e-09 m", "below 1e-12"
    std::string found;     ///< "17", or why it could not be found
    std::string failure;   ///< why the pose was not reached, a sentence; empty if it was
};

/// One result per claim, in the order of the file, and one more for the `point_at_end` of a lesson of
/// dynamics. If the numerics fail, the claim does not hold, unless it is `closes = false`. `lesson` must
/// outlive the results.
std::vector<ClaimResult> check_claims(const Lesson& lesson);

/// The claims of a lesson that can still be judged after joints and drivers were taken out of it: those about
/// the remaining parts, each at the moment after the same joint or driver.
std::vector<Claim> carried_claims(const Lesson& written, const Lesson& changed);

}  // namespace jw
