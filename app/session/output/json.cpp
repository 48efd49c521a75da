#include "app/session/output/json.hpp"

#include <array>
#include <cmath>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "core/equations/assembler.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

/// Number of bytes of a control character U+007F to U+009F at `at`; 0 for anything else.
std::size_t control_at(const std::string& text, std::size_t at) {
    if (text[at] == '\x7f') { return 1; }
    if (text[at] != '\xC2' || at + 1 == text.size()) { return 0; }
    return static_cast<unsigned char>(text[at + 1]) < 0xA0U ? 2 : 0;
}

std::string escaped_control(char last_byte) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(last_byte);
    return {'\\', 'u', '0', '0', kDigits[code >> 4U], kDigits[code & 15U]};
}

constexpr std::array kStatuses{
    EnumWord<EquationRow::Status>{EquationRow::Status::kept, "kept"},
    EnumWord<EquationRow::Status>{EquationRow::Status::dropped, "dropped"},
    EnumWord<EquationRow::Status>{EquationRow::Status::open, "open"},
    EnumWord<EquationRow::Status>{EquationRow::Status::redundant, "redundant"}};

Json json_of(const ChoiceView& choice) {
    return {
        {"form", choice.form},
        {"dropped", choice.dropped < 0 ? Json() : Json(axis_name(choice.dropped))},
        {"axis_size", choice.axis_size},
        {"condition_without_xyz", list_of(choice.pair_condition, number)},
        {"condition", number(choice.form_condition)},
        {"reason", choice.reason}};
}

Json json_of(const EquationGroup& group) {
    const auto row_json = [](const EquationRow& row) -> Json {
        return {
            {"component", text_or_null(row.component)},
            {"value", number(row.value)},
            {"row", row.row < 0 ? Json() : Json(row.row)},
            {"status", word_of(kStatuses, row.status)}};
    };
    return {
        {"primitive", group.primitive},
        {"formula", group.plain},
        {"unit", group.unit},
        {"rows", list_of(group.rows, row_json)},
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

Json meaning_json(const SymbolMeaning& meaning) {
    return {
        {"owner", text_or_null(meaning.owner)},
        {"symbol", meaning.source},
        {"value", jw::json_of(meaning.value)},
        {"frame", text_or_null(meaning.frame)}};
}

/// The primitive of the equation, without the joint's index in front: the meanings have the joint's name.
std::string primitive_in(const std::string& scope) { return scope.substr(scope.find(' ') + 1); }

Json json_of(const SymbolView& symbol) {
    return {
        {"symbol", symbol.source},
        {"of_formula", text_or_null(primitive_in(symbol.scope))},
        {"what", text_or_null(symbol.what)},
        {"unit", text_or_null(symbol.unit)},
        {"defined", text_or_null(symbol.defined)},
        {"meanings", list_of(symbol.meanings, meaning_json)},
        {"more", symbol.more}};
}

constexpr std::array kStepKinds{
    EnumWord<Step::Kind>{Step::Kind::bodies, "bodies"},
    EnumWord<Step::Kind>{Step::Kind::equations, "equations"},
    EnumWord<Step::Kind>{Step::Kind::iteration, "iteration"},
    EnumWord<Step::Kind>{Step::Kind::assembled, "assembled"},
    EnumWord<Step::Kind>{Step::Kind::failed, "failed"},
    EnumWord<Step::Kind>{Step::Kind::question, "question"},
    EnumWord<Step::Kind>{Step::Kind::answer, "answer"},
    EnumWord<Step::Kind>{Step::Kind::motion, "motion"}};

constexpr std::array kQuestionKinds{
    EnumWord<QuestionView::Kind>{QuestionView::Kind::number, "number"},
    EnumWord<QuestionView::Kind>{QuestionView::Kind::choice, "choice"},
    EnumWord<QuestionView::Kind>{QuestionView::Kind::thing, "thing"},
    EnumWord<QuestionView::Kind>{QuestionView::Kind::pose, "pose"}};

Json json_of(const QuestionView& question) {
    return {
        {"ask", question.ask},
        {"kind", word_of(kQuestionKinds, question.kind)},
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
    return list_of(*rank.judged_motions, [&](const ListedMotion& motion) {
        return motion.judgement ? json_of(*motion.judgement, mechanism) : Json();
    });
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
        {"short_of_digits", text_or_null(typed->short_of_digits)}};
}

constexpr std::array kFreedomVerdicts{
    EnumWord<FreedomVerdict>{FreedomVerdict::finite, "finite"},
    EnumWord<FreedomVerdict>{FreedomVerdict::first_order, "first order"},
    EnumWord<FreedomVerdict>{FreedomVerdict::cannot_tell, "cannot tell"}};

Json json_of(const Departure& d, const Mechanism& m) {
    static constexpr std::array kCoordinates{"x", "y", "z", "turn"};
    return {
        {"order", d.order},
        {"coefficient", number(d.coefficient)},
        {"joint", d.joint >= 0 ? Json(m.joints[at(d.joint)].name) : Json()},
        {"driver", d.driver >= 0 ? Json(m.drivers[at(d.driver)].name) : Json()},
        {"body", m.bodies[at(d.body)].name},
        {"coordinate", kCoordinates[at(d.direction)]}};
}

Json json_of(const View& view, const Step& step) {
    const auto any_json = [](const auto& item) { return json_of(item); };
    Json json = {
        {"index", view.step},
        {"kind", kind_name(view.kind)},
        {"time_s", number(view.t)},
        {"title", view.title},
        {"sentence", view.sentence},
        {"text", text_or_null(view.author_text)},
        {"equations", list_of(view.equations, any_json)},
        {"symbols", list_of(view.symbols, any_json)},
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
        {"newton", list_of(view.newton, any_json)},
        {"quantities", list_of(view.quantities, any_json)},
        {"note", text_or_null(view.velocity_note)},
        {"failure", text_or_null(view.failure)},
        {"bodies", json_of(step.system->mechanism(), step.state, step.velocity)}};
    if (view.question) { json["question"] = json_of(*view.question); }
    return json;
}

}  // namespace

std::string json_document(const Json& json, int indent) {
    const std::string text = json.dump(indent, ' ', false, Json::error_handler_t::replace);
    std::string shown;
    shown.reserve(text.size() + 1);
    // outside of strings, JSON is ASCII without control characters
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t bytes = control_at(text, at);
        if (bytes == 0) {
            shown += text[at];
            continue;
        }
        at += bytes - 1;
        shown += escaped_control(text[at]);
    }
    return shown + "\n";
}

Json json_of(const FreedomJudgement& judgement, const Mechanism& mechanism) {
    return {
        {"verdict", word_of(kFreedomVerdicts, judgement.verdict)},
        {"motion_beside", judgement.has_motion_beside},
        {"departure", judgement.departure ? json_of(*judgement.departure, mechanism) : Json()}};
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

const char* kind_name(Step::Kind kind) { return word_of(kStepKinds, kind); }

Json json_of(const Vec3& v) { return Json::array({number(v.x()), number(v.y()), number(v.z())}); }

Json json_of(const VectorX& v) { return list_of(v, number); }

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
    const auto term_json = [&](const RedundantRow::Term& term) -> Json {
        return {
            {"row", term.row},
            {"label", row_label(system, term.row)},
            {"coefficient", number(term.coefficient)}};
    };
    const auto redundant_json = [&](const RedundantRow& row) -> Json {
        return {
            {"row", row.row},
            {"label", row_label(system, row.row)},
            {"terms", list_of(row.terms, term_json)},
            {"misfit", row.misfit},
            {"bound", row.bound}};
    };
    Json motions = Json::array();
    for (std::size_t k = 0; k < report.free_motions.size(); ++k) {
        const FreeMotion& motion = report.free_motions[k];
        const bool is_judged = !judgements.empty() && judgements[k];
        motions.push_back(
            {{"text", free_motion_text(system, motion)},
             {"columns", json_of(VectorX(motion))},
             {"residual", number(report.free_motion_proofs[k].residual)},
             {"bound", number(report.free_motion_proofs[k].bound)},
             {"judgement", is_judged ? json_of(*judgements[k], system.mechanism()) : Json()}});
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
        {"redundant_rows", list_of(report.redundant_rows, redundant_json)},
        {"free_motions", report.has_spectrum ? motions : Json()},
        {"typed_digits", json_of(report.typed)}};
}

Json json_of(const Story& story, int until) {
    Json steps = Json::array();
    for (int k = 0; k <= until; ++k) {
        steps.push_back(json_of(view_of(story, k, ViewParts::without_matrix), story.steps()[at(k)]));
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
