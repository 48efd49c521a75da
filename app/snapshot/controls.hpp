#pragma once

#include <string>
#include <vector>

#include "app/snapshot/taken.hpp"
#include "lessons/snapshot_rules.hpp"

/// Negative controls: faults that every suite must notice, made in a snapshot that is right.
namespace jw::snapshot {

struct ControlResult {
    std::string fault;    ///< "the picture is shifted by one pixel"
    std::string layer;    ///< that must notice it: "colours", "ids", "text"
    bool noticed = true;  ///< false: the rules are so loose that the suite proves nothing
};

/// Makes each fault in the snapshot of a shot and compares. A fault that the snapshot has no room for, such
/// as a joint where there is none, is left out.
std::vector<ControlResult> control(Camera& camera, const Shot& shot, const SnapshotRules& rules);

/// The shot that has room for most faults: the last one at which everything is put together.
const Shot& shot_for_controls(const Camera& camera);

}  // namespace jw::snapshot
