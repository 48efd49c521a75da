#include "app/session/checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/session/dynamics_run.hpp"
#include "app/session/explanations.hpp"
#include "app/session/labels.hpp"
#include "app/session/numbers.hpp"
#include "app/session/quantities.hpp"
#include "app/session/sentences.hpp"
#include "app/session/story.hpp"
#include "core/equations/assembler.hpp"

namespace jw {

namespace {

// poses "around" a singular one: far enough for its singular value to be plain, near enough to be its
// neighbours
constexpr double kNearby = 1e-2;

/// A pose at which claims are judged, or why there is none.
struct Pose {
    std::shared_ptr<const System> system;
    State state;
    Motion velocity;
    Motion acceleration;
    double t = 0.0;
    bool change_point = false;  ///< as the motion met it
    std::string failure;        ///< not empty: the pose was not reached
};

std::string text_of(const Moment& moment, const Lesson& lesson) {
    if (std::holds_alternative<AsGiven>(moment)) { return "as given"; }
    if (const auto* at = std::get_if<AtTime>(&moment)) { return "at " + number_text(at->t, 6) + " s"; }
    const int count = std::get<AfterAddition>(moment).count;
    if (count == 0) { return "free bodies"; }
    const Addition& a = lesson.order[static_cast<std::size_t>(count - 1)];
    const auto k = static_cast<std::size_t>(a.index);
    return "after " + (a.kind == Addition::Kind::joint ? lesson.mechanism.joints[k].name
                                                       : lesson.mechanism.drivers[k].name);
}

/// Poses of all moments that are asked for, each found once.
class Poses {
public:
    explicit Poses(const Lesson& lesson) : lesson_(&lesson), story_(lesson, what_claims_need(lesson)) {
        const auto is_of_motion = [](const Claim& c) { return std::holds_alternative<AtTime>(c.when); };
        if (std::ranges::any_of(lesson.claims, is_of_motion)) { follow_motion(); }
    }

    Pose at(const Moment& moment) const {
        if (std::holds_alternative<AsGiven>(moment)) { return as_given(); }
        if (const auto* at = std::get_if<AtTime>(&moment)) { return motion_.at(at->t); }
        return after(std::get<AfterAddition>(moment).count);
    }

private:
    /// As many joints and drivers as the claims speak of.
    static StoryOptions what_claims_need(const Lesson& lesson) {
        StoryOptions options = poses_only();
        options.additions = 0;
        for (const Claim& claim : lesson.claims) {
            if (const auto* after = std::get_if<AfterAddition>(&claim.when)) {
                options.additions = std::max(options.additions, after->count);
            }
            if (std::holds_alternative<AtTime>(claim.when)) {
                options.additions = static_cast<int>(lesson.order.size());
            }
        }
        return options;
    }

    Pose as_given() const {
        Pose pose;
        pose.state = start_state(lesson_->mechanism);
        auto system = std::make_shared<System>(
            lesson_->mechanism, selection_of(*lesson_, static_cast<int>(lesson_->order.size())));
        system->choose_rows(pose.state);
        pose.system = system;
        pose.velocity = start_motion(lesson_->mechanism);
        pose.acceleration = zero_motion(lesson_->mechanism);
        pose.t = start_time(*lesson_);
        return pose;
    }

    Pose after(int count) const {
        Pose pose = as_given();
        for (const Step& step : story_.steps()) {
            if (step.additions != count) { continue; }
            if (step.kind == Step::Kind::assembled || step.kind == Step::Kind::bodies) {
                pose.system = step.system;
                pose.state = step.state;
                return pose;
            }
        }
        pose.failure = failure_text(*story_.failure());
        return pose;
    }

    void follow_motion() {
        std::vector<double> times;
        for (const Claim& claim : lesson_->claims) {
            if (const auto* at = std::get_if<AtTime>(&claim.when)) { times.push_back(at->t); }
        }
        // the lesson's own intervals as well: a claim must not depend on how many others there are
        const MotionPlan& plan = *lesson_->motion;
        const double last = *std::ranges::max_element(times);
        for (int k = 0; k <= plan.steps; ++k) {
            const double t = plan.from + (plan.to - plan.from) * k / plan.steps;
            if (t < last) { times.push_back(t); }
        }
        std::ranges::sort(times);
        const Pose start = after(static_cast<int>(lesson_->order.size()));
        if (!start.failure.empty()) {
            for (const double t : times) { motion_[t] = start; }
            return;
        }
        System system = *start.system;
        MotionTracker tracker(system, start.state, plan.from);
        std::string failure;
        for (const double t : times) {
            if (failure.empty() && !tracker.advance_to(t)) {
                failure = failure_text(system, *tracker.failure());
            }
            const MotionFrame& frame = tracker.frame();
            motion_[t] = {
                std::make_shared<System>(system),
                frame.state,
                frame.velocity,
                frame.acceleration,
                t,
                frame.change_point,
                failure};
        }
    }

    const Lesson* lesson_;
    Story story_;
    std::map<double, Pose> motion_;
};

/// The pose is singular if it can be moved to one where the rank is higher.
bool rank_grows_nearby(const Pose& pose, const RankReport& report) {
    const Layout<OmegaLocal> layout(*pose.system);
    for (const FreeMotion& motion : report.free_motions) {
        for (const double step : {kNearby, -kNearby}) {
            State state = pose.state;
            layout.advance(state, step * motion);
            if (!solve_position<OmegaLocal>(*pose.system, state, pose.t).ok()) { continue; }
            if (rank_of(*pose.system, state, pose.t).rank > report.rank) { return true; }
        }
    }
    return false;
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

const char* name_of(Count count) {
    switch (count) {
        case Count::rank: return "rank";
        case Count::rows: return "rows";
        case Count::columns: return "columns";
        case Count::dof: return "dof";
        case Count::redundant: return "redundant";
        case Count::mobility_by_counting: break;
    }
    return "mobility by counting";
}

double measured(const Quantity& quantity, const Pose& pose, int derivative) {
    const Mechanism& mechanism = pose.system->mechanism();
    if (const auto* m = std::get_if<MeasureQuantity>(&quantity)) {
        const int theta = m->joint < 0 ? -1 : mechanism.theta_indices()[static_cast<std::size_t>(m->joint)];
        Measured value = evaluate_measure(
            m->measure, m->body_i, m->body_j, theta, pose.state, pose.velocity, pose.acceleration);
        if (std::holds_alternative<SquaredDistanceMeasure>(m->measure)) { value = distance_of(value); }
        return derivative == 0 ? value.value : (derivative == 1 ? value.rate : value.acceleration);
    }
    if (const auto* w = std::get_if<AngularVelocityQuantity>(&quantity)) {
        const auto b = static_cast<std::size_t>(w->body);
        const Vec3& local = derivative == 0 ? pose.velocity.omega_local[b] : pose.acceleration.omega_local[b];
        // ω̇ = A ω̇': no extra term
        return (w->local ? local : Vec3(rotation_matrix(pose.state.p[b]) * local))(w->component);
    }
    const auto& point = std::get<PointQuantity>(quantity);
    const auto b = static_cast<std::size_t>(point.body);
    const Mat3 A = rotation_matrix(pose.state.p[b]);
    const Vec3 s = A * point.s_local;
    const Vec3 omega = A * pose.velocity.omega_local[b];
    if (derivative == 0) { return (pose.state.r[b] + s)(point.component); }
    if (derivative == 1) { return (pose.velocity.r_dot[b] + omega.cross(s))(point.component); }
    const Vec3 omega_dot = A * pose.acceleration.omega_local[b];
    return (pose.acceleration.r_dot[b] + omega_dot.cross(s) + omega.cross(omega.cross(s)))(point.component);
}

std::string unit_text(const QuantityClaim& claim) {
    constexpr std::array per_time{"", "/s", "/s²"};
    const std::string rate = per_time[static_cast<std::size_t>(claim.derivative)];
    switch (claim.unit) {
        case Unit::none: return rate.empty() ? "" : " 1" + rate;
        case Unit::metre: return " m" + rate;
        case Unit::radian: return (claim.in_degrees ? " deg" : " rad") + rate;
        case Unit::radian_per_second: break;
    }
    return claim.derivative == 0 ? " rad/s" : " rad/s²";
}

bool is_plain_angle(const QuantityClaim& claim) {
    const auto* m = std::get_if<MeasureQuantity>(&claim.quantity);
    return claim.derivative == 0 && m != nullptr && std::holds_alternative<AngleMeasure>(m->measure);
}

void judge(const QuantityClaim& claim, const Pose& pose, ClaimResult& result) {
    const double found = measured(claim.quantity, pose, claim.derivative);
    double difference = found - claim.value;
    if (is_plain_angle(claim)) { difference = std::remainder(difference, 2.0 * std::numbers::pi); }
    const double factor = claim.in_degrees ? kDegreesPerRadian : 1.0;
    const std::string unit = unit_text(claim);
    result.subject =
        claim.text + (claim.derivative == 0 ? "" : (claim.derivative == 1 ? " rate" : " acceleration"));
    result.expected =
        number_text(factor * claim.value, 12) + unit + " ± " + number_text(factor * claim.tolerance, 3);
    result.found = number_text(factor * found, 15) + unit + ", off by " + small_text(factor * difference);
    result.holds = std::abs(difference) <= claim.tolerance;
}

void judge(const CountClaim& claim, const Pose& pose, ClaimResult& result) {
    const RankReport report = rank_of(*pose.system, pose.state, pose.t);
    const int found = count_of(report, claim.count);
    const bool of_rank =
        claim.count == Count::rank || claim.count == Count::dof || claim.count == Count::redundant;
    result.subject = name_of(claim.count);
    result.expected = std::to_string(claim.value);
    result.found = std::to_string(found);
    result.holds = found == claim.value;
    if (of_rank && !report.decided) {
        result.found += "; " + undecided_text(report);
        result.holds = false;
    }
}

void judge(const DroppedClaim& claim, const Pose& pose, ClaimResult& result) {
    const Joint& joint = pose.system->mechanism().joints[static_cast<std::size_t>(claim.joint)];
    result.subject = "dropped of " + joint.name + " " + name_of_role(claim.role, joint.parallel_form);
    result.expected = axis_name(claim.component);
    result.found = "nothing";
    for (const Constraint& c : pose.system->constraints()) {
        if (c.joint != claim.joint || c.role != claim.role || c.dropped < 0) { continue; }
        result.found = axis_name(c.dropped);
        result.holds = c.dropped == claim.component;
    }
}

/// Largest |Φ| in the scene's units, as in RankReport.
double residual_of(const Pose& pose) {
    Assembler<OmegaLocal> assembler(*pose.system);
    assembler.assemble_phi_and_jacobian(pose.state, pose.t);
    double largest = 0.0;
    for (int row = 0; row < pose.system->rows(); ++row) {
        largest = std::max(largest, std::abs(assembler.phi()(row) / pose.system->row_unit(row)));
    }
    return largest;
}

/// σ_1 / σ_r; an estimate is no proof, so of large systems, too, by singular values.
double condition_of(const Pose& pose) {
    const RankReport report = rank_of(*pose.system, pose.state, pose.t, true);
    return report.rank > 0 ? report.first_value() / report.last_value() : 1.0;
}

void judge(const BoundClaim& claim, const Pose& pose, ClaimResult& result) {
    const bool residual = claim.bound == Bound::residual_below;
    const double found = residual ? residual_of(pose) : condition_of(pose);
    result.subject = residual ? "residual" : "condition";
    const bool above = claim.bound == Bound::condition_above;
    result.expected = (above ? "above " : "below ") + number_text(claim.limit, 6);
    result.found = number_text(found, 6);
    result.holds = above ? found > claim.limit : found < claim.limit;
}

void judge(const VerdictClaim& claim, const Pose& pose, ClaimResult& result) {
    const RankReport report = rank_of(*pose.system, pose.state, pose.t, true);  // with free motions
    const bool found = pose.change_point || report.near_singular || rank_grows_nearby(pose, report);
    result.subject = "change point";
    result.expected = claim.value ? "yes" : "no";
    result.found = found ? "yes" : "no";
    result.holds = found == claim.value;
}

ClaimResult judged(const Claim& claim, const Pose& pose) {
    ClaimResult result;
    const auto* verdict = std::get_if<VerdictClaim>(&claim.fact);
    if (verdict != nullptr && verdict->verdict == Verdict::closes) {
        result.subject = "closes";
        result.expected = verdict->value ? "yes" : "no";
        result.found = pose.failure.empty() ? "yes" : "no: " + pose.failure;
        result.holds = verdict->value == pose.failure.empty();
    } else if (!pose.failure.empty()) {
        result.subject = "this claim";
        result.expected = "a pose that closes";
        result.found = pose.failure;
    } else {
        std::visit([&](const auto& fact) { judge(fact, pose, result); }, claim.fact);
    }
    result.span = claim.span;
    result.why = claim.why;
    return result;
}

/// Where the lesson's point is after its duration. @return why there is no such place, or nothing
std::string find_end(const Lesson& lesson, double tolerance, Vec3& end) {
    const DynamicsPlan& plan = *lesson.dynamics;
    SimulationSettings settings;
    const MethodName& method = entry_of(plan.method);
    settings.method = method.kind == MethodKind::radau ? plan.method : Method::explicit_8;
    settings.tolerance = tolerance;
    settings.most_steps = kMostStepsUnasked;
    Simulation simulation(lesson.mechanism, plan.loads, settings);
    const SimulationOutcome outcome =
        simulation.run({0.0, plan.duration}, [&](double, const std::vector<double>& y) {
            end = simulation.point(y, plan.point->body, plan.point->point_local);
        });
    return outcome.failure ? failure_text(*outcome.failure, settings, lesson.mechanism) : std::string();
}

/// A claim that a trusted computation has made about the end of the motion. Two tolerances say how far the
/// own computation can be trusted.
ClaimResult judged_end(const Lesson& lesson) {
    constexpr double loose = 1e-8;
    constexpr double tight = 1e-10;
    constexpr double far =
        1e-6;  // of the scene: more than both leave open, less than a wrong digit that matters
    const DynamicsPlan& plan = *lesson.dynamics;
    const double allowed = far * extent(lesson.mechanism);
    ClaimResult result;
    result.span = plan.point_at_end_span;
    result.moment = "at " + number_text(plan.duration, 6) + " s";
    result.subject = "point_at_end";
    result.expected = vector_text(*plan.point_at_end, 10) + " m ± " + number_text(allowed, 3);
    Vec3 rough = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    for (const auto& [tolerance, place] : {std::pair{loose, &rough}, std::pair{tight, &end}}) {
        const std::string failure = find_end(lesson, tolerance, *place);
        if (failure.empty()) { continue; }
        result.found = failure;
        return result;
    }
    const double uncertain = (end - rough).norm();
    const double off = (end - *plan.point_at_end).norm();
    result.found = vector_text(end, 10) + " m, off by " + small_text(off);
    if (uncertain > allowed) {
        result.found += "; two runs of different tolerance are " + small_text(uncertain) +
                        " m apart there, so this cannot be proved";
        return result;
    }
    result.holds = off <= allowed;
    return result;
}

}  // namespace

std::vector<ClaimResult> check_claims(const Lesson& lesson) {
    const Poses poses(lesson);
    std::vector<ClaimResult> results;
    for (const Claim& claim : lesson.claims) {
        results.push_back(judged(claim, poses.at(claim.when)));
        results.back().moment = text_of(claim.when, lesson);
    }
    if (lesson.dynamics && lesson.dynamics->point && lesson.dynamics->point_at_end) {
        results.push_back(judged_end(lesson));
    }
    return results;
}

}  // namespace jw
