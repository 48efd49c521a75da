#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/kinematics/motion_tracker.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/reactions.hpp"
#include "core/poses/rank.hpp"
#include "core/quantity/evaluate.hpp"
#include "lessons/lesson/lesson.hpp"

/// A lesson as a sequence of steps: the free bodies; for each joint its equations, the Newton iterations that
/// close what has been added so far, and the verdict; each driver likewise; then the motion.
namespace jw {

/// A result that is computed when it is first read; copies share it.
template <class Result>
class WhenAsked {
public:
    WhenAsked(std::nullptr_t = nullptr) {}  // NOLINT: "none"
    explicit WhenAsked(std::function<Result()> find)
        : asked_(std::make_shared<Asked>(Asked{std::move(find), std::nullopt})) {}

    explicit operator bool() const { return asked_ != nullptr; }
    const Result& operator*() const {
        if (!asked_->result) { asked_->result = asked_->find(); }
        return *asked_->result;
    }
    const Result* operator->() const { return &**this; }

private:
    struct Asked {
        std::function<Result()> find;
        std::optional<Result> result;
    };
    std::shared_ptr<Asked> asked_;
};

/// The verdict on the rank of a pose.
using RankWhenAsked = WhenAsked<RankReport>;

struct Step {
    enum class Kind {
        bodies,     ///< only coordinates
        equations,  ///< a joint or driver is added: its equations at the start estimate, the choice of rows
        iteration,  ///< one Newton iteration, or leaving a wrong branch
        assembled,  ///< closed: rank before and after, freedoms, redundant equations
        failed,     ///< could not be closed; the last good pose is kept and the story ends
        motion,     ///< a moment of the motion
        question,   ///< something is asked before it is shown; the pose is that of the step before
        answer,     ///< to that question, at the pose that has been reached
    };
    Kind kind = Kind::bodies;
    int additions = 0;  ///< joints and drivers present
    int question = -1;  ///< question and answer: index into Lesson::questions
    std::shared_ptr<const System> system;
    double t = 0.0;
    State state;
    Motion velocity;                 ///< motion only; at other steps the lesson's own
    Motion acceleration;             ///< motion only
    std::vector<int> turns;          ///< motion only: turns of the angle of every joint, see FollowedAngles
    std::vector<RowChoice> choices;  ///< equations: of the joint's p1 and p2, in the order of its primitives
    std::vector<PositionEvent> events;  ///< iteration and later: what happened in this solve so far
    RankWhenAsked rank_before;          ///< before the addition, at its pose
    RankWhenAsked rank;                 ///< bodies, assembled, failed
    std::optional<PositionFailure> failure;
    std::string note;            ///< motion: an additional sentence; mostly empty
    std::string ended;           ///< motion by masses and forces: why it goes no further; empty if it does
    bool rows_switched = false;  ///< motion: a p1 / p2 choice changed on the way here
    bool change_point = false;   ///< motion
    LinearVerdict velocity_verdict;
    LinearVerdict acceleration_verdict;
    /// Motion by masses and forces: data from which reactions are found when they are needed.
    std::shared_ptr<const Centroidal> centroidal;
    Motion centroidal_acceleration;
    std::optional<Energy> energy;  ///< as the run computed it

    /// True if the story ends early at this step.
    bool failed() const { return failure.has_value() || !ended.empty(); }
};

/// True for a question and its answer: nothing is added or moved by them.
inline bool is_asked(Step::Kind kind) { return kind == Step::Kind::question || kind == Step::Kind::answer; }

/// The question of the lesson that a question or answer step shows.
inline const Question& question_of(const Lesson& lesson, const Step& step) {
    return lesson.questions[at(step.question)];
}

/// Reactions at a moment of a motion by masses and forces; absent at other steps, and for mechanisms so large
/// that finding them would take longer than the motion.
std::optional<Reactions> reactions_of(const Step& step);

/// The joint or driver that a step is about, if any.
std::optional<Addition> subject_of(const Lesson& lesson, const Step& step);
/// Name of a joint or driver.
const std::string& name_of(const Addition& addition, const Mechanism& mechanism);
/// Name of the joint or driver that reacts.
const std::string& name_of(const Reaction& reaction, const Mechanism& mechanism);

/// The first `count` entries of the lesson's order.
Selection selection_of(const Lesson& lesson, int count);

struct StoryOptions {
    bool with_motion = true;
    bool with_ranks = true;  ///< of every assembled step, for callers that show them
    int intervals = 0;       ///< of the motion; 0: as many as the lesson says
    /// Least number of moments of a motion by masses and forces that are kept for curves and paths; 0: its
    /// steps.
    int curve_moments = 960;
    std::optional<double> start_time = {};  ///< [s]; default: that of the lesson
    int additions = -1;  ///< only this many joints and drivers are assembled, and nothing moves; -1: all
    /// The last step that is needed: telling may end after it, if that is before the motion. -1: everything.
    int last_step = -1;
    /// False: of the steps before the last, only kind and number are kept, not system and pose. For callers
    /// that need only the last pose: work and memory then grow with the number of joints, not with its
    /// square.
    bool keep_steps = true;
};

/// Options of a story of poses only, without ranks.
inline StoryOptions poses_only(bool with_motion = false) {
    StoryOptions options;
    options.with_motion = with_motion;
    options.with_ranks = false;
    options.curve_moments = 0;
    return options;
}

/// Options of a story of the assembled pose only.
inline StoryOptions last_pose_only() {
    StoryOptions options = poses_only();
    options.keep_steps = false;
    return options;
}

/// Motion that is shown after assembly: the lesson's prescribed motion, or the one by masses and forces.
std::optional<MotionPlan> shown_motion(const Lesson& lesson);

/// Time at which the mechanism is assembled: the motion's first time, or 0 [s].
double start_time(const Lesson& lesson);

/// Advances to time `t` over the moments of the lesson's own intervals, so that the result at `t` does not
/// depend on which other times were asked for.
/// @return as MotionTracker::advance_to; `rows_switched` tells whether a p1 / p2 choice changed on the way
bool advance_along(MotionTracker& tracker, const Lesson& lesson, double t, bool& rows_switched);

class Story {
public:
    /// Tells the lesson to its end, at once (story_telling.hpp does it in pieces). `lesson` must outlive the
    /// story and its copies, which share what is told.
    explicit Story(const Lesson& lesson, const StoryOptions& options = {});

    const Lesson& lesson() const { return *lesson_; }
    const std::vector<Step>& steps() const { return told_->steps; }
    /// Moments of a motion by masses and forces, many between two steps, from the dense output of its
    /// integrator: curves and paths are drawn from them. Empty if there are only the steps.
    const std::vector<Step>& curve() const { return told_->curve; }
    /// Set if the story ended early.
    const Step* failure() const;
    /// Index of the last step before the motion: by then, all joints and drivers are added.
    int last_assembled() const;
    /// The joint whose equations are of interest during the motion: the first whose choice of p1 / p2 rows
    /// changes, or the only one; -1 if there is none.
    int featured_joint() const { return told_->featured_joint; }
    /// The joint that the reader chose instead; -1 if there is none.
    int chosen_joint() const { return chosen_joint_; }
    /// Chooses a joint of the mechanism; -1 leaves the choice to the story again.
    void choose_joint(int joint) { chosen_joint_ = joint; }

private:
    friend class StoryTelling;
    /// Steps and curve, which do not change once they are told.
    struct Told {
        std::vector<Step> steps;
        std::vector<Step> curve;
        int featured_joint = -1;
    };
    Story(const Lesson& lesson, std::shared_ptr<const Told> told)
        : lesson_(&lesson), told_(std::move(told)) {}

    const Lesson* lesson_;
    std::shared_ptr<const Told> told_;
    int chosen_joint_ = -1;
};

/// Joints whose vectors and equations are shown during the motion: the joint that was chosen by hand; else
/// the one or two joints that consist of vectors alone, n1, n2, p1 and p2 (if there are more, those with a
/// choice of rows, if these are one or two); else the story's own featured joint. Empty if there is none.
std::vector<int> featured_joints(const Story& story);

/// State, velocities and accelerations at a moment of a prescribed motion.
Instant instant_of(std::shared_ptr<const System> system, const MotionFrame& frame);

/// Verdict on a pose. @param spectrum true: singular values and free motions of large systems, too, which
/// takes long
RankReport rank_of(const System& system, const State& state, double t, bool spectrum = false);
/// Verdict on the pose of a step, as far as the story has not found it already.
RankReport rank_of(const Step& step);
/// The number of a report that a claim or a question names.
int count_of(const RankReport& report, Count count);
/// Like rank_of, but without redundant rows, free motions and most singular values: faster, for many poses.
RankReport rank_verdict_of(const System& system, const State& state, double t);

}  // namespace jw
