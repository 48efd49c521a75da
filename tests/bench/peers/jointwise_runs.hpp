#pragma once

#include "lessons/lesson/lesson.hpp"
#include "tests/bench/peers/sweep.hpp"

namespace jw::peers {

/// Jointwise on the same scene in the same run: every method that follows a tolerance. The making of the
/// equations is not in the time, as that of the models of others is not.
void measure_jointwise(const Lesson& lesson, const PeerScene& scene, double limit, Report& report);

}  // namespace jw::peers
