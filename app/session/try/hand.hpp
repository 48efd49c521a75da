#pragma once

#include <memory>
#include <optional>

#include "app/session/story/story.hpp"
#include "core/kinematics/freedoms.hpp"
#include "core/kinematics/manifold.hpp"

/// A pose that is not in the story: a hand has pulled the bodies, or a free motion is followed.
namespace jw {

class Hand {
public:
    /// Takes hold of what is assembled at a step; if its joint is not closed yet, of everything before that
    /// joint.
    /// @param story must outlive this
    Hand(const Story& story, int index);

    /// The step that was taken hold of, with the pose of the hand.
    const Step& step() const { return step_; }

    DragOutcome pull(int body, const Vec3& point_local, const Vec3& target);

    /// Goes to the pose at `part` (-1 to 1) of the way on which free motion `motion` can be followed.
    /// @return false if there is no such motion
    bool follow(int motion, double part);
    /// Free motion that is being followed, if any.
    const std::optional<FollowedMotion>& followed() const { return followed_; }

private:
    void show(const State& state);

    Step step_;
    State start_;
    std::unique_ptr<System> system_;  ///< chooses rows as it moves
    std::unique_ptr<Dragger> dragger_;
    std::optional<FollowedMotion> followed_;
    int followed_motion_ = -1;
};

/// Index of the step whose constraints hold at step `index`: the step itself once its joint is closed.
int closed_step(const Story& story, int index);

}  // namespace jw
