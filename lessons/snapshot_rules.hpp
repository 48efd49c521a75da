#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lessons/diagnostics.hpp"

namespace jw {

/// Rules by which pictures of snapshots count as equal: `rules.toml` beside them (docs/snapshots.md). What is
/// not said there has the values here. On the machine that drew a picture it is drawn again byte by byte, so
/// these allow for rounding alone: single pixels, never a line or a digit.
struct SnapshotRules {
    struct Colour {
        int level = 8;               ///< of 255: a pixel differs if a channel is farther away than this
        int largest = 60;            ///< of 255: what a single pixel may be away
        double share = 2e-5;         ///< part of the picture that may differ
        int patch = 4;               ///< pixels that may differ and touch each other
        double similarity = 0.9998;  ///< structural, at least
    };
    /// Rules for the pictures of ids and of depths, which have no smooth edges: an edge may be a pixel away.
    struct Layer {
        double share = 2e-5;
        int patch = 3;
    };
    Colour colour;
    Layer ids;
    Layer depth;
    int depth_steps = 8;  ///< of 16384 at the distance of the camera's target: what a depth may be away
};

struct SnapshotRulesRead {
    std::optional<SnapshotRules> rules;
    std::vector<Diagnostic> diagnostics;
    std::string report;  ///< diagnostics in compiler style
};

/// Reads the rules of a file; a file that is not there gives the rules above.
SnapshotRulesRead read_snapshot_rules(const std::filesystem::path& file);

}  // namespace jw
