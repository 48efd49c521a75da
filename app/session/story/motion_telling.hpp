#pragma once

#include <memory>

#include "app/session/story/story.hpp"

namespace jw {

/// The motion of a story while it is told.
class MotionTelling {
public:
    virtual ~MotionTelling() = default;
    MotionTelling() = default;
    MotionTelling(const MotionTelling&) = delete;
    MotionTelling& operator=(const MotionTelling&) = delete;

    /// Adds the next steps and moments of the curve, of which there may be none yet.
    /// @return false if there was nothing left
    virtual bool go_on(std::vector<Step>& steps, std::vector<Step>& curve) = 0;
    /// Fraction of the motion that is told, from 0 to 1.
    virtual double progress() const = 0;
    /// Estimate of the work of `go_on`, see StoryTelling::work.
    virtual double work_of_piece() const = 0;
};

/// The assembled mechanism, from which a motion begins.
struct Assembled {
    const Lesson& lesson;
    std::shared_ptr<const System> system;
    State state;
};

/// The motion by masses and forces, by the lesson's method.
std::unique_ptr<MotionTelling> tell_motion_by_forces(
    const Assembled& from, const MotionPlan& plan, const StoryOptions& options);

}  // namespace jw
