#include "app/session/story/sentences.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

// rounding of a pose whose joints were given by one global point and axis
constexpr double kMet = 1e-12;
constexpr const char* kAllBefore = "the equations before";

const Joint& joint_at(const Mechanism& mechanism, int index) {
    return mechanism.joints[static_cast<std::size_t>(index)];
}

const std::string& body_name(const Mechanism& mechanism, int index) {
    return mechanism.bodies[static_cast<std::size_t>(index)].name;
}

/// "Joint D" or "Driver crank drive"
std::string subject_name(const Lesson& lesson, const Addition& subject) {
    const auto k = static_cast<std::size_t>(subject.index);
    return subject.kind == Addition::Kind::joint ? "Joint " + lesson.mechanism.joints[k].name
                                                 : "Driver " + lesson.mechanism.drivers[k].name;
}

/// "a, b and c"
std::string number_word(int n) {
    constexpr std::array words{"no", "one", "two", "three", "four", "five", "six"};
    return n >= 0 && n < 7 ? words[static_cast<std::size_t>(n)] : std::to_string(n);
}

/// "s 3, p1 2 of 3"
std::string counts_by_primitive(const System& system, int joint) {
    std::string text;
    for (const Constraint& c : system.constraints()) {
        if (c.joint != joint) { continue; }
        const int kept = c.rows();
        text += (text.empty() ? "" : ", ") + std::to_string(kept);
        if (kept < c.equations) { text += " of " + std::to_string(c.equations); }
        text += " from " + name_of_role(c.role, joint_at(system.mechanism(), joint).parallel_form);
    }
    return text;
}

/// Rows of the joint or driver.
std::vector<int> rows_of(const System& system, const Addition& subject) {
    std::vector<int> rows;
    for (int row = 0; row < system.rows(); ++row) {
        const RowOrigin origin = system.origin(row);
        const auto k = static_cast<std::size_t>(origin.index);
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
    if (moving == 0) { return "No body can move: there are no coordinates."; }
    std::vector<std::string> names;
    for (const int b : step.system->moving_bodies()) {
        if (names.size() < 8) { names.push_back(body_name(m, b)); }
    }
    if (moving > static_cast<int>(names.size())) {
        names.push_back(std::to_string(moving - static_cast<int>(names.size())) + " more");
    }
    return count_text(moving, "body is free", "bodies are free") + ": " + listed(names) + ". That is " +
           std::to_string(7 * moving) + " coordinates (r, p) with " +
           count_text(moving, "equation", "equations") + " pᵀp = 1 among them, so " +
           std::to_string(6 * moving) + " freedoms; as velocities, " + std::to_string(6 * moving) +
           " columns (r, ω′).";
}

std::string equations_sentence(const Lesson& lesson, const Step& step, const Addition& subject) {
    const System& system = *step.system;
    const std::vector<int> rows = rows_of(system, subject);
    if (rows.empty()) {
        return subject_name(lesson, subject) + " brings no equation: all of them are taken out. " +
               count_text(system.rows(), "equation") + " in all.";
    }
    std::string text =
        subject_name(lesson, subject) + " brings " + count_text(static_cast<int>(rows.size()), "equation");
    if (subject.kind == Addition::Kind::joint) {
        text += " (" + counts_by_primitive(system, subject.index) + ")";
        if (joint_at(lesson.mechanism, subject.index).type->artificial > 0) {
            text += " and an artificial coordinate θ";
        }
    }
    text += ", " + std::to_string(system.rows()) + " in all. At the start estimate ";

    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(step.state, step.t);
    const auto size = [&](int row) { return std::abs(assembler.phi()(row)); };
    const int largest = *std::ranges::max_element(rows, {}, size);
    if (size(largest) < kMet) { return text + "they hold already."; }
    return text + "the largest is " + row_label(system, largest) + " = " +
           number_text(assembler.phi()(largest), 3) + ".";
}

std::string newton_sentence(const System& system, const NewtonStep& newton) {
    std::string text = "Iteration " + std::to_string(newton.iteration) +
                       " found ‖Φ‖ = " + small_text(newton.phi_norm) + ", the largest equation " +
                       row_label(system, newton.largest_row) + " = " + small_text(newton.largest_value) +
                       ". Its step Φq Δq = −Φ, already taken in the picture, has length " +
                       small_text(newton.delta_norm);
    if (newton.turn > 0.0) {
        text += " and turns no body by more than " +
                number_text(newton.fraction * newton.turn * kDegreesPerRadian, 3) + "°";
    }
    if (newton.fraction < 1.0) {
        text += " (limited: " + number_text(100.0 * newton.fraction, 2) + " % of the full step)";
    }
    return text + ".";
}

std::string iteration_sentence(const Step& step) {
    return std::visit(
        Overloaded{
            [&](const NewtonStep& newton) { return newton_sentence(*step.system, newton); },
            [&](const WrongBranch& wrong) {
                return "All equations hold, but on the wrong branch: " + branch_text(*step.system, wrong) +
                       ". In the picture that is already turned by half a turn; Newton-Raphson starts again "
                       "from there.";
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
    if (iterations == 0) { return "Everything holds already: no iteration was needed."; }
    return count_text(iterations, "Newton iteration") + " closed it; the largest |Φ| left is " +
           small_text(residual) + ".";
}

/// Owners of the equations that a redundant row repeats, in the order of addition.
std::string repeated_owners(const System& system, const std::vector<RedundantRow>& redundant) {
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
    return owners.size() > 6 ? kAllBefore : listed(owners);
}

std::string freedoms_text(int dof) {
    if (dof == 0) { return "No freedom is left: the pose is determined."; }
    return count_text(dof, "freedom is left", "freedoms are left") + ".";
}

/// "three repeat what A, B and C already say"
std::string repetition_text(const System& system, const RankReport& rank, int repeating) {
    const bool one = repeating == 1;
    const bool empty =
        std::ranges::all_of(rank.redundant_rows, [](const RedundantRow& r) { return r.terms.empty(); });
    if (empty) { return number_word(repeating) + (one ? " says" : " say") + " nothing here"; }
    const std::string owners = repeated_owners(system, rank.redundant_rows);
    const std::string repeat = number_word(repeating) + (one ? " repeats" : " repeat");
    if (owners.empty()) { return repeat + " the others of the same joint"; }
    const bool several = owners.find(" and ") != std::string::npos || owners == kAllBefore;
    return repeat + " what " + owners + " already " + (several ? "say" : "says");
}

std::string assembled_sentence(
    const Lesson& lesson, const Step& step, const Addition& subject, const RankReport& rank) {
    const int before = step.rank_before ? step.rank_before->rank : 0;
    const int redundant_before = step.rank_before ? step.rank_before->redundant() : 0;
    const auto count = static_cast<int>(rows_of(*step.system, subject).size());
    const int repeating = rank.redundant() - redundant_before;
    std::string text = subject_name(lesson, subject) + " adds " + count_text(count, "equation") +
                       ", the rank grows by " + std::to_string(rank.rank - before) + " (" +
                       std::to_string(before) + " → " + std::to_string(rank.rank) + ")";
    if (repeating > 0) { text += ": " + repetition_text(*step.system, rank, repeating); }
    text += ". " + freedoms_text(rank.dof) + " " + closing_text(step);
    return rank.decided ? text : text + " " + undecided_text(rank);
}

/// Describes the reactions that the arrows in the picture stand for.
std::string reactions_text(const Mechanism& m, const Reactions& found) {
    const Reaction* largest = nullptr;
    for (const Reaction& r : found.reactions) {
        if (largest == nullptr || r.wrench.force.norm() > largest->wrench.force.norm()) { largest = &r; }
    }
    if (largest == nullptr) { return ""; }
    const std::string name = largest->joint >= 0 ? m.joints[static_cast<std::size_t>(largest->joint)].name
                                                 : m.drivers[static_cast<std::size_t>(largest->driver)].name;
    std::string text =
        " The arrows show what joints do to their second bodies: forces, and with two heads torques; the "
        "largest force is " +
        number_text(largest->wrench.force.norm(), 3) + " N, in " + name + ".";
    if (!found.unique()) {
        text += " Pale ones are one answer of many: equations that repeat each other leave them open.";
    }
    return text;
}

std::string motion_sentence(const Lesson& lesson, const Step& step, const RankReport& rank) {
    std::string text = "t = " + fixed_text(step.t, 3) + " s: ";
    const Mechanism& m = lesson.mechanism;
    if (step.change_point) {
        text +=
            "a change point, or very near one. Of " + count_text(rank.columns, "column") + " " +
            std::to_string(rank.rank) + " are independent here, the last of them with a singular value of " +
            number_text(rank.last_value(), 2) + ". The motion goes on along the tangent on which it came.";
        return text;
    }
    text += "rank " + std::to_string(rank.rank) + " of " + std::to_string(rank.columns) + " columns";
    if (rank.dof == 0) {
        text += ", so positions, velocities and accelerations are determined";
    } else if (lesson.dynamics && !lesson.motion) {
        text += "; masses and forces decide about " + count_text(rank.dof, "freedom");
    } else if (m.drivers.empty()) {
        text += "; nothing is driven, so nothing moves";
    } else {
        text += "; " + count_text(rank.dof, "freedom") + " not driven: the velocities shown are the ones " +
                "nearest to those before, the accelerations the shortest";
    }
    text += ".";
    if (!rank.decided) { text += " " + undecided_text(rank); }
    if (const auto reactions = reactions_of(step)) { text += reactions_text(m, *reactions); }
    if (step.rows_switched) { text += " On the way here another choice of p1 and p2 equations was made."; }
    if (!step.note.empty()) { text += " Note: " + step.note + "."; }
    return text;
}

}  // namespace

std::string title_of(const Lesson& lesson, const Step& step) {
    if (step.kind == Step::Kind::bodies) { return "The free bodies"; }
    if (step.kind == Step::Kind::question) { return "A question"; }
    if (step.kind == Step::Kind::answer) { return "The answer"; }
    if (step.kind == Step::Kind::motion) { return step.failed() ? "The motion ends" : "The motion"; }
    const std::optional<Addition> subject = subject_of(lesson, step);
    const Mechanism& m = lesson.mechanism;
    std::string title = subject_name(lesson, *subject);
    if (subject->kind == Addition::Kind::joint) {
        const Joint& joint = joint_at(m, subject->index);
        title += " · " + std::string(joint.type->name) + " · " + body_name(m, joint.body_i) + " – " +
                 body_name(m, joint.body_j);
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
        case Step::Kind::failed:
            return subject_name(lesson, *subject) + " cannot be closed. The last good pose is kept.";
        case Step::Kind::question: return "Predict, then see.";
        case Step::Kind::answer: return "This is what came out.";
        case Step::Kind::motion: break;
    }
    if (step.failed()) {
        return "The motion cannot be followed beyond t = " + number_text(step.t) +
               " s. This is the last good pose.";
    }
    return motion_sentence(lesson, step, rank);
}

std::string once_assembled_text(int here, int once) {
    const std::string ranks =
        "Rank " + std::to_string(here) + " here, " + std::to_string(once) + " once assembled";
    if (once > here) { return ranks + ": some rows are independent only at the solution."; }
    const int fewer = here - once;
    return ranks + ": " + number_word(fewer) + (fewer == 1 ? " row repeats" : " rows repeat") +
           " others at the solution only.";
}

std::string failure_text(const Step& step) {
    if (step.failure) { return failure_text(*step.system, *step.failure); }
    std::string text = step.ended;
    if (!text.empty()) { text.front() = static_cast<char>(std::toupper(text.front())); }
    return text;
}

}  // namespace jw
