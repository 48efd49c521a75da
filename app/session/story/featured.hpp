#pragma once

#include <vector>

#include "app/session/story/story.hpp"

namespace jw {

/// Joints whose vectors and equations are shown while everything moves: the one that was chosen by hand; else
/// the one or two that consist of their vectors alone, n1, n2, p1 and p2 (where there are more, those with a
/// choice of rows, if these are one or two); else the story's own featured joint. Empty if there is none.
std::vector<int> featured_joints(const Story& story);

}  // namespace jw
