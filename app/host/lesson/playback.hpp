#pragma once

#include <optional>

#include "app/session/try/session.hpp"

namespace jw::host {

/// Time between two frames of a motion [s]: no display shows more.
inline constexpr double kMoving = 1.0 / 60.0;

/// Playback of the story from step to step, or of one of the free motions there and back.
class Playback {
public:
    bool plays() const { return playing_; }
    double speed() const { return speed_; }
    /// The free motion that is followed, in the order of RankReport::free_motions; -1: none.
    int freedom() const { return freedom_; }
    /// True while the picture changes from frame to frame.
    bool is_moving() const { return playing_ || freedom_ >= 0; }

    void pause() { playing_ = false; }
    /// Plays from the beginning of the step that is shown, or pauses.
    void play_or_pause();
    /// Plays on from the beginning of the step that is shown next.
    void play();
    void faster();
    void slower();
    /// Doubles the speed; the slowest speed follows the fastest.
    void next_speed();

    /// Shows the step from its beginning, and no free motion.
    void begin_step();
    /// Begins the step again and pauses.
    void stop();
    /// Follows a free motion from the shown pose; pauses the story.
    void follow(int freedom);
    void leave_freedom() { freedom_ = -1; }

    /// The step to show `seconds` later; nothing if it is the same step. At the last step playback pauses.
    std::optional<int> step_after(double seconds, const Session& session);
    /// The pose to show `seconds` later; nothing if no free motion is followed.
    std::optional<ShowFreedom> freedom_after(double seconds);
    /// Time until the next still is shown [s]; nothing while it does not play, or plays a motion.
    std::optional<double> seconds_to_next_still(const Session& session) const;
    /// Time until the step or the pose changes [s]; infinity if nothing moves.
    double seconds_to_change(const Session& session) const;

private:
    bool playing_ = false;
    double speed_ = 1.0;
    double step_waited_ = 0.0;  ///< how long the step has been shown, at speed 1 [s]
    int freedom_ = -1;
    double freedom_time_ = 0.0;
};

}  // namespace jw::host
