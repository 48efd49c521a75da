#include "app/session/view/solution.hpp"

#include <algorithm>
#include <cmath>

#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/taking_part.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/equations/assembler.hpp"
#include "core/motion/spring_turns.hpp"
#include "core/quantity/evaluate.hpp"
#include "core/quantity/quantity.hpp"

namespace jw {

namespace {

constexpr double kRoundingOfSum =
    1e-9;  // of a step: a last interval shorter than this is the rounding of the sum

/// Quantities that an analysis yields for every moving body, then for every screw.
std::vector<NamedQuantity> quantities_of(const System& system, Analysis analysis) {
    std::vector<NamedQuantity> list;
    const int highest = static_cast<int>(analysis);
    for (const int b : system.moving_bodies()) {
        const auto add_place = [&](int derivative, int count) {
            for (int k = 0; k < count; ++k) {
                list.push_back({MeasureQuantity{CoordinateMeasure{k}, 0, b, -1, -1}, derivative});
            }
        };
        add_place(0, 7);
        for (int derivative = 1; derivative <= highest; ++derivative) {
            add_place(derivative, 3);
            for (int k = 0; k < 3; ++k) {
                list.push_back({AngularVelocityQuantity{b, true, k}, derivative - 1});
            }
        }
    }
    for (const int j : system.selection().joints) {
        if (system.mechanism().joints[at(j)].type->artificial == 0) { continue; }
        for (int derivative = 0; derivative <= highest; ++derivative) {
            list.push_back({measures_of(system.mechanism(), j).front(), derivative});
        }
    }
    return list;
}

std::vector<std::string> columns_of(
    const std::vector<NamedQuantity>& list, const SweepPlan& plan, const Mechanism& mechanism) {
    std::vector<std::string> columns{"time_s"};
    for (const NamedQuantity& q : list) { columns.push_back(name_of(q.quantity, q.derivative, mechanism)); }
    columns.push_back("residual");
    for (const NamedQuantity& q : plan.quantities) {
        columns.push_back(name_of(q.quantity, q.derivative, mechanism));
    }
    return columns;
}

SweepRow row_of(
    const System& system, const MotionFrame& frame, const SweepPlan& plan,
    const std::vector<NamedQuantity>& list, const std::shared_ptr<const Centroidal>& scene) {
    const Analysis analysis = plan.analysis;
    SweepRow row;
    // does not own the system, which outlives the instant
    Instant instant = instant_of({std::shared_ptr<const System>(), &system}, frame);
    if (analysis != Analysis::acceleration && plan.quantities.empty()) { instant.acceleration = {}; }
    instant.scene = scene;
    const auto add = [&](const NamedQuantity& q) {
        row.values.push_back(evaluate(q.quantity, instant, q.derivative).derivatives[at(q.derivative)]);
    };
    row.values.push_back(frame.t);
    for (const NamedQuantity& q : list) { add(q); }
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(frame.state, frame.t);
    row.values.push_back(assembler.phi().size() > 0 ? assembler.phi().cwiseAbs().maxCoeff() : 0.0);
    for (const NamedQuantity& q : plan.quantities) { add(q); }

    row.residuals = residuals_of(system, frame.state, frame.velocity, frame.acceleration, frame.t);
    row.change_point = frame.change_point;
    if (analysis == Analysis::position) { return row; }
    row.unique = frame.velocity_verdict.unique;
    row.consistent = frame.velocity_verdict.consistent;
    if (analysis == Analysis::acceleration) {
        row.consistent = row.consistent && frame.acceleration_verdict.consistent;
    }
    return row;
}

/// Rate or acceleration that an equation demands, as text: "91 deg/s" for a driven angle.
std::string asked_text(const System& system, int row, double value, const std::string& per, double t) {
    const RowOrigin origin = system.origin(row);
    if (origin.kind != RowOrigin::Kind::driver) { return number_text(value, 6) + " 1" + per; }
    const int index = system.drivers()[at(origin.index)].driver;
    const Driver& driver = system.mechanism().drivers[at(index)];
    if (std::holds_alternative<SquaredDistanceMeasure>(driver.measure)) {
        return number_text(value / (2.0 * driver.function.at(t).f), 6) + " m" + per;
    }
    const Unit unit = unit_of(driver.measure);
    if (unit == Unit::radian) { return number_text(value * kDegreesPerRadian, 6) + " deg" + per; }
    return number_text(value, 6) + (unit == Unit::metre ? " m" : " 1") + per;
}

/// Text about the redundant equation whose right side differs most from the one that the others imply.
/// @param asked    right sides: ν or γ
/// @param of_rates  true: `asked` is ν
std::string contradiction_of(
    const System& system, const MotionFrame& frame, const VectorX& asked, bool of_rates) {
    const RankReport report = rank_of(system, frame.state, frame.t);
    const RedundantRow* worst = nullptr;
    double most = 0.0;
    double implied = 0.0;
    for (const RedundantRow& redundant : report.redundant_rows) {
        double sum = 0.0;
        for (const RedundantRow::Term& term : redundant.terms) { sum += term.coefficient * asked(term.row); }
        const double miss = std::abs(sum - asked(redundant.row)) / system.row_unit(redundant.row);
        if (miss <= most) { continue; }
        worst = &redundant;
        most = miss;
        implied = sum;
    }
    if (worst == nullptr) { return {}; }
    std::vector<std::string> owners;
    for (const RedundantRow::Term& term : worst->terms) {
        const std::string owner = row_owner(system, term.row);
        // joints ask for 0, so the contradiction is between drivers
        if (asked(term.row) == 0.0 || std::ranges::find(owners, owner) != owners.end()) { continue; }
        owners.push_back(owner);
    }
    const std::string t = number_text(frame.t, 6);
    const std::string self = row_owner(system, worst->row);
    const std::string others = owners.empty() ? tr("other equations") : listed(owners);
    const std::string per = of_rates ? "/s" : "/s²";
    const std::string one = asked_text(system, worst->row, asked(worst->row), per, frame.t);
    const std::string other = asked_text(system, worst->row, implied, per, frame.t);
    return of_rates ? tr("at t = {0} s the equation of {1} depends linearly on {2}, but requires another "
                         "rate: {3} instead of {4}",
                         t, self, others, one, other)
                    : tr("at t = {0} s the equation of {1} depends linearly on {2}, but requires another "
                         "acceleration: {3} instead of {4}",
                         t, self, others, one, other);
}

/// Contradiction of the velocity equations, or of the acceleration equations where velocities agree.
std::string contradiction_at(const System& system, const MotionFrame& frame) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(frame.state, frame.t);
    if (!frame.velocity_verdict.consistent) {
        assembler.assemble_nu(frame.t);
        return contradiction_of(system, frame, assembler.nu(), true);
    }
    assembler.assemble_gamma(frame.state, frame.velocity, frame.t);
    return contradiction_of(system, frame, assembler.gamma(), false);
}

std::vector<double> times_of(const SweepPlan& plan) {
    std::vector<double> times;
    const auto whole = static_cast<long>(std::floor((plan.to - plan.from) / plan.step + kRoundingOfSum));
    // products instead of sums, so that the last time has the rounding of one multiplication
    for (long k = 0; k <= whole; ++k) { times.push_back(plan.from + static_cast<double>(k) * plan.step); }
    if (plan.to - times.back() > kRoundingOfSum * plan.step) { times.push_back(plan.to); }
    return times;
}

}  // namespace

Sweep solve_sweep(
    const Lesson& lesson, const SweepPlan& plan, const std::function<void(double fraction)>& progress) {
    const bool is_beyond = !lesson.motion || plan.from < lesson.motion->from || plan.to > lesson.motion->to;
    if (is_beyond) { require_formulas(lesson, plan.from, plan.to); }
    const Story story(lesson, last_pose_only());
    const Step& last = story.steps().back();
    if (last.failure) { throw not_reached(lesson, last); }

    System system = *last.system;
    const bool wants_accelerations = plan.analysis == Analysis::acceleration || !plan.quantities.empty();
    MotionTracker tracker(system, last.state, last.t, wants_accelerations);
    const std::vector<NamedQuantity> list = quantities_of(system, plan.analysis);
    const auto scene = plan.quantities.empty() ? nullptr : scene_of(lesson);
    Sweep sweep;
    std::optional<ProofRecorder> recorder;
    if (plan.with_proof) {
        sweep.system = last.system;
        recorder.emplace(*sweep.system);
    }
    sweep.columns = columns_of(list, plan, lesson.mechanism);
    const std::vector<double> times = times_of(plan);
    const SpringTurns springs(scene, tracker.frame().state, tracker.frame().turns);
    for (std::size_t k = 0; k < times.size(); ++k) {
        bool switched = false;
        if (!advance_along(tracker, lesson, times[k], switched)) {
            sweep.failure = not_reached(lesson, system, *tracker.failure()).what();
            break;
        }
        if (recorder) { recorder->add(tracker.frame()); }
        sweep.rows.push_back(row_of(
            system, tracker.frame(), plan, list, springs.at(tracker.frame().state, tracker.frame().turns)));
        if (!sweep.rows.back().consistent && sweep.contradiction.empty()) {
            sweep.contradiction = contradiction_at(system, tracker.frame());
        }
        if (progress) { progress(static_cast<double>(k + 1) / static_cast<double>(times.size())); }
    }
    sweep.crossings = tracker.crossings();
    if (recorder) { sweep.proof = recorder->take(); }
    return sweep;
}

}  // namespace jw
