#pragma once

#include "core/poses/rank.hpp"

namespace jw {

/// Adds the verdict on typed digits to the report, if that is on all joints of the mechanism.
inline void take_typed_verdict(const System& system, RankReport& report) {
    const Mechanism& mechanism = system.mechanism();
    if (!mechanism.typed || system.selection().joints.size() != mechanism.joints.size()) { return; }
    report.typed = mechanism.typed;
    report.decided = report.decided && report.typed->is_told;
}

}  // namespace jw
