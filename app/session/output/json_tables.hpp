#pragma once

#include <array>

#include "app/session/output/json.hpp"
#include "app/session/story/dynamics_run.hpp"
#include "app/session/view/solution.hpp"
#include "lessons/lesson/enum_words.hpp"

/// JSON of tables over time, as `solve` and `simulate` write them.
namespace jw {

inline constexpr std::array kAnalyses{
    EnumWord<Analysis>{Analysis::position, "position"}, EnumWord<Analysis>{Analysis::velocity, "velocity"},
    EnumWord<Analysis>{Analysis::acceleration, "acceleration"}};

Json json_of(const Sweep& sweep, Analysis analysis, const Lesson& lesson);
Json json_of(const DynamicsTable& table, const Lesson& lesson);

}  // namespace jw
