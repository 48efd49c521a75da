#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/snapshot/facts/fact_changes.hpp"
#include "app/snapshot/taken.hpp"
#include "lessons/files/snapshot_rules.hpp"
#include "render/files/image_difference.hpp"

/// Two snapshots of the same thing, compared layer by layer.
namespace jw::snapshot {

/// How much two pictures of a layer differ, and whether the rules allow that.
struct LayerDifference {
    std::string broken;    ///< the rule that is broken, with its numbers; empty if none is
    render::Image marked;  ///< where they differ; empty if they are equal
    bool is_equal = true;
};

struct Difference {
    std::vector<FactChange> facts;           ///< most important first, without `steps`
    std::optional<StepNumber> steps_before;  ///< set if the lesson had another number of steps
    std::vector<std::string> loose;          ///< numbers whose tolerance in the golden file proves nothing
    LayerDifference ids;
    LayerDifference depth;
    LayerDifference colour;
    std::vector<std::string> things;  ///< "rod: 312 pixels more": things of which more or less is seen
    /// Why colours may differ: they are drawn with other software. Then the colours do not count.
    std::string drawn_otherwise;

    bool text_fails() const { return !facts.empty() || !loose.empty(); }
    bool layers_fail() const { return !ids.broken.empty() || !depth.broken.empty(); }
    bool colour_fails() const { return !colour.broken.empty() && drawn_otherwise.empty(); }
    bool fails() const { return text_fails() || layers_fail() || colour_fails(); }
};

/// The first rule of a layer that a mask of differing pixels breaks; empty if none is.
std::string broken_rule(const render::PixelMask& mask, double share, int patch);

Difference difference_of(const Snapshot& before, const Snapshot& now, const SnapshotRules& rules);

/// The number that a step had, if its lesson had another number of steps then. Such a difference belongs to
/// the lesson, not to each of its snapshots.
std::optional<StepNumber> other_steps(const Record& before, const Record& now);

/// Difference of colours, with the broken rule if there is one. Also for pictures that belong to no snapshot.
LayerDifference compare_colours(
    const render::Image& before, const render::Image& now, const SnapshotRules::Colour& rules);

}  // namespace jw::snapshot
