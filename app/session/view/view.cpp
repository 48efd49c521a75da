#include "app/session/view/view.hpp"

#include <algorithm>
#include <iterator>

#include "app/session/story/sentences.hpp"
#include "app/session/view/quantities.hpp"
#include "app/session/view/view_equations.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/equations/assembler.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

MatrixView matrix_of(
    const Step& step, CoordinateChoice choice, const RankReport& report, int joint, int driver) {
    const System& system = *step.system;
    MatrixView view;
    view.choice = choice;
    with_choice(choice, [&](auto c) {
        Assembler<decltype(c)> assembler(system);
        assembler.assemble_phi_and_jacobian(step.state, step.t);
        view.values = assembler.jacobian();
    });
    for (int row = 0; row < static_cast<int>(view.values.rows()); ++row) {
        const RowOrigin origin = system.origin(row);
        const auto k = at(origin.index);
        MatrixView::Row entry{row_owner(system, row), short_row_label(system, row), false, false};
        if (origin.kind == RowOrigin::Kind::constraint) {
            entry.subject = system.constraints()[k].joint == joint;
        } else if (origin.kind == RowOrigin::Kind::driver) {
            entry.subject = system.drivers()[k].driver == driver;
        }
        view.rows.push_back(std::move(entry));
    }
    for (const RedundantRow& r : report.redundant_rows) { view.rows[at(r.row)].redundant = report.assembled; }
    for (const ColumnName& name : column_names(system, choice)) {
        view.columns.push_back({name.owner, name.symbol});
    }
    return view;
}

/// The rank that the equations of an unassembled step have once they hold, if the story tells that.
std::optional<int> rank_once_assembled(const Story& story, const Step& step, int index) {
    if (step.kind != Step::Kind::equations && step.kind != Step::Kind::iteration) { return std::nullopt; }
    const std::vector<Step>& steps = story.steps();
    for (std::size_t k = static_cast<std::size_t>(index); k < steps.size(); ++k) {
        if (steps[k].additions != step.additions) { break; }
        if (steps[k].kind == Step::Kind::assembled && steps[k].rank) { return steps[k].rank->rank; }
    }
    return std::nullopt;
}

RankView rank_view_of(const Step& step, const RankReport& report) {
    const System& system = *step.system;
    RankView view;
    view.rows = report.rows;
    view.columns = report.columns;
    view.rank = report.rank;
    view.dof = report.dof;
    view.mobility_by_counting = report.mobility_by_counting;
    if (step.rank_before) { view.rank_before = step.rank_before->rank; }
    view.has_spectrum = report.has_spectrum;
    view.singular_values.assign(report.singular_values.begin(), report.singular_values.end());
    view.threshold = report.threshold;
    view.residual = report.residual;
    view.assembled = report.assembled;
    view.near_singular = report.near_singular;
    view.singular_value_error = report.singular_value_error;
    view.decided = report.decided;
    view.doubts = doubts_of(system, report);
    for (const RedundantRow& r : report.redundant_rows) {
        view.redundant_rows.push_back(row_label(system, r.row));
        view.combinations.push_back(combination_text(system, r));
    }
    for (const ListedMotion& motion : listed_motions(system, report.free_motions, {})) {
        view.free_motions.push_back(motion.text);
    }
    // other steps list none, or are moved by hand and change faster than motions can be judged
    const bool is_listed = step.rank && report.assembled &&
                           (step.kind == Step::Kind::assembled || step.kind == Step::Kind::answer);
    if (is_listed && !report.free_motions.empty()) {
        view.judged_motions = MotionsWhenAsked(
            [system = step.system, state = step.state, t = step.t, motions = report.free_motions] {
                return listed_motions(*system, motions, judgements_on(*system, state, t, motions));
            });
    }
    view.typed = report.typed;
    return view;
}

/// The equations of all `joints`, each with the reason why its rows are kept.
std::vector<EquationGroup> equations_of(
    const Story& story, const Step& step, int index, const std::vector<int>& joints,
    const RankReport& report) {
    const System* before = index > 0 ? story.steps()[at(index) - 1].system.get() : nullptr;
    std::vector<EquationGroup> all;
    for (const int joint : joints) {
        std::vector<EquationGroup> groups = equations_of_joint(
            step, joint, choices_of_joint(*step.system, joint, step.state, before),
            report.assembled ? &report : nullptr);
        std::ranges::move(groups, std::back_inserter(all));
    }
    if (joints.size() < 2) { return all; }
    for (EquationGroup& group : all) { group.owner = story.lesson().mechanism.joints[at(group.joint)].name; }
    return all;
}

/// The equations of a joint that a question asks about before it is added, without saying which are kept.
std::vector<EquationGroup> asked_equations(const Story& story, const Step& step, int index, int joint) {
    if (joint < 0) { return {}; }
    for (std::size_t k = static_cast<std::size_t>(index) + 1; k < story.steps().size(); ++k) {
        const Step& after = story.steps()[k];
        if (after.additions > step.additions) { return open_equations(step, after, joint); }
    }
    return {};
}

NewtonRow newton_row_of(const System& system, const NewtonStep& newton) {
    NewtonRow row;
    row.iteration = newton.iteration;
    row.phi_norm = newton.phi_norm;
    row.largest_row = row_label(system, newton.largest_row);
    row.largest_value = newton.largest_value;
    row.stepped = newton.rank > 0;  // false when closed or given up
    row.delta_norm = newton.delta_norm;
    row.turn_deg = newton.turn * kDegreesPerRadian;
    row.fraction = newton.fraction;
    row.rank = newton.rank;
    if (newton.converged) {
        row.note = tr("closed");
    } else if (newton.fraction < 1.0) {
        row.note = tr("step limited");
    }
    return row;
}

std::vector<NewtonRow> newton_rows_of(const Step& step) {
    std::vector<NewtonRow> rows;
    const auto add = Overloaded{
        [&](const NewtonStep& newton) { rows.push_back(newton_row_of(*step.system, newton)); },
        [&](const WrongBranch&) {
            if (!rows.empty()) { rows.back().note = tr("wrong branch: leaving it"); }
        },
    };
    for (const PositionEvent& event : step.events) { std::visit(add, event); }
    return rows;
}

std::vector<BodyMotion> body_motions_of(const Step& step) {
    std::vector<BodyMotion> motions;
    for (const int body : step.system->moving_bodies()) {
        const auto b = at(body);
        const Mat3 A = rotation_matrix(step.state.p[b]);
        BodyMotion motion;
        motion.body = step.system->mechanism().bodies[b].name;
        motion.r = step.state.r[b];
        motion.p = step.state.p[b];
        motion.r_dot = step.velocity.r_dot[b];
        motion.r_ddot = step.acceleration.r_dot[b];
        motion.omega = A * step.velocity.omega_local[b];
        motion.omega_dot = A * step.acceleration.omega_local[b];
        motions.push_back(std::move(motion));
    }
    return motions;
}

std::string author_text_of(const Lesson& lesson, const Step& step) {
    const StepTexts& texts = lesson.step_texts;
    if (step.kind == Step::Kind::bodies) {
        return lesson.text + (lesson.text.empty() || texts.bodies.empty() ? "" : " ") + texts.bodies;
    }
    if (step.kind == Step::Kind::motion) {
        std::string text = texts.motion;
        for (const StepTexts::AtTime& at : texts.times) {
            if (at.from <= step.t) { text = at.text; }
        }
        return text;
    }
    if (is_asked(step.kind)) { return {}; }
    const Addition subject = *subject_of(lesson, step);
    const auto k = at(subject.index);
    return subject.kind == Addition::Kind::joint ? texts.joints[k] : texts.drivers[k];
}

/// Adds the summary of a lesson, at its end.
void add_summary(const Lesson& lesson, View& view) {
    if (lesson.summary.empty()) { return; }
    std::string& text = view.question ? view.question->why : view.author_text;
    if (!text.empty()) { text += "\n\n"; }
    text += tr("In short: {0}", lesson.summary);
}

std::string velocity_note_of(const Step& step) {
    if (step.kind != Step::Kind::motion) { return {}; }
    const auto row = [&](const LinearVerdict& verdict) { return row_label(*step.system, verdict.worst_row); };
    // at its end the motion is no longer determined, and the failure says why
    if (step.failed()) { return {}; }
    if (!step.velocity_verdict.consistent) {
        return tr("The rows contradict each other: no velocity satisfies {0}.", row(step.velocity_verdict));
    }
    if (!step.acceleration_verdict.consistent) {
        return tr(
            "The rows contradict each other: no acceleration satisfies {0}.", row(step.acceleration_verdict));
    }
    if (!step.velocity_verdict.unique) {
        return tr(
            "Velocities are not unique: of all that satisfy the equations, those nearest to the previous "
            "ones are shown.");
    }
    return {};
}

/// All texts of the step that may have symbols.
std::vector<std::string> texts_of(const View& view) {
    std::vector<std::string> texts{view.sentence, view.author_text};
    if (!view.question) { return texts; }
    texts.insert(texts.end(), {view.question->ask, view.question->answer, view.question->why});
    std::ranges::copy(view.question->choices, std::back_inserter(texts));
    return texts;
}

/// The subject of a driver's symbols: its joint, or the body that it moves.
SymbolSubject symbol_subject_of(const Lesson& lesson, const std::vector<int>& joints, int driver) {
    SymbolSubject subject{joints, -1};
    if (driver < 0) { return subject; }
    const Mechanism& mechanism = lesson.mechanism;
    const Driver& d = mechanism.drivers[at(driver)];
    if (d.joint >= 0) {
        subject.joints = {d.joint};
    } else {
        const bool j_moves = !mechanism.bodies[at(d.body_j)].fixed;
        subject.body = j_moves ? d.body_j : d.body_i;
    }
    return subject;
}

}  // namespace

std::vector<std::string> RankView::told_motions() const {
    if (!judged_motions) { return free_motions; }
    std::vector<std::string> told;
    for (const ListedMotion& motion : *judged_motions) { told.push_back(motion.told); }
    return told;
}

View view_of(const Story& story, int index, ViewParts parts) {
    return view_of(story, story.steps()[at(index)], index, parts);
}

View view_of(const Story& story, const Step& step, int index, ViewParts parts) {
    const Lesson& lesson = story.lesson();
    const RankReport report = rank_of(step);

    int joint = -1;
    int driver = -1;
    if (const auto subject = subject_of(lesson, step)) {
        (subject->kind == Addition::Kind::joint ? joint : driver) = subject->index;
    }
    std::vector<int> shown_joints;
    if (step.kind == Step::Kind::motion) {
        shown_joints = featured_joints(story);
    } else if (joint >= 0) {
        shown_joints.push_back(joint);
    }

    View view;
    view.kind = step.kind;
    view.step = index;
    view.steps = static_cast<int>(story.steps().size());
    view.t = step.t;
    view.lesson_title = lesson.title;
    view.source = joint >= 0 ? std::string(lesson.mechanism.joints[at(joint)].type->source) : lesson.source;
    view.title = title_of(lesson, step);
    view.rank = rank_view_of(step, report);
    view.rank.once_assembled = rank_once_assembled(story, step, index);
    view.sentence = sentence_of(lesson, step, report);
    if (view.rank.differs_once_assembled()) {
        view.sentence = followed(view.sentence, once_assembled_text(report.rank, *view.rank.once_assembled));
    }
    if (is_asked(step.kind)) { view.question = question_view_of(story, step); }
    view.author_text = author_text_of(lesson, step);
    if (index + 1 == view.steps && story.failure() == nullptr) { add_summary(lesson, view); }
    view.equations = equations_of(story, step, index, shown_joints, report);
    const int asked = joint_asked_about(lesson, step);
    std::ranges::move(asked_equations(story, step, index, asked), std::back_inserter(view.equations));
    if (asked >= 0) { shown_joints.push_back(asked); }
    if (driver >= 0) {
        view.equations.push_back(equation_of_driver(step, driver, report.assembled ? &report : nullptr));
    }
    view.symbols = symbols_of(
        step, lesson.coordinates, symbol_subject_of(lesson, shown_joints, driver), texts_of(view),
        view.equations);
    if (parts == ViewParts::all) { view.matrix = matrix_of(step, lesson.coordinates, report, joint, driver); }
    view.newton = newton_rows_of(step);
    view.bodies = body_motions_of(step);
    if (step.kind == Step::Kind::motion) { view.quantities = quantities_of(step); }
    if (parts == ViewParts::all) { view.dynamics = dynamics_view_of(step); }
    view.velocity_note = velocity_note_of(step);
    view.failure = failure_text(step);
    return view;
}

}  // namespace jw
