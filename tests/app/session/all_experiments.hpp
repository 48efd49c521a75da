#pragma once

#include <vector>

#include "app/session/try/experiments.hpp"
#include "tests/support/random_mechanisms.hpp"

namespace jw::test {

/// Every kind of experiment with every joint, driver and body of a lesson.
std::vector<Experiment> all_experiments(const Lesson& lesson, Random& random);

}  // namespace jw::test
