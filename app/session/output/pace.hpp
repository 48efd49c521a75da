#pragma once

#include "app/session/view/view.hpp"

namespace jw {

/// How long a step should be looked at [s]: the time to read it.
/// @param moment  seconds between two moments of the motion
double seconds_to_look(const View& view, double moment);

/// The same at the pace of the lesson's own motion.
double seconds_of_step(const Story& story, const View& view);

}  // namespace jw
