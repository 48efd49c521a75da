#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/host/frames/frame_painter.hpp"
#include "app/snapshot/facts/fact_changes.hpp"
#include "app/snapshot/facts/facts_file.hpp"
#include "app/snapshot/layers_picture.hpp"
#include "app/snapshot/shots.hpp"

/// Takes the snapshots of a lesson.
namespace jw::snapshot {

/// The three layers of one snapshot.
struct Snapshot {
    Record record;
    LayersPicture layers;  ///< its `things` are those of the record
    render::Image colour;
};

struct SnapshotSize {
    int width = 960;
    int height = 540;

    bool operator==(const SnapshotSize&) const = default;
};
inline constexpr SnapshotSize kSmallestSize{960, 540};
inline constexpr SnapshotSize kLargestSize{3840, 2160};

/// A lesson whose snapshots are taken, one after the other.
class Camera {
public:
    /// @throws std::runtime_error if OSMesa or a font is missing, or for unknown shots
    Camera(const Lesson& lesson, const SnapshotSize& size, const ShotChoice& choice, UnknownShots unknown);

    const Story& story() const { return story_; }
    const std::vector<Shot>& shots() const { return shots_; }
    /// The snapshot of a shot, with tolerances that all snapshots of the lesson share.
    Snapshot take(const Shot& shot);
    /// The colours of the snapshot of a shot, as if its step had another number.
    render::Image colour_as(const Shot& shot, const StepNumber& number);

    /// For callers that change what is drawn.
    host::FramePainter& painter() { return painter_; }
    View view(const Shot& shot) const { return view_of(story_, shot.step); }

private:
    std::vector<Fact> facts(const Shot& shot) const;

    Story story_;
    std::vector<Shot> shots_;
    host::FramePainter painter_;
    std::vector<std::vector<Fact>> facts_;  ///< of all shots
    Environment environment_;
};

}  // namespace jw::snapshot
