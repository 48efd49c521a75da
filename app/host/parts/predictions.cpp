#include "app/host/parts/predictions.hpp"

#include <algorithm>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/picture/pointable.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw::host {

namespace {

namespace theme = panels::theme;
using panels::Box;
using panels::Canvas;

constexpr float kSheetMargin = 10.0F;
constexpr float kPadding = 12.0F;  // around the text in the sheet
constexpr float kLeastField = 60.0F;

/// Width of the text in the sheet.
float width_of_words(const Ui& ui, const Box& scene) {
    return scene.width - 2.0F * ui.px(kSheetMargin + kPadding);
}

/// Place of a sheet of this height at the foot of the picture.
Box sheet_of(const Ui& ui, const Box& scene, float height) {
    const float margin = ui.px(kSheetMargin);
    return {scene.x + margin, scene.bottom() - height - margin, scene.width - 2.0F * margin, height};
}

std::string verdict_text(const GivenAnswer& answer) {
    return answer.right ? tr("{0}   Right.", math::plain_words(answer.note))
                        : tr("{0}   Not correct.", math::plain_words(answer.note));
}

/// Hint in the empty field of an answer.
const char* hint_of(QuestionView::Kind kind) {
    switch (kind) {
        case QuestionView::Kind::number: return tr("your answer  (a)");
        case QuestionView::Kind::choice: return tr("or its number  (a)");
        case QuestionView::Kind::thing: return tr("or its name  (a)");
        case QuestionView::Kind::pose: break;
    }
    return tr("or seven numbers  (a)");
}

/// Width that the unit and the buttons leave for the field.
float room_for_field(const QuestionView& question) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float beside = 0.0F;
    for (const char* const label : {tr("Answer"), tr("Skip")}) {
        beside += ImGui::CalcTextSize(label).x + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
    }
    if (!question.unit.empty()) {
        beside += ImGui::CalcTextSize(question.unit.c_str()).x + style.ItemSpacing.x;
    }
    return ImGui::GetContentRegionAvail().x - beside;
}

/// Pose into which the user has led the body that is asked about, as text that could be typed.
std::string pose_in_hand(const Session& session) {
    const Step& step = session.step();
    const PoseAnswer& asked = std::get<PoseAnswer>(question_of(session.lesson(), step).answer);
    const auto b = static_cast<std::size_t>(asked.body);
    return pose_text({step.state.r[b], step.state.p[b]});
}

}  // namespace

const GivenAnswer* Predictions::given(int question) const {
    const auto found = given_.find(question);
    return found == given_.end() ? nullptr : &found->second;
}

float Predictions::height(const LessonUi& ui, const Box& scene) const {
    const Step& step = ui.session.step();
    if (!is_asked(step.kind) || !is_shown(ui.session)) { return 0.0F; }
    const float margin = 2.0F * ui.px(kSheetMargin);
    if (step.kind == Step::Kind::question) {
        const std::string& how = ui.session.view().question->how;
        const float width = width_of_words(ui, scene);
        const float said =
            how.empty() ? 0.0F : panels::paragraph_height(ui.canvas, ui.canvas.fonts().small, how, width);
        return ImGui::GetFrameHeightWithSpacing() * (objection_.empty() ? 1.0F : 2.0F) + said + ui.px(16.0F) +
               margin;
    }
    const GivenAnswer* const answer = given(step.question);
    if (answer == nullptr) { return 0.0F; }
    const float width = width_of_words(ui, scene);
    return panels::paragraph_height(ui.canvas, ui.canvas.fonts().normal, verdict_text(*answer), width) +
           ui.px(16.0F) + margin;
}

void Predictions::draw(const LessonUi& ui, const Box& scene) {
    const Lesson& lesson = ui.session.lesson();
    if (lesson.title != lesson_) {
        lesson_ = lesson.title;
        given_.clear();
        objection_.clear();
        field_[0] = '\0';
    }
    const Step& step = ui.session.step();
    // the objection belongs to the previous question
    if (step.question != asked_) { objection_.clear(); }
    asked_ = step.question;
    if (step.kind == Step::Kind::question && is_shown(ui.session)) {
        ask(ui, scene, step);
    } else if (step.kind == Step::Kind::answer && is_shown(ui.session)) {
        compare(ui, scene, step);
    }
    if (step.kind != Step::Kind::question) { wants_focus_ = false; }
}

void Predictions::ask(const LessonUi& ui, const Box& scene, const Step& step) {
    const QuestionView& question = *ui.session.view().question;
    const Box sheet = sheet_of(ui, scene, height(ui, scene) - 2.0F * ui.px(kSheetMargin));
    panels::sheet(ui.canvas, sheet, theme::kPaper, theme::kAccent);
    const Area area(ui, "prediction", sheet);
    note(ui, question.how);
    for (std::size_t k = 0; k < question.choices.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        if (ImGui::Button((" " + number + " ").c_str())) { take(ui, step, number); }
        if (ImGui::IsItemHovered()) { tip_of_item(math::plain_words(question.choices[k])); }
        ImGui::SameLine();
    }
    field(ui, question, step);
    if (!objection_.empty()) { note(ui, objection_); }
}

/// Field for an answer, and the buttons beside it. If the buttons of a choice leave no room for the field,
/// only these buttons can be used.
void Predictions::field(const LessonUi& ui, const QuestionView& question, const Step& step) {
    const float room = room_for_field(question);
    const bool is_typed = question.choices.empty() || room >= ui.px(kLeastField);
    bool entered = false;
    bool pressed = false;
    if (is_typed) {
        if (wants_focus_) { ImGui::SetKeyboardFocusHere(); }
        ImGui::SetNextItemWidth(std::clamp(room, 1.0F, ui.px(150.0F)));
        entered = ImGui::InputTextWithHint(
            "##answer", hint_of(question.kind), field_.data(), field_.size(),
            ImGuiInputTextFlags_EnterReturnsTrue);
        if (!question.unit.empty()) {
            ImGui::SameLine();
            ImGui::TextUnformatted(question.unit.c_str());
        }
        ImGui::SameLine();
        pressed = ImGui::Button(tr("Answer"));
        ImGui::SameLine();
    }
    wants_focus_ = false;
    command_button(ui, Command::next, tr("Skip"));
    if (!entered && !pressed) { return; }
    // a copy, because taking the answer empties the field
    const std::string typed = field_.data();
    const bool led = question.kind == QuestionView::Kind::pose && typed.empty() && ui.session.in_hand();
    take(ui, step, led ? pose_in_hand(ui.session) : typed);
}

void Predictions::follow_mouse(const LessonUi& ui, const Pointed& pointed, bool reachable) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        pressed_ = {};
        // for a cell of the matrix: its row, or the body of its column
        if (reachable) { pressed_ = {pointed.symbol, pointed.row, pointed.column, ui.state.pointed_at}; }
    }
    const float way = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left];
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && way <= kLongestClick * kLongestClick) {
        click(ui, pressed_);
    }
}

void Predictions::click(const LessonUi& ui, const std::array<Pointable, 4>& places) {
    const Session& session = ui.session;
    const Step& step = session.step();
    if (step.kind != Step::Kind::question || !is_shown(session)) { return; }
    const View& view = session.view();
    const QuestionView& question = *view.question;
    if (question.kind != QuestionView::Kind::thing) { return; }
    bool any = false;
    for (const Pointable& place : places) {
        any = any || place;
        if (const auto thing = thing_at(step, view, place, question.thing)) {
            return take(ui, step, name_of(*thing, session.lesson().mechanism));
        }
    }
    if (any) { objection_ = tr("That is not what the question asks for. {0}", question.how); }
}

/// While a body is led by hand, only a question that asks for its pose stays visible.
bool Predictions::is_shown(const Session& session) { return !session.in_hand() || session.asks_for_pose(); }

/// Stores an answer that is understood, and goes to the next step.
void Predictions::take(const LessonUi& ui, const Step& step, const std::string& text) {
    // an empty field skips the question
    if (text.empty()) { return ui.requests.add(Command::next); }
    const QuestionView& question = *ui.session.view().question;
    GivenAnswer judged = judge_answer(
        question, right_answer(ui.session.story(), step.question), ui.session.lesson().mechanism, text);
    if (!judged.understood) {
        objection_ = tr("'{0}' is not an answer: {1}.", text, judged.note);
        return;
    }
    objection_.clear();
    field_[0] = '\0';
    given_[step.question] = std::move(judged);
    ui.requests.add(Command::next);
}

void Predictions::compare(const LessonUi& ui, const Box& scene, const Step& step) const {
    const GivenAnswer* const answer = given(step.question);
    if (answer == nullptr) { return; }
    const Canvas& canvas = ui.canvas;
    const ImFont* const font = canvas.fonts().normal;
    const std::string text = verdict_text(*answer);
    const Box sheet = sheet_of(ui, scene, height(ui, scene) - 2.0F * ui.px(kSheetMargin));
    panels::sheet(
        canvas, sheet, answer->right ? theme::kPaper : theme::kWarningShade,
        answer->right ? theme::kAccent : theme::kSubjectMark);
    panels::paragraph(
        canvas, {sheet.x + ui.px(kPadding), sheet.y + ui.px(8.0F), width_of_words(ui, scene), sheet.height},
        font, theme::kInk, text);
}

}  // namespace jw::host
