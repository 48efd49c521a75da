#include "app/session/solution.hpp"

#include <algorithm>
#include <cmath>

#include "app/session/explanations.hpp"
#include "app/session/labels.hpp"
#include "app/session/numbers.hpp"
#include "core/equations/assembler.hpp"

namespace jw {

namespace {

constexpr double kRoundingOfSum =
    1e-9;  // of a step: a last interval shorter than this is the rounding of the sum

void add_vector(std::vector<std::string>& columns, const std::string& prefix) {
    for (const char* axis : {"x", "y", "z"}) { columns.push_back(prefix + axis); }
}

std::vector<std::string> columns_of(const System& system, Analysis analysis) {
    std::vector<std::string> columns{"time_s"};
    const Mechanism& mechanism = system.mechanism();
    for (const int b : system.moving_bodies()) {
        const std::string& name = mechanism.bodies[static_cast<std::size_t>(b)].name;
        add_vector(columns, name + ".");
        for (const char* e : {"e0", "e1", "e2", "e3"}) { columns.push_back(name + "." + e); }
        if (analysis != Analysis::position) {
            add_vector(columns, name + ".r_dot.");
            add_vector(columns, name + ".omega_local.");
        }
        if (analysis == Analysis::acceleration) {
            add_vector(columns, name + ".r_ddot.");
            add_vector(columns, name + ".omega_local_dot.");
        }
    }
    const std::vector<int> thetas = mechanism.theta_indices();
    for (const int j : system.selection().joints) {
        const auto k = static_cast<std::size_t>(j);
        if (thetas[k] < 0) { continue; }
        columns.push_back(mechanism.joints[k].name + ".theta");
        if (analysis != Analysis::position) { columns.push_back(mechanism.joints[k].name + ".theta_dot"); }
        if (analysis == Analysis::acceleration) {
            columns.push_back(mechanism.joints[k].name + ".theta_ddot");
        }
    }
    columns.push_back("residual");
    return columns;
}

SweepRow row_of(const System& system, const MotionFrame& frame, Analysis analysis) {
    SweepRow row;
    const auto add = [&](const auto& v) { row.values.insert(row.values.end(), v.begin(), v.end()); };
    row.values.push_back(frame.t);
    for (const int body : system.moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        add(frame.state.r[b]);
        add(frame.state.p[b]);
        if (analysis != Analysis::position) {
            add(frame.velocity.r_dot[b]);
            add(frame.velocity.omega_local[b]);
        }
        if (analysis == Analysis::acceleration) {
            add(frame.acceleration.r_dot[b]);
            add(frame.acceleration.omega_local[b]);
        }
    }
    const std::vector<int> thetas = system.mechanism().theta_indices();
    for (const int j : system.selection().joints) {
        if (thetas[static_cast<std::size_t>(j)] < 0) { continue; }
        const auto theta = static_cast<std::size_t>(thetas[static_cast<std::size_t>(j)]);
        row.values.push_back(frame.state.theta[theta]);
        if (analysis != Analysis::position) { row.values.push_back(frame.velocity.theta_dot[theta]); }
        if (analysis == Analysis::acceleration) { row.values.push_back(frame.acceleration.theta_dot[theta]); }
    }
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(frame.state, frame.t);
    row.values.push_back(assembler.phi().size() > 0 ? assembler.phi().cwiseAbs().maxCoeff() : 0.0);

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

/// What an equation asks for, as a rate or an acceleration: "91 deg/s" of a driven angle.
std::string asked_text(const System& system, int row, double value, const std::string& per, double t) {
    const RowOrigin origin = system.origin(row);
    if (origin.kind != RowOrigin::Kind::driver) { return number_text(value, 6) + " 1" + per; }
    const int index = system.drivers()[static_cast<std::size_t>(origin.index)].driver;
    const Driver& driver = system.mechanism().drivers[static_cast<std::size_t>(index)];
    if (std::holds_alternative<SquaredDistanceMeasure>(driver.measure)) {
        return number_text(value / (2.0 * driver.function.at(t).f), 6) + " m" + per;
    }
    const bool is_angle = std::holds_alternative<AngleMeasure>(driver.measure) ||
                          std::holds_alternative<ThetaMeasure>(driver.measure);
    return is_angle ? number_text(value * kDegreesPerRadian, 6) + " deg" + per
                    : number_text(value, 6) + " m" + per;
}

/// The redundant equation that misses what those that it repeats ask for by most.
/// @param asked right sides: ν or γ
std::string contradiction_of(
    const System& system, const MotionFrame& frame, const VectorX& asked, const std::string& what,
    const std::string& per) {
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
        // joints ask for 0: among drivers it is they who contradict each other
        if (asked(term.row) == 0.0 || std::ranges::find(owners, owner) != owners.end()) { continue; }
        owners.push_back(owner);
    }
    const std::string self = row_owner(system, worst->row);
    return "at t = " + number_text(frame.t, 6) + " s " + self + " repeats " +
           (owners.empty() ? "other equations" : listed(owners)) + " and asks for another " + what + ": " +
           asked_text(system, worst->row, asked(worst->row), per, frame.t) + " instead of " +
           asked_text(system, worst->row, implied, per, frame.t);
}

/// Of velocities, or of accelerations where velocities agree.
std::string contradiction_at(const System& system, const MotionFrame& frame) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(frame.state, frame.t);
    if (!frame.velocity_verdict.consistent) {
        assembler.assemble_nu(frame.t);
        return contradiction_of(system, frame, assembler.nu(), "rate", "/s");
    }
    assembler.assemble_gamma(frame.state, frame.velocity, frame.t);
    return contradiction_of(system, frame, assembler.gamma(), "acceleration", "/s²");
}

}  // namespace

std::vector<double> times_of(const SweepPlan& plan) {
    std::vector<double> times;
    const auto whole = static_cast<long>(std::floor((plan.to - plan.from) / plan.step + kRoundingOfSum));
    // products, not sums: the rounding of the last time is that of one multiplication
    for (long k = 0; k <= whole; ++k) { times.push_back(plan.from + static_cast<double>(k) * plan.step); }
    if (plan.to - times.back() > kRoundingOfSum * plan.step) { times.push_back(plan.to); }
    return times;
}

Sweep solve_sweep(
    const Lesson& lesson, const SweepPlan& plan, const std::function<void(double fraction)>& progress) {
    const Story story(lesson, last_pose_only());
    const Step& last = story.steps().back();
    if (last.failure) { throw not_reached(lesson, last); }

    System system = *last.system;
    MotionTracker tracker(system, last.state, last.t, plan.analysis == Analysis::acceleration);
    Sweep sweep;
    sweep.columns = columns_of(system, plan.analysis);
    const std::vector<double> times = times_of(plan);
    for (std::size_t k = 0; k < times.size(); ++k) {
        bool switched = false;
        if (!advance_along(tracker, lesson, times[k], switched)) {
            sweep.failure = not_reached(lesson, system, *tracker.failure()).what();
            return sweep;
        }
        sweep.rows.push_back(row_of(system, tracker.frame(), plan.analysis));
        if (!sweep.rows.back().consistent && sweep.contradiction.empty()) {
            sweep.contradiction = contradiction_at(system, tracker.frame());
        }
        if (progress) { progress(static_cast<double>(k + 1) / static_cast<double>(times.size())); }
    }
    return sweep;
}

}  // namespace jw
