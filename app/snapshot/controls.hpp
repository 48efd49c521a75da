#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/snapshot/taken.hpp"
#include "lessons/files/snapshot_rules.hpp"

/// Negative controls: faults that every suite must notice, made in a snapshot that is right.
namespace jw::snapshot {

enum class Fault { shift, number, tolerance, shown_digit, colours, joint };
std::set<Fault> all_faults();

struct ControlResult {
    std::string fault;    ///< "the picture is shifted by one pixel"
    std::string layer;    ///< the layer that must notice it: "colours", "ids", "text"
    bool noticed = true;  ///< false: the rules are so loose that the suite proves nothing
};

/// A fault that cannot be made in a snapshot: even the strictest suite could not notice it there.
struct SkippedControl {
    Fault kind = Fault::shift;
    std::string fault;
    std::string layer;
    std::string reason;  ///< "no joint is seen on more pixels than may differ"
};

struct ControlResults {
    std::vector<ControlResult> made;
    std::vector<SkippedControl> skipped;
};

/// Makes faults in the snapshot of a shot and compares. The picture without the fault and the default rules
/// decide whether a fault can be noticed; loose rules, or a renderer that draws the same picture again, do
/// not.
ControlResults control(
    Camera& camera, const Shot& shot, const SnapshotRules& rules, const std::set<Fault>& wanted);

/// The shot in which most faults can be made: the last one with everything assembled.
const Shot& shot_for_controls(const Camera& camera);

}  // namespace jw::snapshot
