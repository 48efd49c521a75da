#include "app/session/output/json.hpp"

#include <array>
#include <cmath>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "core/equations/assembler.hpp"

namespace jw {

namespace {

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

const char* status_name(EquationRow::Status status) {
    switch (status) {
        case EquationRow::Status::kept: return "kept";
        case EquationRow::Status::dropped: return "dropped";
        case EquationRow::Status::open: return "open";
        case EquationRow::Status::redundant: break;
    }
    return "redundant";
}

Json json_of(const ChoiceView& choice) {
    Json conditions = Json::array();
    for (const double condition : choice.pair_condition) { conditions.push_back(number(condition)); }
    return {
        {"form", choice.form},
        {"dropped", choice.dropped < 0 ? Json() : Json(axis_name(choice.dropped))},
        {"axis_size", choice.axis_size},
        {"condition_without_xyz", conditions},
        {"condition", number(choice.form_condition)},
        {"reason", choice.reason}};
}

Json json_of(const EquationGroup& group) {
    Json rows = Json::array();
    for (const EquationRow& row : group.rows) {
        rows.push_back(
            {{"component", text_or_null(row.component)},
             {"value", number(row.value)},
             {"row", row.row < 0 ? Json() : Json(row.row)},
             {"status", status_name(row.status)}});
    }
    return {
        {"primitive", group.primitive},
        {"formula", group.plain},
        {"unit", group.unit},
        {"rows", rows},
        {"choice", group.choice ? json_of(*group.choice) : Json()}};
}

Json json_of(const NewtonRow& row) {
    Json json{
        {"iteration", row.iteration},
        {"phi_norm", number(row.phi_norm)},
        {"largest_row", row.largest_row},
        {"largest_value", number(row.largest_value)},
        {"note", text_or_null(row.note)}};
    if (row.stepped) {
        json["delta_norm"] = number(row.delta_norm);
        json["turn_deg"] = number(row.turn_deg);
        json["fraction"] = number(row.fraction);
        json["rank"] = row.rank;
    }
    return json;
}

Json json_of(const QuantityMotion& q) {
    return {{"name", q.name},           {"unit", q.unit},         {"driven", q.driven},
            {"value", number(q.value)}, {"rate", number(q.rate)}, {"acceleration", number(q.acceleration)}};
}

Json json_of(const SymbolMeaning& meaning) {
    return {
        {"owner", text_or_null(meaning.owner)},
        {"symbol", meaning.source},
        {"value", jw::json_of(meaning.value)},
        {"frame", text_or_null(meaning.frame)}};
}

/// The primitive of the equation, without the joint's index in front: the meanings have the joint's name.
std::string primitive_in(const std::string& scope) { return scope.substr(scope.find(' ') + 1); }

Json json_of(const SymbolView& symbol) {
    Json meanings = Json::array();
    for (const SymbolMeaning& meaning : symbol.meanings) { meanings.push_back(json_of(meaning)); }
    return {
        {"symbol", symbol.source},
        {"of_formula", text_or_null(primitive_in(symbol.scope))},
        {"what", text_or_null(symbol.what)},
        {"unit", text_or_null(symbol.unit)},
        {"defined", text_or_null(symbol.defined)},
        {"meanings", meanings},
        {"more", symbol.more}};
}

template <class T>
Json list_of(const std::vector<T>& items) {
    Json list = Json::array();
    for (const T& item : items) { list.push_back(json_of(item)); }
    return list;
}

const char* word_of(QuestionView::Kind kind) {
    switch (kind) {
        case QuestionView::Kind::number: return "number";
        case QuestionView::Kind::choice: return "choice";
        case QuestionView::Kind::thing: return "thing";
        case QuestionView::Kind::pose: break;
    }
    return "pose";
}

Json json_of(const QuestionView& question) {
    return {
        {"ask", question.ask},
        {"kind", word_of(question.kind)},
        {"choices", question.choices},
        {"names", question.names},
        {"how", text_or_null(question.how)},
        {"unit", text_or_null(question.unit)},
        {"answer", text_or_null(question.answer)},
        {"why", text_or_null(question.why)}};
}

/// One judgement per text of the free motions.
Json judgements_of(const RankView& rank, const Mechanism& mechanism) {
    if (!rank.judged_motions) { return {}; }
    Json list = Json::array();
    for (const ListedMotion& motion : *rank.judged_motions) {
        list.push_back(motion.judgement ? json_of(*motion.judgement, mechanism) : Json());
    }
    return list;
}

/// Verdict on typed digits; null if no digits of the lesson decide the rank.
Json json_of(const std::optional<TypedVerdict>& typed) {
    if (!typed) { return {}; }
    return {
        {"verdict", typed->is_told ? "meant" : "cannot tell"},
        {"rank_as_typed", typed->rank_as_typed},
        {"rank", typed->rank},
        {"misfit", number(typed->misfit)},
        {"share", typed->is_told ? number(typed->share) : Json()},
        {"short_of_digits", typed->short_of_digits.empty() ? Json() : Json(typed->short_of_digits)}};
}

const char* word_of(FreedomVerdict verdict) {
    switch (verdict) {
        case FreedomVerdict::finite: return "finite";
        case FreedomVerdict::first_order: return "first order";
        case FreedomVerdict::cannot_tell: break;
    }
    return "cannot tell";
}

Json json_of(const Departure& d, const Mechanism& m) {
    static constexpr std::array kCoordinates{"x", "y", "z", "turn"};
    return {
        {"order", d.order},
        {"coefficient", number(d.coefficient)},
        {"joint", d.joint >= 0 ? Json(m.joints[static_cast<std::size_t>(d.joint)].name) : Json()},
        {"driver", d.driver >= 0 ? Json(m.drivers[static_cast<std::size_t>(d.driver)].name) : Json()},
        {"body", m.bodies[static_cast<std::size_t>(d.body)].name},
        {"coordinate", kCoordinates[static_cast<std::size_t>(d.direction)]}};
}

Json json_of(const View& view, const Step& step) {
    Json json = {
        {"index", view.step},
        {"kind", kind_name(view.kind)},
        {"time_s", number(view.t)},
        {"title", view.title},
        {"sentence", view.sentence},
        {"text", text_or_null(view.author_text)},
        {"equations", list_of(view.equations)},
        {"symbols", list_of(view.symbols)},
        {"rank",
         {{"rows", view.rank.rows},
          {"columns", view.rank.columns},
          {"rank", view.rank.rank},
          {"rank_once_assembled", view.rank.once_assembled ? Json(*view.rank.once_assembled) : Json()},
          {"rank_before", view.rank.rank_before < 0 ? Json() : Json(view.rank.rank_before)},
          {"dof", view.rank.dof},
          {"redundant", view.rank.redundant()},
          {"mobility_by_counting", view.rank.mobility_by_counting},
          {"singular_values", view.rank.has_spectrum ? Json(view.rank.singular_values) : Json()},
          {"threshold", number(view.rank.threshold)},
          {"residual", number(view.rank.residual)},
          {"assembled", view.rank.assembled},
          {"near_singular", view.rank.near_singular},
          {"singular_value_error", number(view.rank.singular_value_error)},
          {"decided", view.rank.decided},
          {"doubts", view.rank.doubts},
          {"redundant_rows", view.rank.redundant_rows},
          {"combinations", view.rank.combinations},
          {"free_motions", view.rank.has_spectrum ? Json(view.rank.free_motions) : Json()},
          {"free_motion_judgements", judgements_of(view.rank, step.system->mechanism())},
          {"typed_digits", json_of(view.rank.typed)}}},
        {"newton", list_of(view.newton)},
        {"quantities", list_of(view.quantities)},
        {"note", text_or_null(view.velocity_note)},
        {"failure", text_or_null(view.failure)},
        {"bodies", json_of(step.system->mechanism(), step.state, step.velocity)}};
    if (view.question) { json["question"] = json_of(*view.question); }
    return json;
}

}  // namespace

Json json_of(const FreedomJudgement& judgement, const Mechanism& mechanism) {
    return {
        {"verdict", word_of(judgement.verdict)},
        {"motion_beside", judgement.has_motion_beside},
        {"departure", judgement.departure ? json_of(*judgement.departure, mechanism) : Json()}};
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

const char* kind_name(Step::Kind kind) {
    switch (kind) {
        case Step::Kind::bodies: return "bodies";
        case Step::Kind::equations: return "equations";
        case Step::Kind::iteration: return "iteration";
        case Step::Kind::assembled: return "assembled";
        case Step::Kind::failed: return "failed";
        case Step::Kind::question: return "question";
        case Step::Kind::answer: return "answer";
        case Step::Kind::motion: break;
    }
    return "motion";
}

Json json_of(const Vec3& v) { return Json::array({number(v.x()), number(v.y()), number(v.z())}); }

Json json_of(const VectorX& v) {
    Json list = Json::array();
    for (const double x : v) { list.push_back(number(x)); }
    return list;
}

Json json_of(const MatrixX& m) {
    Json list = Json::array();
    for (Eigen::Index row = 0; row < m.rows(); ++row) { list.push_back(json_of(VectorX(m.row(row)))); }
    return list;
}

Json json_of(const Mechanism& mechanism, const State& state, const Motion& velocity) {
    Json list = Json::array();
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        const Vec4& p = state.p[b];
        const Vec3& omega_local = velocity.omega_local[b];
        list.push_back(
            {{"name", mechanism.bodies[b].name},
             {"fixed", mechanism.bodies[b].fixed},
             {"r", json_of(state.r[b])},
             {"p", json_of(VectorX(p))},
             {"r_dot", json_of(velocity.r_dot[b])},
             {"p_dot", json_of(VectorX(p_dot_of_omega_local(p, omega_local)))},
             {"omega_local", json_of(omega_local)},
             {"omega_global", json_of(Vec3(rotation_matrix(p) * omega_local))}});
    }
    return list;
}

Json json_of(const EquationResidual& residual) {
    return {{"value", number(residual.residual)}, {"bound", number(residual.bound)}};
}

Json json_of(const RankReport& report, const System& system, const FreedomJudgements& judgements) {
    Json redundant = Json::array();
    for (const RedundantRow& row : report.redundant_rows) {
        Json terms = Json::array();
        for (const RedundantRow::Term& term : row.terms) {
            terms.push_back(
                {{"row", term.row},
                 {"label", row_label(system, term.row)},
                 {"coefficient", number(term.coefficient)}});
        }
        redundant.push_back(
            {{"row", row.row},
             {"label", row_label(system, row.row)},
             {"terms", terms},
             {"misfit", row.misfit},
             {"bound", row.bound}});
    }
    Json motions = Json::array();
    for (std::size_t k = 0; k < report.free_motions.size(); ++k) {
        const FreeMotion& motion = report.free_motions[k];
        motions.push_back(
            {{"text", free_motion_text(system, motion)},
             {"columns", json_of(VectorX(motion))},
             {"residual", number(report.free_motion_proofs[k].residual)},
             {"bound", number(report.free_motion_proofs[k].bound)}});
        const bool is_judged = !judgements.empty() && judgements[k];
        motions.back()["judgement"] = is_judged ? json_of(*judgements[k], system.mechanism()) : Json();
    }
    return {
        {"rows", report.rows},
        {"columns", report.columns},
        {"rank", report.rank},
        {"dof", report.dof},
        {"redundant", report.redundant()},
        {"mobility_by_counting", report.mobility_by_counting},
        {"singular_values", report.has_spectrum ? json_of(report.singular_values) : Json()},
        {"threshold", number(report.threshold)},
        {"residual", number(report.residual)},
        {"gap", number(report.largest_gap)},
        {"assembled", report.assembled},
        {"near_singular", report.near_singular},
        {"singular_value_error", number(report.singular_value_error)},
        {"pose_error", number(report.pose_error)},
        {"decided", report.decided},
        {"doubts", doubts_of(system, report)},
        {"redundant_rows", redundant},
        {"free_motions", report.has_spectrum ? motions : Json()},
        {"typed_digits", json_of(report.typed)}};
}

Json json_of(const Story& story, int until) {
    Json steps = Json::array();
    for (int k = 0; k <= until; ++k) {
        steps.push_back(json_of(
            view_of(story, k, ViewParts::without_matrix), story.steps()[static_cast<std::size_t>(k)]));
    }
    const Lesson& lesson = story.lesson();
    return {
        {"format", "jointwise step"},
        {"version", kJsonVersion},
        {"lesson",
         {{"file", lesson.file_name},
          {"title", lesson.title},
          {"chapter", lesson.chapter},
          {"source", lesson.source},
          {"text", lesson.text}}},
        {"steps", steps}};
}

}  // namespace jw
