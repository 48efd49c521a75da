#include "app/session/rest/rest.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/session/story/story_telling.hpp"
#include "app/session/story/taking_part.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/jets/euler_parameters.hpp"

namespace jw {

namespace {

/// False for a distance: a rod keeps its length.
bool is_coordinate(const MeasureQuantity& q) {
    return !std::holds_alternative<SquaredDistanceMeasure>(q.measure);
}

/// Measure of the joint that a name such as "hinge" or "hinge.angle" means.
MeasureQuantity held_measure(const std::string& name, const Mechanism& mechanism) {
    std::vector<std::string> known;
    std::vector<MeasureQuantity> fitting;
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
        for (const MeasureQuantity& q : measures_of(mechanism, static_cast<int>(j))) {
            if (!is_coordinate(q)) { continue; }
            known.push_back(name_of(q, 0, mechanism));
            if (name == known.back() || name == mechanism.joints[j].name) { fitting.push_back(q); }
        }
    }
    if (fitting.size() == 1) { return fitting.front(); }
    const std::string expected =
        known.empty() ? "no joint has an angle or a displacement" : "expected one of " + alternatives(known);
    throw std::invalid_argument(
        "--hold '" + name + "': " +
        (fitting.empty() ? "there is no such angle or displacement; "
                         : "this joint has an angle and a displacement; ") +
        expected);
}

/// Throws if a driver already prescribes this measure.
void check_not_driven(const std::string& name, const MeasureQuantity& q, const Mechanism& mechanism) {
    // the angle of a screw determines its displacement
    const bool is_one = mechanism.joints[at(q.joint)].type->artificial > 0;
    for (const Driver& driver : mechanism.drivers) {
        if (driver.joint != q.joint || (!is_one && driver.measure.index() != q.measure.index())) { continue; }
        throw std::invalid_argument(
            "--hold '" + name + "': '" + driver.name +
            "' prescribes it already; expected a joint that is neither driven nor held");
    }
}

/// The mechanism without drivers that were taken out.
Mechanism added_of(const Lesson& lesson) {
    Mechanism mechanism = taking_part(lesson);
    std::erase_if(mechanism.drivers, [](const Driver& driver) { return driver.body_i == driver.body_j; });
    return mechanism;
}

/// Adds drivers that hold the named measures at their values in a state.
Mechanism with_held(Mechanism mechanism, const std::vector<std::string>& held, const State& state) {
    const Mechanism before = mechanism;
    const Motion none = zero_motion(before);
    const std::vector<int> thetas = before.theta_indices();
    for (const std::string& name : held) {
        const MeasureQuantity q = held_measure(name, before);
        check_not_driven(name, q, mechanism);
        const int theta = thetas[at(q.joint)];
        const double value = evaluate_measure(q.measure, q.body_i, q.body_j, theta, state, none, none).value;
        mechanism.drivers.push_back(
            {"hold " + name_of(q, 0, before), q.joint, q.body_i, q.body_j, q.measure,
             TimeFunction{.polynomial = {value}}});
    }
    return mechanism;
}

/// Angles, displacements and distances of joints, efforts of drivers, and the potential energy.
std::vector<NamedQuantity> told_quantities(const Mechanism& mechanism) {
    std::vector<NamedQuantity> list;
    for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
        for (const MeasureQuantity& q : measures_of(mechanism, j)) {
            if (is_coordinate(q)) { list.push_back({q, 0}); }
        }
    }
    for (int d = 0; d < static_cast<int>(mechanism.drivers.size()); ++d) {
        const Measure& measure = mechanism.drivers[at(d)].measure;
        const bool turns =
            std::holds_alternative<AngleMeasure>(measure) || std::holds_alternative<ThetaMeasure>(measure);
        list.push_back({EffortQuantity{d, turns}, 0});
    }
    list.push_back({EnergyQuantity{EnergyPart::potential}, 0});
    return list;
}

/// Quantities that describe a small motion: angles and displacements of joints, and the rotation of a body on
/// a joint that has neither, as on a ball.
std::vector<NamedQuantity> moving_quantities(const Mechanism& mechanism) {
    std::vector<NamedQuantity> list;
    std::vector<bool> has_turns(mechanism.bodies.size(), false);
    for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
        const Joint& joint = mechanism.joints[at(j)];
        const std::vector<MeasureQuantity> measures = measures_of(mechanism, j);
        for (const MeasureQuantity& q : measures) {
            if (is_coordinate(q)) { list.push_back({q, 1}); }
        }
        if (!measures.empty() || mechanism.bodies[at(joint.body_j)].fixed || has_turns[at(joint.body_j)]) {
            continue;
        }
        has_turns[at(joint.body_j)] = true;
        for (int axis = 0; axis < 3; ++axis) {
            list.push_back({AngularVelocityQuantity{joint.body_j, false, axis}, 0});
        }
    }
    return list;
}

/// Amplitudes of all joints in a mode, the largest first and 1; displacements are measured in extents.
std::vector<ModeOfJoint> joints_of(
    const Mode& mode, const RestView& view, const Centroidal& scene, const State& centroidal_state) {
    Instant now = view.instant;
    Instant late = view.instant;
    now.velocity = scene.as_given(centroidal_state, mode.shape);
    late.velocity = scene.as_given(centroidal_state, mode.shape_late);
    const double length = extent(*view.mechanism);
    const auto size = [&](const ModeOfJoint& joint) {
        const auto* q = std::get_if<MeasureQuantity>(&joint.quantity.quantity);
        return std::abs(joint.amplitude) / (q != nullptr ? unit_of(q->measure, length) : 1.0);
    };
    std::vector<ModeOfJoint> out;
    for (const NamedQuantity& named : moving_quantities(*view.mechanism)) {
        const auto rate = [&](const Instant& instant) {
            return evaluate(named.quantity, instant, named.derivative).derivatives[at(named.derivative)];
        };
        out.push_back({named, {rate(now), rate(late)}});
    }
    std::ranges::stable_sort(out, std::greater<>(), size);
    if (out.empty() || size(out.front()) == 0.0) { return out; }
    const std::complex<double> unit = out.front().amplitude;
    for (ModeOfJoint& joint : out) { joint.amplitude /= unit; }
    return out;
}

/// The body that is accelerated most, and how: "'stone' is still accelerated by 6.9 m/s²".
std::string push_text(const RestView& view) {
    const Motion& a = view.outcome.acceleration;
    const double length = extent(*view.mechanism);
    std::size_t most = 0;
    const auto size = [&](std::size_t b) { return a.r_dot[b].norm() / length + a.omega_local[b].norm(); };
    for (std::size_t b = 0; b < a.r_dot.size(); ++b) {
        if (size(b) > size(most)) { most = b; }
    }
    // a value that is smaller than this fraction of the other is rounding
    constexpr double rounding = 1e-9;
    const double along = a.r_dot[most].norm();
    const double about = a.omega_local[most].norm();
    return tr(
        "There, '{0}' would be accelerated by {1} m/s² and {2} rad/s².", view.mechanism->bodies[most].name,
        number_text(along > rounding * about * length ? along : 0.0),
        number_text(about * length > rounding * along ? about : 0.0));
}

std::string failure_text(const RestView& view) {
    using Failure = RestOutcome::Failure;
    const int steps = view.outcome.steps;
    switch (view.outcome.failure) {
        case Failure::none: return {};
        case Failure::endless:
            return tr("No equilibrium was found in {0} steps: the forces do not change along the motion, and "
                      "nothing resists them.",
                      steps) +
                   " " + push_text(view);
        case Failure::too_many_steps:
            return tr("No equilibrium was found in {0} steps: it is far from the start pose, or only short "
                      "steps are proved to stay on the branch. Choose a start pose nearer to it.",
                      steps) +
                   " " + push_text(view);
        case Failure::no_step:
            return tr("The search ended after {0} steps: no step along the forces is proved to stay on the "
                      "branch. Where branches meet, as in a flat parallelogram, start on the other side.",
                      steps) +
                   " " + push_text(view);
        case Failure::no_value:
            return tr(
                "The search ended after {0} steps: the law '{1}' has no value at the pose that was reached; "
                "expected a law that has one wherever the mechanism moves, also without velocities.",
                steps, view.outcome.law);
        case Failure::no_descent: break;
    }
    return tr("The search ended after {0} steps: no step decreases the forces. There may be no equilibrium, "
              "or it is far from the start.",
              steps) +
           " " + push_text(view);
}

}  // namespace

std::string stability_text(const RestOutcome& outcome) {
    const SmallMotions& motions = outcome.motions;
    if (outcome.freedoms == 0) {
        return tr("The mechanism has no freedom: joints and drivers constrain it completely.");
    }
    if (motions.is_singular) {
        return tr(
            "It is not known whether it is stable: the pose is singular and has more freedoms than nearby "
            "poses have.");
    }
    if (motions.at_kink) {
        return tr(
            "It is not known whether it is stable: the slope of a load's law cannot be proved here, as at "
            "a kink.");
    }
    switch (motions.stability) {
        case Stability::stable:
            return motions.is_conservative ? tr("Stable: the potential energy of the loads is least here.")
                                           : tr("Stable: every small motion decays.");
        case Stability::unstable: {
            const std::complex<double> s = motions.modes.front().s;
            return s.imag() > 0.0 ? tr("Unstable: an oscillation grows by a factor of e in {0} s.",
                                       number_text(1.0 / s.real()))
                                  : tr("Unstable: a small motion grows by a factor of e in {0} s.",
                                       number_text(1.0 / s.real()));
        }
        case Stability::cannot_tell: break;
    }
    const auto unheld = std::ranges::count(motions.modes, std::complex<double>(), &Mode::s);
    return motions.is_conservative
               ? tr_count(
                     static_cast<int>(unheld),
                     "Nothing pushes it away, but along {0} freedom the forces do not change to first order.",
                     "Nothing pushes it away, but along {0} freedoms the forces do not change to first "
                     "order.")
               : tr("It is not known whether it is stable: the loads have no potential, and a small motion "
                    "neither grows nor decays to first order.");
}

RestView find_rest(const Lesson& lesson, const RestRequest& request) {
    if (!lesson.dynamics) {
        throw std::invalid_argument("this lesson has no [dynamics]; expected masses and a table [dynamics]");
    }
    RestSearch search(lesson, request);
    while (search.go_on()) {}
    return search.view();
}

RestSearch::RestSearch(const Lesson& lesson, RestRequest request)
    : lesson_(&lesson), request_(std::move(request)) {
    // not at the first time of [motion]
    StoryOptions at_zero = last_pose_only();
    at_zero.start_time = 0.0;
    telling_ = std::make_unique<StoryTelling>(lesson, at_zero);
}

RestSearch::~RestSearch() = default;

bool RestSearch::go_on() {
    if (search_) { return search_->go_on(); }
    if (!telling_->go_on()) { begin_search(); }
    return true;
}

void RestSearch::begin_search() {
    const Story story = telling_->story();
    if (const Step* failed = story.failure()) { throw not_reached(*lesson_, *failed); }
    const State& assembled = story.steps().back().state;
    view_.seek = request_.seek;
    view_.mechanism =
        std::make_shared<const Mechanism>(with_held(added_of(*lesson_), request_.held, assembled));
    scene_ = std::make_shared<const Centroidal>(centroidal(*view_.mechanism, lesson_->dynamics->loads));
    search_ =
        std::make_unique<EquilibriumSearch>(*scene_, scene_->to_centroidal(assembled), 0.0, request_.seek);
}

RestView RestSearch::view() {
    RestView& view = view_;
    view.outcome = search_->outcome();
    const auto scene =
        std::make_shared<const Centroidal>(scene_->mechanism, view.outcome.loads, scene_->centres);
    Instant& instant = view.instant;
    instant.state = scene->as_given(view.outcome.state);
    instant.turns = view.outcome.turns;
    instant.velocity = zero_motion(*view.mechanism);
    instant.acceleration = instant.velocity;
    instant.centroidal_acceleration = instant.velocity;
    instant.system = std::make_shared<const System>(*view.mechanism, everything(*view.mechanism));
    instant.scene = scene;
    view.quantities = told_quantities(*view.mechanism);
    for (const Mode& mode : view.outcome.motions.modes) {
        view.modes.push_back(joints_of(mode, view, *scene, view.outcome.state));
    }
    const auto rubs = [](const auto& spring) { return spring.friction.size != 0.0; };
    const Loads& loads = lesson_->dynamics->loads;
    view.without_friction =
        std::ranges::any_of(loads.springs, rubs) || std::ranges::any_of(loads.rotational_springs, rubs);
    view.failure = failure_text(view);
    if (!view.failure.empty() && view.without_friction) {
        view.failure +=
            std::string(" ") + tr("Dry friction is neglected: with it, the mechanism may rest where it "
                                  "stands.");
    }
    return std::move(view_);
}

}  // namespace jw
