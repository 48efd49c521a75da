#include "app/session/story/sentences.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

// rounding of a pose whose joints were given by one global point and axis
constexpr double kMet = 1e-12;
constexpr std::size_t kMostOwners = 6;  // named one by one

/// Name of a subject: "Joint D" or "Driver crank drive"
std::string subject_name(const Lesson& lesson, const Addition& subject) {
    const auto k = at(subject.index);
    return subject.kind == Addition::Kind::joint ? tr("Joint {0}", lesson.mechanism.joints[k].name)
                                                 : tr("Driver {0}", lesson.mechanism.drivers[k].name);
}

std::string number_word(int n) {
    constexpr std::array words{tr_later("one"),  tr_later("two"),  tr_later("three"),
                               tr_later("four"), tr_later("five"), tr_later("six")};
    return n >= 1 && n <= 6 ? tr(words[at(n - 1)]) : std::to_string(n);
}

/// Numbers of equations by primitive: "3 from s, 2 of 3 from p1"
std::string counts_by_primitive(const System& system, int joint) {
    std::string text;
    for (const Constraint& c : system.constraints()) {
        if (c.joint != joint) { continue; }
        const int kept = c.rows();
        const std::string role = name_of_role(c.role, system.mechanism().joints[at(joint)].parallel_form);
        const std::string part = kept < c.equations ? tr("{0} of {1} from {2}", kept, c.equations, role)
                                                    : tr("{0} from {1}", kept, role);
        text = text.empty() ? part : tr("{0}, {1}", text, part);
    }
    return text;
}

std::string equations_count(int count) { return tr_count(count, "{0} equation", "{0} equations"); }

/// Rows of the joint or driver.
std::vector<int> rows_of(const System& system, const Addition& subject) {
    std::vector<int> rows;
    for (int row = 0; row < system.rows(); ++row) {
        const RowOrigin origin = system.origin(row);
        const auto k = at(origin.index);
        const bool own = origin.kind == RowOrigin::Kind::driver
                             ? subject == Addition{Addition::Kind::driver, system.drivers()[k].driver}
                             : subject == Addition{Addition::Kind::joint, system.constraints()[k].joint};
        if (own) { rows.push_back(row); }
    }
    return rows;
}

std::string bodies_sentence(const Lesson& lesson, const Step& step) {
    const Mechanism& m = lesson.mechanism;
    const int moving = m.moving_bodies_count();
    if (moving == 0) { return tr("No body can move: there are no coordinates."); }
    std::vector<std::string> names;
    for (const int b : step.system->moving_bodies()) {
        if (names.size() < 8) { names.push_back(m.bodies[at(b)].name); }
    }
    if (moving > static_cast<int>(names.size())) {
        names.push_back(tr("{0} more", moving - static_cast<int>(names.size())));
    }
    return tr_count(
        moving,
        "{0} body is free: {1}. Its pose has {2} coordinates (r, p) and {0} equation pᵀp = 1, so {3} "
        "freedoms; its velocity has {3} columns (r, ω′).",
        "{0} bodies are free: {1}. Their poses have {2} coordinates (r, p) and {0} equations pᵀp = 1, so {3} "
        "freedoms; their velocities have {3} columns (r, ω′).",
        listed(names), 7 * moving, 6 * moving);
}

std::string equations_sentence(const Lesson& lesson, const Step& step, const Addition& subject) {
    const System& system = *step.system;
    const std::vector<int> rows = rows_of(system, subject);
    if (rows.empty()) {
        return tr_count(
            system.rows(), "{1} brings no equation: all of them are taken out. {0} equation in all.",
            "{1} brings no equation: all of them are taken out. {0} equations in all.",
            subject_name(lesson, subject));
    }
    std::string brought = equations_count(static_cast<int>(rows.size()));
    if (subject.kind == Addition::Kind::joint) {
        brought = tr("{0} ({1})", brought, counts_by_primitive(system, subject.index));
        if (lesson.mechanism.joints[at(subject.index)].type->artificial > 0) {
            brought = tr("{0} and an artificial coordinate θ", brought);
        }
    }
    const std::string text =
        tr("{0} brings {1}, {2} in all.", subject_name(lesson, subject), brought, system.rows());

    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(step.state, step.t);
    const auto size = [&](int row) { return std::abs(assembler.phi()(row)); };
    const int largest = *std::ranges::max_element(rows, {}, size);
    if (size(largest) < kMet) { return followed(text, tr("The start estimate satisfies them already.")); }
    return followed(
        text, tr("At the start estimate the largest residual is {0} = {1}.", row_label(system, largest),
                 number_text(assembler.phi()(largest), 3)));
}

std::string newton_sentence(const System& system, const NewtonStep& newton) {
    std::string step =
        newton.turn > 0.0
            ? tr("has length {0} and turns no body by more than {1}°", small_text(newton.delta_norm),
                 number_text(newton.fraction * newton.turn * kDegreesPerRadian, 3))
            : tr("has length {0}", small_text(newton.delta_norm));
    if (newton.fraction < 1.0) {
        step = tr("{0} (limited: {1} % of the full step)", step, number_text(100.0 * newton.fraction, 2));
    }
    return tr(
        "Iteration {0} found ‖Φ‖ = {1}, the largest residual {2} = {3}. Its step Φq Δq = −Φ, already taken "
        "in the picture, {4}.",
        newton.iteration, small_text(newton.phi_norm), row_label(system, newton.largest_row),
        small_text(newton.largest_value), step);
}

std::string iteration_sentence(const Step& step) {
    return std::visit(
        Overloaded{
            [&](const NewtonStep& newton) { return newton_sentence(*step.system, newton); },
            [&](const WrongBranch& wrong) {
                return tr(
                    "All equations hold, but on the wrong branch: {0}. The picture shows it already turned "
                    "by half a turn; Newton-Raphson starts again from there.",
                    branch_text(*step.system, wrong));
            },
        },
        step.events.back());
}

std::string closing_text(const Step& step) {
    int iterations = 0;
    double residual = 0.0;
    for (const PositionEvent& event : step.events) {
        if (const auto* newton = std::get_if<NewtonStep>(&event)) {
            iterations += newton->converged ? 0 : 1;
            residual = newton->residual;
        }
    }
    if (iterations == 0) { return tr("All equations hold already: no iteration was needed."); }
    return tr_count(
        iterations, "{0} Newton iteration closed it; the largest |Φ| left is {1}.",
        "{0} Newton iterations closed it; the largest |Φ| left is {1}.", small_text(residual));
}

/// Owners of the equations that imply a redundant row, in the order of addition.
std::vector<std::string> implying_owners(const System& system, const std::vector<RedundantRow>& redundant) {
    std::vector<std::string> owners;
    for (const RedundantRow& r : redundant) {
        const std::string self = row_owner(system, r.row);
        for (const RedundantRow::Term& term : r.terms) {
            const std::string owner = row_owner(system, term.row);
            if (owner != self && std::ranges::find(owners, owner) == owners.end()) {
                owners.push_back(owner);
            }
        }
    }
    return owners;
}

std::string freedoms_text(int dof) {
    if (dof == 0) { return tr("No freedom is left: the pose is determined."); }
    return tr_count(dof, "{0} freedom is left.", "{0} freedoms are left.");
}

/// "three are redundant, implied by A, B and C"
std::string redundancy_text(const System& system, const RankReport& rank, int added) {
    const std::string number = number_word(added);
    const bool empty =
        std::ranges::all_of(rank.redundant_rows, [](const RedundantRow& r) { return r.terms.empty(); });
    if (empty) { return tr_count(added, "{1} has a zero row here", "{1} have zero rows here", number); }
    const std::vector<std::string> owners = implying_owners(system, rank.redundant_rows);
    if (owners.empty()) {
        return tr_count(
            added, "{1} is redundant, implied by the others of the joint",
            "{1} are redundant, implied by the others of the joint", number);
    }
    return tr_count(
        added, "{1} is redundant, implied by {2}", "{1} are redundant, implied by {2}", number,
        owners.size() > kMostOwners ? tr("the equations before") : listed(owners));
}

std::string assembled_sentence(
    const Lesson& lesson, const Step& step, const Addition& subject, const RankReport& rank) {
    const int before = step.rank_before ? step.rank_before->rank : 0;
    const int redundant_before = step.rank_before ? step.rank_before->redundant() : 0;
    const auto count = static_cast<int>(rows_of(*step.system, subject).size());
    const int redundant = rank.redundant() - redundant_before;
    const std::string equations = equations_count(count);
    const std::string name = subject_name(lesson, subject);
    std::string text = redundant > 0 ? tr("{0} adds {1}, the rank grows by {2} ({3} → {4}): {5}.", name,
                                          equations, rank.rank - before, before, rank.rank,
                                          redundancy_text(*step.system, rank, redundant))
                                     : tr("{0} adds {1}, the rank grows by {2} ({3} → {4}).", name, equations,
                                          rank.rank - before, before, rank.rank);
    text = followed(followed(text, freedoms_text(rank.dof)), closing_text(step));
    return followed(text, undecided_text(rank));
}

/// Describes the reactions that the arrows in the picture stand for.
std::string reactions_text(const Mechanism& m, const Reactions& found) {
    const Reaction* largest = nullptr;
    for (const Reaction& r : found.reactions) {
        if (largest == nullptr || r.wrench.force.norm() > largest->wrench.force.norm()) { largest = &r; }
    }
    if (largest == nullptr) { return ""; }
    const std::string text =
        tr("The arrows show the reactions of joints on their second bodies: one head is a force, two heads a "
           "torque. The largest force is {0} N, in {1}.",
           number_text(largest->wrench.force.norm(), 3), name_of(*largest, m));
    if (found.unique()) { return text; }
    return followed(
        text, tr("Pale arrows are one of many solutions: redundant equations leave them undetermined."));
}

/// What determines the motion at a moment.
std::string determined_text(const Lesson& lesson, const RankReport& rank) {
    if (rank.dof == 0) {
        return tr(
            "rank {0} of {1} columns, so positions, velocities and accelerations are determined.", rank.rank,
            rank.columns);
    }
    if (lesson.dynamics && !lesson.motion) {
        return tr_count(
            rank.dof, "rank {1} of {2} columns; masses and forces decide about {0} freedom.",
            "rank {1} of {2} columns; masses and forces decide about {0} freedoms.", rank.rank, rank.columns);
    }
    if (lesson.mechanism.drivers.empty()) {
        return tr("rank {0} of {1} columns; nothing is driven, so nothing moves.", rank.rank, rank.columns);
    }
    return tr_count(
        rank.dof,
        "rank {1} of {2} columns; {0} freedom not driven: the velocities shown are those nearest to the "
        "previous ones, the accelerations have the least norm.",
        "rank {1} of {2} columns; {0} freedoms not driven: the velocities shown are those nearest to the "
        "previous ones, the accelerations have the least norm.",
        rank.rank, rank.columns);
}

/// "a change point ..." with its numbers.
std::string change_point_text(const RankReport& rank) {
    return tr_count(
        rank.columns,
        "a change point, or very near one. Of {0} column, {1} are independent here; their smallest singular "
        "value is {2}. The motion continues along its tangent.",
        "a change point, or very near one. Of {0} columns, {1} are independent here; their smallest singular "
        "value is {2}. The motion continues along its tangent.",
        rank.rank, number_text(rank.last_value(), 2));
}

std::string motion_sentence(const Lesson& lesson, const Step& step, const RankReport& rank) {
    const std::string moment = fixed_text(step.t, 3);
    if (step.change_point) { return tr("t = {0} s: {1}", moment, change_point_text(rank)); }
    std::string text = tr("t = {0} s: {1}", moment, determined_text(lesson, rank));
    text = followed(text, undecided_text(rank));
    if (const auto reactions = reactions_of(step)) {
        text = followed(text, reactions_text(lesson.mechanism, *reactions));
    }
    if (step.rows_switched) {
        text = followed(text, tr("On the way here, another pair of p1 and p2 equations was chosen."));
    }
    if (!step.note.empty()) { text = followed(text, tr("Note: {0}.", step.note)); }
    return text;
}

}  // namespace

std::string title_of(const Lesson& lesson, const Step& step) {
    if (step.kind == Step::Kind::bodies) { return tr("The free bodies"); }
    if (step.kind == Step::Kind::question) { return tr("A question"); }
    if (step.kind == Step::Kind::answer) { return tr("The answer"); }
    if (step.kind == Step::Kind::motion) {
        return tr(step.failed() ? tr_later("The motion ends") : tr_later("The motion"));
    }
    const std::optional<Addition> subject = subject_of(lesson, step);
    const Mechanism& m = lesson.mechanism;
    std::string title = subject_name(lesson, *subject);
    if (subject->kind == Addition::Kind::joint) {
        const Joint& joint = m.joints[at(subject->index)];
        title += " · " + std::string(joint.type->name) + " · " + m.bodies[at(joint.body_i)].name + " – " +
                 m.bodies[at(joint.body_j)].name;
    }
    return title;
}

std::string sentence_of(const Lesson& lesson, const Step& step, const RankReport& rank) {
    const std::optional<Addition> subject = subject_of(lesson, step);
    switch (step.kind) {
        case Step::Kind::bodies: return bodies_sentence(lesson, step);
        case Step::Kind::equations: return equations_sentence(lesson, step, *subject);
        case Step::Kind::iteration: return iteration_sentence(step);
        case Step::Kind::assembled: return assembled_sentence(lesson, step, *subject, rank);
        case Step::Kind::failed: return tr("{0}. The last good pose is kept.", what_failed(lesson, step));
        case Step::Kind::question: return tr("Predict, then see.");
        case Step::Kind::answer: return tr("This is the result.");
        case Step::Kind::motion: break;
    }
    if (step.failed()) { return tr("{0}. This is the last good pose.", what_failed(lesson, step)); }
    return motion_sentence(lesson, step, rank);
}

std::string what_failed(const Lesson& lesson, const Step& step) {
    if (step.kind == Step::Kind::motion) {
        return tr("The motion cannot be followed beyond t = {0} s", number_text(step.t));
    }
    return tr("{0} cannot be closed", subject_name(lesson, *subject_of(lesson, step)));
}

std::string once_assembled_text(int here, int once) {
    if (once > here) {
        return tr(
            "Rank {0} here, {1} once assembled: some rows are independent only at the solution.", here, once);
    }
    const int fewer = here - once;
    return tr_count(
        fewer, "Rank {1} here, {2} once assembled: {3} row is redundant at the solution only.",
        "Rank {1} here, {2} once assembled: {3} rows are redundant at the solution only.", here, once,
        number_word(fewer));
}

std::string failure_text(const Step& step) {
    if (step.failure) { return failure_text(*step.system, *step.failure); }
    std::string text = step.ended;
    if (!text.empty()) {
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    }
    return text;
}

}  // namespace jw
