#include "app/session/answers/right_answer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "app/session/story/dynamics_rows.hpp"
#include "core/elementary/elementary.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

// the answer is computed again at every change of the lesson: a scene that was made stiff or endless has no
// answer
constexpr long kMostStepsOfAnswer = 100'000;

RankReport report_of(const Step& step) {
    return step.rank ? *step.rank : rank_of(*step.system, step.state, step.t);
}

RightAnswer right_count(const CountAnswer& answer, const Step& step) {
    const RankReport report = report_of(step);
    RightAnswer right;
    right.number = count_of(report, answer.count);
    right.known = report.decided;
    return right;
}

RightAnswer right_axis(const DroppedAnswer& answer, const Step& step) {
    RightAnswer right;
    for (const Constraint& c : step.system->constraints()) {
        if (c.joint == answer.joint && c.role == answer.role) { right.choice = c.dropped; }
    }
    right.known = right.choice >= 0;
    return right;
}

/// The instant at a time of the motion that the lesson prescribes.
std::optional<Instant> driven_instant(const Story& story, double t) {
    const Step& assembled = story.steps()[static_cast<std::size_t>(story.last_assembled())];
    System system = *assembled.system;
    MotionTracker tracker(system, assembled.state, assembled.t);
    bool switched = false;
    if (!advance_along(tracker, story.lesson(), t, switched)) { return std::nullopt; }
    Instant instant;
    instant.t = t;
    instant.system = std::make_shared<const System>(system);
    instant.state = tracker.frame().state;
    instant.velocity = tracker.frame().velocity;
    instant.turns = tracker.frame().turns;
    instant.acceleration = tracker.frame().acceleration;
    return instant;
}

double value_at(const QuantityAnswer& answer, const Instant& instant) {
    return evaluate(answer.quantity, instant, answer.derivative)
        .derivatives[static_cast<std::size_t>(answer.derivative)];
}

/// The instant at exactly the time `t` of the motion by masses and forces.
std::optional<Instant> instant_of_run(const Lesson& lesson, double t, double tolerance) {
    std::map<double, Instant> found;
    const RunLimits limits{tolerance, kMostStepsOfAnswer};
    const std::string failure = instants_by_forces(lesson, limits, {t}, found);
    if (!failure.empty() || found.empty()) { return std::nullopt; }
    return found.rbegin()->second;
}

/// Result of `read` at a time of the motion. Nothing if two runs by masses and forces with different
/// tolerances differ by more than the answer allows.
template <class Read, class Agree>
auto found_at(const Story& story, const AtTime& when, const Read& read, const Agree& agree)
    -> std::optional<decltype(read(Instant{}))> {
    if (!when.by_forces) {
        const auto instant = driven_instant(story, when.t);
        return instant ? std::optional(read(*instant)) : std::nullopt;
    }
    const auto tight = instant_of_run(story.lesson(), when.t, kTightRun);
    const auto loose = instant_of_run(story.lesson(), when.t, kLooseRun);
    if (!tight || !loose || !agree(read(*tight), read(*loose))) { return std::nullopt; }
    return read(*tight);
}

RightAnswer right_quantity(const QuantityAnswer& answer, const Story& story) {
    RightAnswer right;
    const auto found = found_at(
        story, answer.when, [&](const Instant& instant) { return value_at(answer, instant); },
        [&](double a, double b) { return std::abs(a - b) <= answer.tolerance; });
    const double value = found.value_or(std::numeric_limits<double>::quiet_NaN());
    const double factor = answer.in_degrees ? kDegreesPerRadian : 1.0;
    right.number = factor * value;
    right.tolerance = factor * answer.tolerance;
    const bool modulo_turn = answer.derivative == 0 && is_modulo_turn(answer.quantity);
    right.turn = modulo_turn ? factor * 2.0 * std::numbers::pi : 0.0;
    right.known = std::isfinite(right.number);
    return right;
}

BodyPose pose_of(const State& state, int body) {
    const auto b = static_cast<std::size_t>(body);
    return {state.r[b], state.p[b]};
}

RightAnswer right_pose(const PoseAnswer& answer, const Story& story, const Step& step) {
    RightAnswer right;
    right.tolerance = answer.tolerance_m;
    right.tolerance_rad = answer.tolerance_rad;
    right.pose = pose_of(step.state, answer.body);
    if (answer.when) {
        right.pose = found_at(
            story, *answer.when, [&](const Instant& instant) { return pose_of(instant.state, answer.body); },
            [&](const BodyPose& a, const BodyPose& b) {
                return (a.r - b.r).norm() <= answer.tolerance_m && a.turn_from(b) <= answer.tolerance_rad;
            });
    }
    right.known = right.pose && right.pose->r.allFinite() && right.pose->p.allFinite();
    if (!right.known) { right.pose.reset(); }
    return right;
}

/// The rows that p1 and p2 leave out: those of the joint that the step adds, otherwise those of all joints.
std::vector<Thing> dropped_rows(const Question& question, const Step& step) {
    const bool of_one =
        question.place == Question::Place::addition && question.addition.kind == Addition::Kind::joint;
    std::vector<Thing> rows;
    for (const Constraint& c : step.system->constraints()) {
        if (c.dropped < 0 || (of_one && c.joint != question.addition.index)) { continue; }
        rows.push_back(Thing::row(c.joint, {c.role, c.dropped}));
    }
    return rows;
}

/// Every row of a linear dependency, in the order of the system: each of them could be left out instead of
/// the one that was found.
std::vector<Thing> redundant_rows(const Step& step, const RankReport& report) {
    std::vector<int> found;
    for (const RedundantRow& redundant : report.redundant_rows) {
        found.push_back(redundant.row);
        for (const RedundantRow::Term& term : redundant.terms) { found.push_back(term.row); }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<Thing> rows;
    for (const int row : found) {
        if (const auto thing = thing_of_row(*step.system, row)) { rows.push_back(*thing); }
    }
    return rows;
}

RightAnswer right_things(const PointedAnswer& answer, const Question& question, const Step& step) {
    RightAnswer right;
    right.known = true;
    right.things = answer.right;
    if (answer.found == RowsFound::dropped) {
        right.things = dropped_rows(question, step);
    } else if (answer.found == RowsFound::redundant) {
        const RankReport report = report_of(step);
        right.things = redundant_rows(step, report);
        right.known = report.decided;
    }
    // without such a thing, no click can be right
    right.known = right.known && !right.things.empty();
    return right;
}

}  // namespace

double BodyPose::turn_from(const BodyPose& other) const {
    // |p - p'| = 2 sin(angle / 4); an arc cosine of pᵀp' would lose half of the digits of a small angle
    const double apart = std::min((p - other.p).norm(), (p + other.p).norm());
    return 4.0 * elementary::asin(std::min(1.0, 0.5 * apart));
}

std::optional<Thing> thing_of_row(const System& system, int row) {
    const RowOrigin origin = system.origin(row);
    const auto k = static_cast<std::size_t>(origin.index);
    switch (origin.kind) {
        case RowOrigin::Kind::constraint: {
            const Constraint& c = system.constraints()[k];
            return Thing::row(c.joint, {c.role, origin.component});
        }
        case RowOrigin::Kind::driver: return Thing::row_of_driver(system.drivers()[k].driver);
        case RowOrigin::Kind::normalisation: break;
    }
    return std::nullopt;
}

RightAnswer right_answer(const Story& story, int index) {
    const Question& question = story.lesson().questions[static_cast<std::size_t>(index)];
    for (const Step& step : story.steps()) {
        if (step.kind == Step::Kind::answer && step.question == index) {
            return right_answer(story, question, step);
        }
    }
    return {};
}

RightAnswer right_answer(const Story& story, const Question& question, const Step& step) {
    return std::visit(
        Overloaded{
            [&](const CountAnswer& a) { return right_count(a, step); },
            [&](const DroppedAnswer& a) { return right_axis(a, step); },
            [&](const QuantityAnswer& a) { return right_quantity(a, story); },
            [&](const ChoiceAnswer& a) {
                RightAnswer right;
                right.choice = a.right;
                right.known = true;
                return right;
            },
            [&](const PointedAnswer& a) { return right_things(a, question, step); },
            [&](const PoseAnswer& a) { return right_pose(a, story, step); },
        },
        question.answer);
}

}  // namespace jw
