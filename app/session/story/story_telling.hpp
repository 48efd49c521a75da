#pragma once

#include <functional>
#include <memory>

#include "app/session/story/story.hpp"

namespace jw {

class MotionTelling;

/// Tells a story piece by piece, for callers that do other work in between.
class StoryTelling {
public:
    /// Begins with the free bodies. `lesson` must outlive the telling and its story.
    explicit StoryTelling(const Lesson& lesson, const StoryOptions& options = {});
    ~StoryTelling();

    /// Tells the next piece: a joint or driver, or a moment or an integrator's step of the motion.
    /// @return false if there was nothing more to tell
    bool go_on();
    /// Fraction of the story that is told, from 0 to 1.
    double progress() const;
    /// Estimate of the work for the pieces so far: the number of bodies for each joint, and for each moment
    /// of a motion; the same on every machine.
    double work() const { return work_; }
    /// The story, once all is told.
    Story story() const { return {*lesson_, told_}; }

private:
    void tell_bodies();
    bool tell_addition(int count);
    bool close_addition(int count);
    bool tell_quietly(int count);
    bool fits_as_it_is(const Addition& added) const;
    void forget_poses();
    std::optional<MotionPlan> motion_to_tell() const;
    bool begin_motion();
    void ask(Question::Place place, const Addition* added, Step::Kind kind);
    void find_featured_joint();
    bool is_enough() const;
    bool end();
    /// Rank of the present system at the present state, computed when asked for.
    RankWhenAsked present_rank() const;

    const Lesson* lesson_;
    StoryOptions options_;
    double start_time_ = 0.0;
    int additions_ = 0;  ///< number to be told
    int added_ = 0;
    bool ended_ = false;
    double work_ = 0.0;
    std::shared_ptr<const System> system_;
    State state_;
    bool is_exact_ = false;      ///< the pose satisfies all equations so far to the tolerance of Newton
    std::size_t forgotten_ = 0;  ///< steps before this one have no pose any more
    RankWhenAsked rank_;
    std::unique_ptr<MotionTelling> motion_;
    std::shared_ptr<Story::Told> told_ = std::make_shared<Story::Told>();
};

/// A story and the lesson that it is about.
struct ToldLesson {
    std::shared_ptr<const Lesson> lesson;
    Story story;
};
ToldLesson tell_at_once(std::shared_ptr<const Lesson> lesson, const StoryOptions& options);

/// Tells the lessons of a session, like tell_at_once or in another way. The returned lesson may be another
/// copy. If the call throws, the session drops the intended change, and stays as it was.
using Storyteller = std::function<ToldLesson(std::shared_ptr<const Lesson>, const StoryOptions&)>;

}  // namespace jw
