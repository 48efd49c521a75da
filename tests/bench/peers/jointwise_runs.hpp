#pragma once

#include "lessons/lesson/lesson.hpp"
#include "tests/bench/peers/sweep.hpp"

namespace jw::peers {

/// Runs Jointwise on the same scene in the same run: every method that follows a tolerance. The time excludes
/// building the equations, as it excludes building the models of the other engines.
void measure_jointwise(const Lesson& lesson, const PeerScene& scene, double limit, Report& report);

}  // namespace jw::peers
