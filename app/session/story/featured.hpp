#pragma once

#include <vector>

#include "app/session/story/story.hpp"

namespace jw {

/// Joints whose vectors and equations are shown during the motion: the joint that was chosen by hand; else
/// the one or two joints that consist of vectors alone, n1, n2, p1 and p2 (if there are more, those with a
/// choice of rows, if these are one or two); else the story's own featured joint. Empty if there is none.
std::vector<int> featured_joints(const Story& story);

}  // namespace jw
