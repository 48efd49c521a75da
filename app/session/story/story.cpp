#include "app/session/story/story.hpp"

#include <algorithm>

#include "app/session/story/story_telling.hpp"
#include "core/equations/assembler.hpp"
#include "core/poses/large_rank.hpp"

namespace jw {

namespace {

// limited because reactions are found by dense matrices
constexpr std::size_t kMostJointsWithReactions = 30;
constexpr double kNoMoment = 1e-6;  // far above rounding, which is 1e-13 relative to the forces
// the vectors and formulas of more than two joints would hide each other
constexpr std::size_t kMostAtOnce = 2;

bool is_few(const std::vector<int>& joints) { return !joints.empty() && joints.size() <= kMostAtOnce; }

/// Joints without a glyph: only their vectors are visible.
std::vector<int> bare_joints(const Mechanism& mechanism) {
    std::vector<int> bare;
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        if (mechanism.joints[k].type->glyph == JointGlyph::none) { bare.push_back(static_cast<int>(k)); }
    }
    return bare;
}

}  // namespace

std::optional<Addition> subject_of(const Lesson& lesson, const Step& step) {
    if (step.additions == 0 || step.kind == Step::Kind::motion) { return std::nullopt; }
    if (step.kind == Step::Kind::question) { return std::nullopt; }
    const bool of_addition =
        step.kind != Step::Kind::answer || question_of(lesson, step).place == Question::Place::addition;
    if (!of_addition) { return std::nullopt; }
    return lesson.order[at(step.additions - 1)];
}

const std::string& name_of(const Addition& addition, const Mechanism& mechanism) {
    const std::size_t k = at(addition.index);
    return addition.kind == Addition::Kind::joint ? mechanism.joints[k].name : mechanism.drivers[k].name;
}

const std::string& name_of(const Reaction& reaction, const Mechanism& mechanism) {
    return reaction.joint >= 0 ? mechanism.joints[at(reaction.joint)].name
                               : mechanism.drivers[at(reaction.driver)].name;
}

Selection selection_of(const Lesson& lesson, int count) {
    Selection selection;
    for (int k = 0; k < count; ++k) {
        const Addition& a = lesson.order[at(k)];
        (a.kind == Addition::Kind::joint ? selection.joints : selection.drivers).push_back(a.index);
    }
    return selection;
}

std::optional<Reactions> reactions_of(const Step& step) {
    if (!step.centroidal || step.centroidal->mechanism.joints.size() > kMostJointsWithReactions) {
        return std::nullopt;
    }
    Reactions found = reactions_from_body_frames(
        *step.centroidal, step.t, step.state, step.velocity, step.centroidal_acceleration);
    // a pose that was pulled elsewhere by hand is not a moment of the motion, and has other accelerations
    if (found.residual > kNoMoment) { return std::nullopt; }
    return found;
}

std::optional<MotionPlan> shown_motion(const Lesson& lesson) {
    if (lesson.motion || !lesson.dynamics) { return lesson.motion; }
    if (!why_not(lesson.dynamics->settings.method, lesson.dynamics->settings.treatment).empty()) {
        return std::nullopt;
    }
    // short motions are shown in slow motion, long ones at their own pace
    constexpr double shortest_show = 8.0;
    MotionPlan plan;
    plan.to = lesson.dynamics->duration;
    plan.duration = std::max(plan.to, shortest_show);
    return plan;
}

double start_time(const Lesson& lesson) { return lesson.motion ? lesson.motion->from : 0.0; }

Story::Story(const Lesson& lesson, const StoryOptions& options) : lesson_(&lesson) {
    StoryTelling telling(lesson, options);
    while (telling.go_on()) {}
    *this = telling.story();
}

const Step* Story::failure() const {
    const Step& last = steps().back();
    return last.failed() ? &last : nullptr;
}

int Story::last_assembled() const {
    int index = 0;
    for (std::size_t k = 0; k < steps().size(); ++k) {
        if (steps()[k].kind == Step::Kind::motion) { break; }
        if (!is_asked(steps()[k].kind)) { index = static_cast<int>(k); }
    }
    return index;
}

std::vector<int> featured_joints(const Story& story) {
    const Mechanism& mechanism = story.lesson().mechanism;
    if (story.chosen_joint() >= 0) { return {story.chosen_joint()}; }
    std::vector<int> bare = bare_joints(mechanism);
    if (is_few(bare)) { return bare; }
    std::erase_if(bare, [&](int joint) {
        return std::ranges::none_of(mechanism.joints[at(joint)].type->roles, is_parallel);
    });
    if (is_few(bare)) { return bare; }
    if (story.featured_joint() >= 0) { return {story.featured_joint()}; }
    return {};
}

bool advance_along(MotionTracker& tracker, const Lesson& lesson, double t, bool& rows_switched) {
    rows_switched = false;
    const auto advance = [&](double next) {
        const bool ok = tracker.advance_to(next);
        rows_switched = rows_switched || tracker.frame().rows_switched;
        return ok;
    };
    if (lesson.motion) {
        const MotionPlan& plan = *lesson.motion;
        const double interval = (plan.to - plan.from) / plan.steps;
        for (int k = 1; k <= plan.steps; ++k) {
            const double moment = plan.from + k * interval;
            // times nearer than a thousandth of an interval count as one
            if (moment <= tracker.frame().t + 1e-3 * interval || moment >= t - 1e-3 * interval) { continue; }
            if (!advance(moment)) { return false; }
        }
    }
    return advance(t);
}

Instant instant_of(std::shared_ptr<const System> system, const MotionFrame& frame) {
    Instant instant;
    instant.t = frame.t;
    instant.system = std::move(system);
    instant.state = frame.state;
    instant.velocity = frame.velocity;
    instant.turns = frame.turns;
    instant.acceleration = frame.acceleration;
    return instant;
}

RankReport rank_of(const System& system, const State& state, double t, bool spectrum) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, t);
    return analyse_rank_of_any_size(system, assembler.sparse_jacobian(), assembler.phi(), spectrum);
}

RankReport rank_of(const Step& step) {
    return step.rank ? *step.rank : rank_of(*step.system, step.state, step.t);
}

int count_of(const RankReport& report, Count count) {
    switch (count) {
        case Count::rank: return report.rank;
        case Count::rows: return report.rows;
        case Count::columns: return report.columns;
        case Count::dof: return report.dof;
        case Count::redundant: return report.redundant();
        case Count::mobility_by_counting: break;
    }
    return report.mobility_by_counting;
}

RankReport rank_verdict_of(const System& system, const State& state, double t) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, t);
    return analyse_rank_verdict(system, assembler.sparse_jacobian(), assembler.phi());
}

}  // namespace jw
