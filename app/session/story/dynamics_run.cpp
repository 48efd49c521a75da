#include "app/session/story/dynamics_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/story/dynamics_rows.hpp"
#include "app/session/story/story.hpp"
#include "app/session/story/taking_part.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/equations/assembler.hpp"
#include "core/motion/reactions.hpp"
#include "core/motion/start_velocities.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

void add_columns(std::vector<std::string>& columns, const std::string& prefix) {
    for (const char* axis : {"x", "y", "z"}) { columns.push_back(prefix + axis); }
}

void add_reactions(
    const Reactions& found, const Mechanism& mechanism, DynamicsTable& table, std::vector<double>& row) {
    const bool first = table.rows.empty();
    std::vector<std::string> mark_columns;
    std::vector<double> marks;  // 1: the same in every solution
    for (const Reaction& reaction : found.reactions) {
        const std::string name = name_of(reaction, mechanism);
        if (first) {
            add_columns(table.columns, name + ".force.");
            add_columns(table.columns, name + ".torque.");
            add_columns(mark_columns, name + ".force.unique.");
            add_columns(mark_columns, name + ".torque.unique.");
        }
        row.insert(row.end(), reaction.wrench.force.begin(), reaction.wrench.force.end());
        row.insert(row.end(), reaction.wrench.torque.begin(), reaction.wrench.torque.end());
        marks.insert(marks.end(), reaction.force_unique_global.begin(), reaction.force_unique_global.end());
        marks.insert(marks.end(), reaction.torque_unique_global.begin(), reaction.torque_unique_global.end());
        const bool known = std::ranges::find(table.not_unique, name) != table.not_unique.end();
        if (!reaction.unique() && !known) { table.not_unique.push_back(name); }
    }
    // the marks come after all numbers, so that the columns of the numbers do not move
    table.columns.insert(table.columns.end(), mark_columns.begin(), mark_columns.end());
    row.insert(row.end(), marks.begin(), marks.end());
}

/// Adds the residual of the equilibrium of every body under these reactions.
void add_residual(const Reactions& found, double t, DynamicsTable& table) {
    if (!table.reaction_residual || found.residual > *table.reaction_residual) {
        table.reaction_residual = found.residual;
        table.reaction_bound = found.bound;
    }
    if (found.holds() || !table.reaction_note.empty()) { return; }
    table.reaction_note =
        tr("at t = {0} s the reactions do not balance {1} of the forces on the bodies; rounding explains "
           "only {2}",
           number_text(t, 6), small_text(found.residual), small_text(found.bound));
}

std::string summary_of(const DynamicsTable& table) {
    const std::size_t kinetic = table.column_of("energy.kinetic");
    const std::size_t potential = table.column_of("energy.potential");
    const std::size_t violation = table.column_of("position_violation");
    const IntegrationCounts& c = table.outcome.counts;
    std::string text =
        tr("{0} steps, {1} rejected, {2} evaluations, {3} projections", c.steps, c.rejected, c.evaluations,
           c.projections);
    if (c.singular_passages > 0) {
        text = tr("{0}, {1} steps near a singular position", text, c.singular_passages);
    }
    if (c.row_choices > 0) { text = tr("{0}, rows chosen again {1} times", text, c.row_choices); }
    if (table.outcome.bodies_from) { text = tr("{0}; {1}", text, bodies_note(*table.outcome.bodies_from)); }
    double position = 0.0;
    double energy = 0.0;
    for (const std::vector<double>& row : table.rows) {
        const auto sum = [&](const std::vector<double>& r) { return r[kinetic] + r[potential]; };
        energy = std::max(energy, std::abs(sum(row) - sum(table.rows.front())));
        position = std::max(position, row[violation]);
    }
    return tr(
        "{0}; energy changed by up to {1} J, constraints off by up to {2}, accelerations proved to {3}", text,
        number_text(energy, 3), number_text(position, 2),
        small_text(std::max(table.outcome.residual.forces, table.outcome.residual.constraints)));
}

/// Note on a loop whose branches may not cross, because typed numbers do not fit exactly; else empty.
std::string fit_note(const DynamicsTable& table) {
    constexpr double twelve_digits = 3e-12;
    if (table.outcome.counts.singular_passages == 0 || table.rows.empty()) { return {}; }
    const double left_open = table.rows.front()[table.column_of("position_violation")];
    if (left_open < twelve_digits) { return {}; }
    return tr(
        "redundant equations are violated by {0} at the start. Branches that should cross near a singular "
        "position then stay apart, and the motion may continue on the folded branch; use numbers with 12 or "
        "more digits",
        small_text(left_open));
}

/// Note on bodies whose start poses are moved, the largest moves first; empty if there are none.
std::string pose_note(const Mechanism& given, const Snapshot& start) {
    constexpr double typed = 1e-6;  // what seven digits of a computed pose leave open
    constexpr std::size_t most_named = 4;
    const double length = extent(given);
    std::vector<std::pair<double, std::string>> moved;
    for (std::size_t b = 0; b < given.bodies.size(); ++b) {
        const Body& body = given.bodies[b];
        const double way = (start.state.r[b] - body.r).norm();
        const double turn = turn_local_between(body.p.normalized(), start.state.p[b]).norm();
        const double by = std::max(way / length, turn);
        if (!(by > typed)) { continue; }
        std::vector<std::string> parts;
        if (way > typed * length) { parts.push_back(number_text(way, 3) + " m"); }
        if (turn > typed) { parts.push_back(number_text(turn * kDegreesPerRadian, 3) + "°"); }
        moved.emplace_back(by, tr("body {0} begins {1}", in_quotes(body.name), listed(parts)));
    }
    if (moved.empty()) { return {}; }
    std::ranges::stable_sort(moved, std::greater{}, &std::pair<double, std::string>::first);
    std::vector<std::string> texts;
    for (const auto& [by, text] : moved) {
        if (texts.size() < most_named) { texts.push_back(text); }
    }
    const std::size_t more = moved.size() - texts.size();
    const std::string text =
        tr("the start poses do not fit the joints; the nearest ones that do are used: {0} from where the "
           "file has it",
           listed(texts));
    return more > 0 ? tr("{0} (and {1} more, by less)", text, more) : text;
}

/// A start velocity that is not the given one.
struct ChangedSpeed {
    double by = 0.0;  ///< [extents per second, rad/s]
    std::string text;
};

/// The start velocity of a body that was changed most; velocities that the author did not give do not count.
ChangedSpeed most_changed_body(const Mechanism& given, const Snapshot& start) {
    constexpr double typed = 1e-4;  // what four digits leave open is not reported
    const double length = extent(given);
    double most = typed * fastest_given_velocity(given);
    std::string text;
    const auto compare = [&](const Body& body, const Vec3& wanted, const Vec3& found, double size,
                             const std::string& unit) {
        const double off = (found - wanted).norm();
        if (wanted.norm() == 0.0 || !(off / size > most)) { return; }
        most = off / size;
        text =
            tr("body {0} was given {1} and begins with {2}, {3} off", in_quotes(body.name),
               number_text(wanted.norm(), 4) + unit, number_text(found.norm(), 4) + unit,
               number_text(off, 2) + unit);
    };
    for (std::size_t b = 0; b < given.bodies.size(); ++b) {
        const Body& body = given.bodies[b];
        compare(body, body.omega_local, start.velocity.omega_local[b], 1.0, " rad/s");
        compare(body, body.r_dot, start.velocity.r_dot[b], length, " m/s");
    }
    return {text.empty() ? 0.0 : most, text};
}

/// The start rate of a joint that was changed most.
ChangedSpeed most_changed_rate(const Mechanism& given, const Snapshot& start) {
    const double length = extent(given);
    const double fastest = fastest_given_velocity(given);
    ChangedSpeed most;
    const auto compare = [&](const Joint& joint, const Measure& measure, double wanted, double size,
                             const std::string& unit) {
        const double found =
            evaluate_measure(
                measure, joint.body_i, joint.body_j, -1, start.state, start.velocity, zero_motion(given))
                .rate;
        const double off = std::abs(found - wanted);
        if (keeps_rate(off / size, wanted / size, fastest) || off / size <= most.by) { return; }
        most.by = off / size;
        most.text =
            tr("joint {0} was given {1} and begins with {2}, {3} off", in_quotes(joint.name),
               number_text(wanted, 4) + unit, number_text(found, 4) + unit, number_text(off, 2) + unit);
    };
    for (const Joint& joint : given.joints) {
        const JointGeometry& g = joint.geometry;
        if (g.angle_dot_start) { compare(joint, angle_of(joint), *g.angle_dot_start, 1.0, " rad/s"); }
        if (g.displacement_dot_start) {
            compare(joint, displacement_of(joint), *g.displacement_dot_start, length, " m/s");
        }
    }
    return most;
}

/// Note about the body or joint whose start velocity was changed most.
std::string speed_note(const Mechanism& given, const Snapshot& start) {
    const ChangedSpeed of_body = most_changed_body(given, start);
    const ChangedSpeed of_joint = most_changed_rate(given, start);
    const std::string& text = of_joint.by > of_body.by ? of_joint.text : of_body.text;
    if (text.empty()) { return {}; }
    if (!of_joint.text.empty() && given.moving_bodies_count() > kMostBodiesWithRates) {
        return tr(
            "start rates of joints are kept in mechanisms of up to {0} moving bodies; give the velocities of "
            "the bodies: {1}",
            kMostBodiesWithRates, text);
    }
    return tr("the start velocities do not fit the joints; the nearest ones that do are used: {0}", text);
}

/// Watches a run. Reports once, with advice, if the run will take long. Stops the run if stability makes it
/// very slow and nobody chose its method.
class Pace {
public:
    Pace(const DynamicsRequest& request, std::string& note) : request_(&request), note_(&note) {}

    bool gave_way() const { return gave_way_; }

    bool look(const RunState& run) {
        if (request_->progress) { request_->progress(run.t / run.end); }
        // the pace over the last looks counts, since a run may begin slowly
        if (run.steps % (kLooks * kStepsBetweenLooks) != 0) { return true; }
        const double way = run.t - t_before_;
        t_before_ = run.t;
        if (!(way > 0.0)) { return true; }
        const double needed = static_cast<double>(run.steps) +
                              (run.end - run.t) * static_cast<double>(kLooks * kStepsBetweenLooks) / way;
        const bool stiff = run.bound_by_stability > kMostly;
        if (stiff && needed > kCrawls && !request_->method_chosen) {
            gave_way_ = true;
            return false;
        }
        if (said_ || !(needed > (stiff ? kCrawls : static_cast<double>(request_->settings.most_steps)))) {
            return true;
        }
        said_ = true;
        say(run, needed, stiff);
        return true;
    }

private:
    static constexpr long kLooks = 10;
    static constexpr double kMostly = 0.5;
    static constexpr double kCrawls = 5e4;  // a step of an implicit method costs some tens of times as much

    void say(const RunState& run, double needed, bool stiff) {
        const std::string method(entry_of(request_->settings.method).name);
        std::string text =
            tr("{2} has taken {3} steps to t = {0} s of {1} s; at this pace it will need {4} in all",
               number_text(run.t, 3), number_text(run.end, 3), method, run.steps, number_text(needed, 2));
        if (static_cast<double>(request_->settings.most_steps) < needed) {
            text = tr("{0}; it stops after {1}", text, request_->settings.most_steps);
        }
        if (stiff) {
            text =
                tr("{0}; stability, not accuracy, limits the step size: --method implicit-5 takes longer "
                   "steps",
                   text);
        }
        *note_ = text;
        if (request_->tell) { request_->tell(text); }
    }

    const DynamicsRequest* request_;
    std::string* note_;
    double t_before_ = 0.0;
    bool said_ = false;
    bool gave_way_ = false;
};

}  // namespace

DynamicsRequest request_of(const Lesson& lesson) {
    if (!lesson.dynamics) { throw std::invalid_argument("the lesson has no [dynamics]"); }
    const DynamicsPlan& plan = *lesson.dynamics;
    DynamicsRequest request;
    request.settings = plan.settings;
    request.duration = plan.duration;
    request.method_chosen = plan.method_given;
    return request;
}

std::vector<double> equal_times(double duration, int intervals) {
    std::vector<double> times;
    for (int k = 0; k <= intervals; ++k) { times.push_back(duration * k / intervals); }
    return times;
}

std::string start_note(const Mechanism& given, const Snapshot& start) {
    const std::string pose = pose_note(given, start);
    return pose.empty() ? speed_note(given, start) : pose;
}

std::string bodies_note(double t) {
    return tr(
        "from t = {0} s on, coordinates of the bodies are used, since those of the joints lose digits there",
        number_text(t, 6));
}

std::size_t DynamicsTable::column_of(std::string_view name) const {
    const auto found = std::ranges::find(columns, name);
    if (found == columns.end()) { throw std::invalid_argument("no column " + std::string(name)); }
    return static_cast<std::size_t>(found - columns.begin());
}

Mechanism placed_at(const Mechanism& mechanism, const State& state) {
    Mechanism placed = mechanism;
    for (std::size_t b = 0; b < placed.bodies.size(); ++b) {
        placed.bodies[b].r = state.r[b];
        placed.bodies[b].p = state.p[b];
    }
    return placed;
}

namespace {

/// One run by the method of `request`. @return true if it was stopped in favour of an implicit one
bool run_once(const Lesson& lesson, const DynamicsRequest& request, DynamicsTable& table) {
    if (request.duration > lesson.dynamics->duration) { require_formulas(lesson, 0.0, request.duration); }
    Simulation simulation(taking_part(lesson), lesson.dynamics->loads, request.settings);
    DynamicsRows rows(lesson, request.quantities, simulation);
    table.columns = rows.columns();
    table.rows.clear();
    table.not_unique.clear();
    table.reaction_residual.reset();
    table.reaction_note.clear();
    const bool noted = !table.start_note.empty();
    Pace pace(request, table.pace_note);
    const auto receive = [&](double t, const std::vector<double>& y) {
        const Snapshot now = simulation.snapshot(t, y);
        if (t == 0.0) {
            table.start_note = start_note(lesson.mechanism, now);
            if (!noted && !table.start_note.empty() && request.tell) { request.tell(table.start_note); }
        }
        std::vector<double> row = rows.row(now, y);
        if (request.reactions) {
            const Reactions found = reactions_from_body_frames(
                simulation.scene(), t, now.state, now.velocity, simulation.acceleration(t, y));
            add_reactions(found, lesson.mechanism, table, row);
            add_residual(found, t, table);
        }
        table.rows.push_back(std::move(row));
    };
    table.outcome = simulation.run(
        equal_times(request.duration, request.samples), receive,
        [&](const RunState& run) { return pace.look(run); });
    return pace.gave_way();
}

}  // namespace

DynamicsTable simulate(const Lesson& lesson, const DynamicsRequest& request) {
    DynamicsTable table;
    DynamicsRequest used = request;
    if (run_once(lesson, used, table)) {
        const std::string method(entry_of(used.settings.method).name);
        used.settings.method = Method::implicit_5;
        used.settings.dense.reset();
        used.method_chosen = true;
        const long steps = table.outcome.counts.steps;
        table.pace_note =
            tr("the scene is stiff: stability, not accuracy, limits the steps of {0} ({1} of them to t = {2} "
               "s); implicit-5 is used instead, --method {0} keeps {0}",
               method, steps, number_text(table.outcome.failure->t, 3));
        if (request.tell) { request.tell(table.pace_note); }
        run_once(lesson, used, table);
    }
    table.summary = summary_of(table);
    table.fit_note = fit_note(table);
    if (table.outcome.failure) {
        table.failure = failure_text(*table.outcome.failure, used.settings, lesson);
    }
    return table;
}

}  // namespace jw
