#pragma once

#include <vector>

#include "lessons/lesson/lesson.hpp"

namespace jw {

/// The claims of a lesson that can still be judged after joints and drivers were taken out of it: those about
/// the remaining parts, each at the moment after the same joint or driver.
std::vector<Claim> carried_claims(const Lesson& written, const Lesson& changed);

}  // namespace jw
