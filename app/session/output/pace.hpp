#pragma once

#include "app/session/view/view.hpp"

namespace jw {

/// Time that a step should be shown [s]: the time to read it, at most ten seconds for a still.
/// @param moment  seconds between two moments of the motion
double seconds_to_look(const View& view, double moment);

/// Time that a step should be shown [s] when the lesson's motion plays at its own pace.
double seconds_of_step(const Story& story, const View& view);

}  // namespace jw
