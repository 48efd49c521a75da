#include "app/session/dynamics_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/numbers.hpp"
#include "core/dynamics/reactions.hpp"
#include "lessons/diagnostics.hpp"

namespace jw {

namespace {

void add_columns(std::vector<std::string>& columns, const std::string& prefix) {
    for (const char* axis : {"x", "y", "z"}) { columns.push_back(prefix + axis); }
}

std::string name_of(const Reaction& reaction, const Mechanism& mechanism) {
    return reaction.joint >= 0 ? mechanism.joints[at(reaction.joint)].name
                               : mechanism.drivers[at(reaction.driver)].name;
}

std::vector<std::string> columns_of(const Lesson& lesson) {
    std::vector<std::string> columns{"time_s"};
    for (const Body& body : lesson.mechanism.bodies) {
        if (body.fixed) { continue; }
        add_columns(columns, body.name + ".");
        for (const char* e : {"e0", "e1", "e2", "e3"}) { columns.push_back(body.name + "." + e); }
        add_columns(columns, body.name + ".r_dot.");
        add_columns(columns, body.name + ".omega_local.");
    }
    for (const char* name :
         {"kinetic_J", "potential_J", "position_violation", "velocity_violation", "p_drift"}) {
        columns.push_back(name);
    }
    return columns;
}

std::vector<double> row_of(const Snapshot& snapshot, const Mechanism& mechanism) {
    std::vector<double> row{snapshot.t};
    const auto add = [&](const auto& v) { row.insert(row.end(), v.begin(), v.end()); };
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        if (mechanism.bodies[b].fixed) { continue; }
        add(snapshot.state.r[b]);
        add(snapshot.state.p[b]);
        add(snapshot.velocity.r_dot[b]);
        add(snapshot.velocity.omega_local[b]);
    }
    row.insert(
        row.end(), {snapshot.kinetic, snapshot.potential, snapshot.position_violation,
                    snapshot.velocity_violation, snapshot.p_drift});
    return row;
}

void add_reactions(
    const Reactions& found, const Mechanism& mechanism, DynamicsTable& table, std::vector<double>& row) {
    const bool first = table.rows.empty();
    for (const Reaction& reaction : found.reactions) {
        const std::string name = name_of(reaction, mechanism);
        if (first) {
            add_columns(table.columns, name + ".force.");
            add_columns(table.columns, name + ".torque.");
        }
        row.insert(row.end(), reaction.wrench.force.begin(), reaction.wrench.force.end());
        row.insert(row.end(), reaction.wrench.torque.begin(), reaction.wrench.torque.end());
        const bool known = std::ranges::find(table.not_unique, name) != table.not_unique.end();
        if (!reaction.unique() && !known) { table.not_unique.push_back(name); }
    }
}

std::string summary_of(const DynamicsTable& table, std::size_t kinetic) {
    const IntegrationCounts& c = table.outcome.counts;
    std::string text = std::to_string(c.steps) + " steps, " + std::to_string(c.rejected) + " rejected, " +
                       std::to_string(c.evaluations) + " evaluations, " + std::to_string(c.projections) +
                       " projections";
    if (c.singular_passages > 0) {
        text += ", " + std::to_string(c.singular_passages) + " steps near a singular position";
    }
    if (c.row_choices > 0) { text += ", rows chosen anew " + std::to_string(c.row_choices) + " times"; }
    double position = 0.0;
    double energy = 0.0;
    for (const std::vector<double>& row : table.rows) {
        const auto sum = [&](const std::vector<double>& r) { return r[kinetic] + r[kinetic + 1]; };
        energy = std::max(energy, std::abs(sum(row) - sum(table.rows.front())));
        position = std::max(position, row[kinetic + 2]);
    }
    return text + "; energy changed by up to " + number_text(energy, 3) + " J, constraints off by up to " +
           number_text(position, 2) + ", accelerations proved to " +
           small_text(std::max(table.outcome.residual.forces, table.outcome.residual.constraints));
}

/// Where branches of a loop cross, they do so only as far as its numbers fit.
std::string fit_note(const DynamicsTable& table, std::size_t kinetic) {
    constexpr double twelve_digits = 3e-12;
    if (table.outcome.counts.singular_passages == 0 || table.rows.empty()) { return {}; }
    const double left_open = table.rows.front()[kinetic + 2];
    if (left_open < twelve_digits) { return {}; }
    return "equations that repeat others are off by " + small_text(left_open) +
           " at the start, so that branches that should cross near a singular position part there: it may go "
           "on folded; numbers with 12 digits and more keep it on its branch";
}

/// Shortly before, as long as that is after the start: at the end itself there may be no pose.
std::string look_at(double t) {
    if (t <= 0.0) { return "look at that pose with 'jointwise inspect'"; }
    return "look at it shortly before, with 'jointwise inspect --time " + number_text(0.99 * t, 3) + "'";
}

/// @param violation by the size of the scene
std::string what_contradicts(double violation) {
    constexpr double typed = 1e-3;
    if (violation > typed) {
        return "joints of a loop whose axes or points do not fit, or drivers that lead apart, cannot be kept "
               "together";
    }
    return "points and axes of a loop want all their digits, or joints that ask for less (a spherical and a "
           "cylindrical one in the place of two revolutes)";
}

}  // namespace

DynamicsRequest request_of(const Lesson& lesson) {
    if (!lesson.dynamics) { throw std::invalid_argument("the lesson has no [dynamics]"); }
    const DynamicsPlan& plan = *lesson.dynamics;
    DynamicsRequest request;
    request.settings.method = plan.method;
    request.settings.treatment = plan.treatment;
    request.settings.tolerance = plan.tolerance;
    request.settings.step = plan.step;
    request.duration = plan.duration;
    return request;
}

std::vector<double> equal_times(double duration, int intervals) {
    std::vector<double> times;
    for (int k = 0; k <= intervals; ++k) { times.push_back(duration * k / intervals); }
    return times;
}

std::string start_note(const Mechanism& given, const Snapshot& start) {
    // what three or four digits leave open is no news
    constexpr double typed = 1e-2;
    const double length = extent(given);
    double fastest = 0.0;
    for (const Body& body : given.bodies) {
        fastest = std::max({fastest, body.r_dot.norm() / length, body.omega_local.norm()});
    }
    for (std::size_t b = 0; b < given.bodies.size(); ++b) {
        const Body& body = given.bodies[b];
        const Vec3& r_dot = start.velocity.r_dot[b];
        const Vec3& omega = start.velocity.omega_local[b];
        const std::string who = "body " + in_quotes(body.name);
        if (const double way = (start.state.r[b] - body.r).norm(); way > typed * length) {
            return "the start poses do not fit the joints, nearest ones that do are used: " + who +
                   " begins " + number_text(way, 3) + " m from where the file has it";
        }
        const std::string fit = "the start velocities do not fit the joints, nearest ones that do are used: ";
        if (body.omega_local.norm() > 0.0 && (omega - body.omega_local).norm() > typed * fastest) {
            return fit + who + " was given " + number_text(body.omega_local.norm(), 4) +
                   " rad/s and begins with " + number_text(omega.norm(), 4) +
                   " rad/s (a joint that is not in its origin asks for a 'velocity' besides)";
        }
        if (body.r_dot.norm() > 0.0 && (r_dot - body.r_dot).norm() > typed * fastest * length) {
            return fit + who + " was given " + number_text(body.r_dot.norm(), 4) + " m/s and begins with " +
                   number_text(r_dot.norm(), 4) + " m/s";
        }
    }
    return {};
}

Mechanism placed_at(const Mechanism& mechanism, const State& state) {
    Mechanism placed = mechanism;
    for (std::size_t b = 0; b < placed.bodies.size(); ++b) {
        placed.bodies[b].r = state.r[b];
        placed.bodies[b].p = state.p[b];
    }
    return placed;
}

std::string failure_text(const SimulationFailure& failure, const SimulationSettings& settings) {
    const std::string where = "the simulation ends at t = " + number_text(failure.t, 6) + " s: ";
    switch (failure.cause) {
        case SimulationFailure::Cause::contradiction:
            return where + "equations of " + in_quotes(failure.equation_of) +
                   " repeat those of other joints, but miss them by " + number_text(failure.violation, 2) +
                   " of the scene's size; " + what_contradicts(failure.violation) + "; " + look_at(failure.t);
        case SimulationFailure::Cause::out_of_reach:
            return where + "equations of " + in_quotes(failure.equation_of) +
                   " cannot be met there (off by " + number_text(failure.violation, 2) +
                   " of the scene's size): a reach ends, a driver leads where the mechanism cannot follow, "
                   "or it "
                   "is locked; " +
                   look_at(failure.t);
        case SimulationFailure::Cause::not_proven:
            return where + "accelerations do not satisfy " +
                   (failure.equation_of.empty()
                        ? std::string("M q̈ - Q = Φqᵀλ")
                        : "the acceleration equations of " + in_quotes(failure.equation_of)) +
                   " (off by " + number_text(failure.violation, 2) +
                   " of their size): the pose may be singular, or masses too far apart; with '--coordinates "
                   "bodies' they are worked out in another way; " +
                   look_at(failure.t);
        case SimulationFailure::Cause::not_finite:
            return where +
                   "the numbers grew beyond all bounds; a smaller step or an adaptive method (explicit-8) "
                   "helps, for stiff springs implicit-5";
        case SimulationFailure::Cause::too_many_steps:
            return where + std::to_string(settings.most_steps) +
                   " steps were not enough; a stiff scene (springs or dampers that settle in no time) needs "
                   "implicit-5, one that moves fast a larger tolerance or step, a singular position another "
                   "start";
        case SimulationFailure::Cause::step_too_small: break;
    }
    if (entry_of(settings.method).kind == MethodKind::radau) {
        return where +
               "no step is small enough for the tolerance; the position may be singular (a change point, a "
               "reach at its end), which implicit methods pass with loose tolerances only; a tolerance from "
               "1e-8 on, or explicit-8, helps";
    }
    return where +
           "no step is small enough for the tolerance; accelerations grow beyond all bounds there (forces "
           "that are very large beside masses, a singular position); " +
           look_at(failure.t);
}

DynamicsTable simulate(const Lesson& lesson, const DynamicsRequest& request) {
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, request.settings);
    DynamicsTable table;
    table.columns = columns_of(lesson);
    const std::size_t kinetic = table.columns.size() - 5;
    table.outcome = simulation.run(
        equal_times(request.duration, request.samples), [&](double t, const std::vector<double>& y) {
            const Snapshot now = simulation.snapshot(t, y);
            if (t == 0.0) { table.start_note = start_note(lesson.mechanism, now); }
            std::vector<double> row = row_of(now, lesson.mechanism);
            if (request.reactions) {
                const Reactions found = reactions_from_body_frames(
                    simulation.scene(), t, now.state, now.velocity, simulation.acceleration(t, y));
                add_reactions(found, lesson.mechanism, table, row);
            }
            table.rows.push_back(std::move(row));
        });
    table.summary = summary_of(table, kinetic);
    table.fit_note = fit_note(table, kinetic);
    if (table.outcome.failure) { table.failure = failure_text(*table.outcome.failure, request.settings); }
    return table;
}

}  // namespace jw
