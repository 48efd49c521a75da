#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/session/story/story.hpp"
#include "core/quantity/evaluate.hpp"
#include "core/statics/modes.hpp"

/// Poses and motions of a lesson's mechanism at the moments of its claims.
namespace jw {

/// A pose at which claims are judged, or why there is none.
struct Pose {
    Instant instant;
    /// The same instant of a run with a looser tolerance, for a motion by masses and forces. The difference
    /// of the two is the uncertainty that remains.
    std::optional<Instant> rough;
    std::optional<bool> change_point;    ///< as found along the motion; nothing if no motion led here
    std::optional<Stability> stability;  ///< of an equilibrium
    std::string failure;                 ///< not empty: the pose was not reached
};

/// Poses of all requested moments, each computed once.
class ClaimPoses {
public:
    /// `lesson` must outlive the poses.
    explicit ClaimPoses(const Lesson& lesson);

    /// @param moment of a claim of the lesson, or the end of its [dynamics] where a point is claimed there
    Pose at(const Moment& moment) const;

private:
    Pose as_given() const;
    Pose after(int count) const;
    std::vector<double> claimed_times(bool by_forces) const;
    void follow_motion();
    void follow_forces();
    void come_to_rest();

    const Lesson* lesson_;
    Story story_;
    std::shared_ptr<const Centroidal> scene_;  ///< nothing in a lesson without masses
    std::map<double, Pose> motion_;
    std::map<double, Pose> by_forces_;
    Pose at_rest_;
};

}  // namespace jw
