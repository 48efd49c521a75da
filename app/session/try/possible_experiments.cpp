#include "app/session/try/possible_experiments.hpp"

#include <algorithm>
#include <numbers>

#include "app/session/try/experiment_text.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/model/placement.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

bool is_in(const std::vector<Addition>& order, const Addition& addition) {
    return std::ranges::find(order, addition) != order.end();
}

Effect effect_of(const RankReport& report) {
    Effect effect{report.rows, report.rank, report.dof, 0.0};
    if (report.rank > 0) { effect.condition = report.first_value() / report.last_value(); }
    return effect;
}

/// The experiments with one lesson, judged at the pose of one step.
class Laboratory {
public:
    explicit Laboratory(const Session& session)
        : session_(session),
          step_(session.story().steps()[at(closed_step(session.story(), session.index()))]),
          report_(rank_of(*step_.system, step_.state, step_.t)) {
        const std::vector<Addition>& order = session.lesson().order;
        present_.assign(order.begin(), order.begin() + step_.additions);
    }

    PossibleExperiments all(const ExperimentsListener& listener) {
        PossibleExperiments all = outline();
        if (listener.begin) { listener.begin(all); }
        all.groups.clear();
        for (const Addition& part : session_.as_written().order) {
            all.groups.push_back(group_of(part));
            if (listener.group) { listener.group(all.groups.back()); }
        }
        all.free_motions = free_motions();
        all.coordinates = coordinates();
        return all;
    }

private:
    Effect effect_of_lesson(const Lesson& lesson) const {
        Lesson part = lesson;
        // additions that the story has not made yet stay out; those that the experiment puts back take part
        std::erase_if(part.order, [&](const Addition& a) {
            return is_in(session_.lesson().order, a) && !is_in(present_, a);
        });
        System system(part.mechanism, selection_of(part, static_cast<int>(part.order.size())));
        system.choose_rows(step_.state);
        return effect_of(rank_verdict_of(system, step_.state, step_.t));
    }

    PossibleExperiment judged(const Experiment& experiment, bool now) const {
        PossibleExperiment e;
        e.text = text_of(experiment, session_.lesson());
        e.now = now;
        if (!with_effects_) { return e; }
        if (now) {
            e.effect = effect_of(report_);
            return e;
        }
        const Edit edit = edited(session_.lesson(), session_.as_written(), experiment);
        if (edit.lesson) { e.effect = effect_of_lesson(*edit.lesson); }
        return e;
    }

    void add_presence(const Addition& part, ExperimentGroup& group) const {
        if (!is_in(session_.lesson().order, part)) {
            group.experiments.push_back(judged(SetPresent{part, true}, false));
        } else if (is_in(present_, part)) {
            group.experiments.push_back(judged(SetPresent{part, false}, false));
        }
    }

    void add_forms(int index, ExperimentGroup& group) const {
        const Joint& joint = session_.lesson().mechanism.joints[at(index)];
        if (std::ranges::any_of(joint.type->roles, is_parallel)) {
            for (const auto& [wanted, word, label] : kParallelForms) {
                group.experiments.push_back(
                    judged(SetParallelForm{index, wanted}, joint.parallel_form == wanted));
            }
        }
        if (joint.type->uses(Role::screw_angle)) {
            for (const auto& [wanted, word, label] : kAngleRows) {
                group.experiments.push_back(
                    judged(SetScrewAngleForm{index, wanted}, joint.geometry.screw_angle_form == wanted));
            }
        }
    }

    /// Lists the equations that can be taken out because they have a row, and those that can be put back.
    void add_equations(int index, ExperimentGroup& group) const {
        const Joint& joint = session_.lesson().mechanism.joints[at(index)];
        const std::vector<int> removable = removable_rows(report_);
        for (int row = 0; row < step_.system->rows(); ++row) {
            const Constraint* const c = constraint_of(*step_.system, row);
            if (c == nullptr || c->joint != index) { continue; }
            PossibleExperiment e = judged(
                SetEquationPresent{index, {c->role, step_.system->origin(row).component}, false}, false);
            e.free = std::ranges::find(removable, row) != removable.end();
            group.experiments.push_back(std::move(e));
        }
        for (const EquationOut& out : joint.without) {
            group.experiments.push_back(judged(SetEquationPresent{index, out, true}, false));
        }
    }

    /// Lists the present geometry as an experiment, to be typed again with other numbers.
    void add_geometry(int index, ExperimentGroup& group) const {
        const Joint& joint = session_.lesson().mechanism.joints[at(index)];
        const std::string name =
            " " + quoted_name(joint.name, experiment_text::names_of_joints(session_.lesson()));
        const auto add = [&](const std::string& what, const std::string& side, const Vec3& v) {
            const std::string numbers = experiment_text::numbers_text(v);
            group.experiments.push_back({what + name + side + numbers, true, false, {}});
        };
        const JointGeometry& g = joint.geometry;
        const JointNeeds needs(*joint.type);
        if (needs.axis) { add("axis", " i ", g.s_i_local); }
        if (needs.axis_j) { add("axis", " j ", g.s_j_local); }
        if (needs.points) {
            add("point", " i ", g.P_i_local);
            add("point", " j ", g.P_j_local);
        }
    }

    ExperimentGroup of_joint(int index) const {
        const Mechanism& m = session_.lesson().mechanism;
        const Joint& joint = m.joints[at(index)];
        ExperimentGroup group;
        group.title = joint.name + " · " + std::string(joint.type->name) + " · " +
                      m.bodies[at(joint.body_i)].name + " – " + m.bodies[at(joint.body_j)].name;
        const Addition part{Addition::Kind::joint, index};
        add_presence(part, group);
        if (!is_in(present_, part)) { return group; }
        add_forms(index, group);
        add_equations(index, group);
        add_geometry(index, group);
        return group;
    }

    ExperimentGroup of_driver(int index) const {
        const Driver& driver = session_.lesson().mechanism.drivers[at(index)];
        ExperimentGroup group;
        group.title = driver.name + " · " + tr("driver");
        add_presence({Addition::Kind::driver, index}, group);
        TimeFunction function = driver.function;
        function.polynomial.resize(std::max<std::size_t>(2, function.polynomial.size()), 0.0);
        group.experiments.push_back(
            {text_of(SetDriver{index, function}, session_.lesson()), true, false, {}});
        return group;
    }

    /// Choices of coordinates, each with the condition number of the unscaled Φq, normalisation rows
    /// included.
    ExperimentGroup coordinates() const {
        ExperimentGroup group;
        group.title = tr("coordinates of Φq");
        const int step = closed_step(session_.story(), session_.index());
        for (const auto& [choice, word, label] : kChoices) {
            PossibleExperiment e{
                text_of(SetCoordinates{choice}, session_.lesson()),
                session_.lesson().coordinates == choice,
                false,
                {}};
            if (!with_effects_) {
                group.experiments.push_back(std::move(e));
                continue;
            }
            const Inspection inspection = inspect_step(session_.story(), step, choice);
            const auto rows = static_cast<int>(inspection.phi.size());
            // a row pᵀp - 1 per moving body is independent of all others
            const int rank = report_.rank + rows - step_.system->rows();
            e.effect = Effect{rows, rank, report_.dof, 0.0};
            if (rank > 0 && inspection.singular_values.size() >= rank) {
                e.effect->condition = inspection.singular_values(0) / inspection.singular_values(rank - 1);
            }
            group.experiments.push_back(std::move(e));
        }
        return group;
    }

    std::vector<FreeMotionVerdict> free_motions() const {
        std::vector<FreeMotionVerdict> verdicts;
        Hand hand(session_.story(), session_.index());
        for (int k = 0; k < static_cast<int>(report_.free_motions.size()); ++k) {
            if (!hand.follow(k, 1.0)) { continue; }
            const FreedomJudgement& judgement = *hand.followed();
            verdicts.push_back(
                {judgement, text_of(ShowFreedom{k, 1.0}, session_.lesson()),
                 free_motion_text(*step_.system, report_.free_motions[at(k)]),
                 leaving_text(*step_.system, judgement)});
        }
        return verdicts;
    }

    std::string moment() const {
        const std::optional<Addition> subject = subject_of(session_.lesson(), step_);
        if (step_.kind == Step::Kind::motion) { return tr("at {0} s", number_text(step_.t, 6)); }
        if (!subject) { return tr("with the free bodies"); }
        return tr("after {0}", name_of(*subject, session_.lesson().mechanism));
    }

    ExperimentGroup group_of(const Addition& part) const {
        return part.kind == Addition::Kind::joint ? of_joint(part.index) : of_driver(part.index);
    }

    /// Everything that is known without the rank of any experiment.
    PossibleExperiments outline() {
        PossibleExperiments outline;
        outline.moment = moment();
        outline.step = closed_step(session_.story(), session_.index());
        outline.present = effect_of(report_);
        for (const int row : removable_rows(report_)) {
            outline.removable.push_back(row_label(*step_.system, row));
        }
        for (const RedundantRow& row : report_.redundant_rows) {
            outline.combinations.push_back(combination_text(*step_.system, row));
        }
        with_effects_ = false;
        for (const Addition& part : session_.as_written().order) { outline.groups.push_back(group_of(part)); }
        outline.coordinates = coordinates();
        with_effects_ = true;
        return outline;
    }

    const Session& session_;
    const Step& step_;
    RankReport report_;
    std::vector<Addition> present_;
    bool with_effects_ = true;
};

}  // namespace

PossibleExperiments possible_experiments_of(const Session& session, const ExperimentsListener& listener) {
    return Laboratory(session).all(listener);
}

}  // namespace jw
