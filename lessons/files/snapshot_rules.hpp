#pragma once

#include <filesystem>
#include <optional>

#include "lessons/diagnostics/read_text.hpp"

namespace jw {

/// Rules by which two pictures of a snapshot count as equal: `rules.toml` beside them (docs/snapshots.md).
/// Rules that are absent there have the values given here. The machine that drew a picture can draw it again
/// byte by byte, so these values allow only for rounding: single pixels, never a line or a digit.
struct SnapshotRules {
    struct Colour {
        int level = 8;               ///< of 255: a pixel differs if a channel is farther away than this
        int largest = 60;            ///< of 255: largest difference of a single pixel
        double share = 2e-5;         ///< part of the picture that may differ
        int patch = 4;               ///< pixels that may differ and touch each other
        double similarity = 0.9998;  ///< least structural similarity
    };
    /// Rules for the pictures of ids and of depths, which have no smooth edges: an edge may move by a pixel.
    struct Layer {
        double share = 2e-5;
        int patch = 3;
    };
    Colour colour;
    Layer ids;
    Layer depth;
    int depth_steps = 8;  ///< largest difference of a depth, of 16384 at the distance of the camera's target
};

struct SnapshotRulesRead : FileRead {
    std::optional<SnapshotRules> rules;
};

/// Reads the rules of a file; a file that is not there gives the rules above.
SnapshotRulesRead read_snapshot_rules(const std::filesystem::path& file);

}  // namespace jw
