#include "app/host/parts/predictions.hpp"

#include <algorithm>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw::host {

namespace {

namespace theme = panels::theme;
using panels::Box;
using panels::Canvas;

constexpr float kSheetMargin = 10.0F;

/// A sheet at the foot of the picture, for so many lines.
Box sheet_of(const Ui& ui, const Box& scene, float height) {
    const float margin = ui.px(kSheetMargin);
    return {scene.x + margin, scene.bottom() - height - margin, scene.width - 2.0F * margin, height};
}

std::string verdict_text(const GivenAnswer& answer) {
    return answer.right ? tr("{0}   Right.", math::plain_words(answer.note))
                        : tr("{0}   Not so.", math::plain_words(answer.note));
}

/// The right answer to a question, which the story may reach or not.
RightAnswer right_answer_to(const Session& session, int index) {
    const Story& story = session.story();
    const Question& question = story.lesson().questions[static_cast<std::size_t>(index)];
    for (const Step& step : story.steps()) {
        if (step.kind == Step::Kind::answer && step.question == index) {
            return right_answer(story, question, step);
        }
    }
    return {};
}

}  // namespace

const GivenAnswer* Predictions::given(int question) const {
    const auto found = given_.find(question);
    return found == given_.end() ? nullptr : &found->second;
}

float Predictions::height(const LessonUi& ui, const Box& scene) const {
    const Step& step = ui.session.step();
    if (!is_asked(step.kind) || ui.session.in_hand()) { return 0.0F; }
    const float margin = 2.0F * ui.px(kSheetMargin);
    if (step.kind == Step::Kind::question) {
        return ImGui::GetFrameHeightWithSpacing() * (objection_.empty() ? 1.0F : 2.0F) + ui.px(16.0F) +
               margin;
    }
    const GivenAnswer* const answer = given(step.question);
    if (answer == nullptr) { return 0.0F; }
    const float inner = scene.width - 2.0F * ui.px(kSheetMargin + 12.0F);
    return panels::paragraph_height(ui.canvas, ui.canvas.fonts().normal, verdict_text(*answer), inner) +
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
    if (step.kind == Step::Kind::question && !ui.session.in_hand()) {
        ask(ui, scene, step);
    } else if (step.kind == Step::Kind::answer && !ui.session.in_hand()) {
        compare(ui, scene, step);
    }
    if (step.kind != Step::Kind::question) { wants_focus_ = false; }
}

void Predictions::ask(const LessonUi& ui, const Box& scene, const Step& step) {
    const QuestionView& question = *ui.session.view().question;
    const Box sheet = sheet_of(ui, scene, height(ui, scene) - 2.0F * ui.px(kSheetMargin));
    panels::sheet(ui.canvas, sheet, theme::kPaper, theme::kAccent);
    const Area area(ui, "prediction", sheet);
    for (std::size_t k = 0; k < question.choices.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        if (ImGui::Button((" " + number + " ").c_str())) { take(ui, step, number); }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", math::plain_words(question.choices[k]).c_str());
        }
        ImGui::SameLine();
    }
    if (wants_focus_) { ImGui::SetKeyboardFocusHere(); }
    wants_focus_ = false;
    ImGui::SetNextItemWidth(ui.px(150.0F));
    const char* const hint = question.choices.empty() ? tr("your answer  (a)") : tr("or its number  (a)");
    const bool entered = ImGui::InputTextWithHint(
        "##answer", hint, field_.data(), field_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    if (!question.unit.empty()) {
        ImGui::SameLine();
        ImGui::TextUnformatted(question.unit.c_str());
    }
    ImGui::SameLine();
    const bool pressed = ImGui::Button(tr("Answer"));
    ImGui::SameLine();
    command_button(ui, Command::next, tr("Skip"));
    if (entered || pressed) { take(ui, step, field_.data()); }
    if (!objection_.empty()) { note(ui, objection_); }
}

/// Keeps an answer that is understood, and goes on.
void Predictions::take(const LessonUi& ui, const Step& step, const std::string& text) {
    // an empty field skips the question
    if (text.empty()) { return ui.requests.add(Command::next); }
    const QuestionView& question = *ui.session.view().question;
    GivenAnswer judged = judge_answer(question, right_answer_to(ui.session, step.question), text);
    if (!judged.understood) {
        objection_ = tr("'{0}' is no answer: {1}.", text, judged.note);
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
    const float inner = scene.width - 2.0F * ui.px(kSheetMargin + 12.0F);
    const Box sheet = sheet_of(ui, scene, height(ui, scene) - 2.0F * ui.px(kSheetMargin));
    panels::sheet(
        canvas, sheet, answer->right ? theme::kPaper : theme::kWarningShade,
        answer->right ? theme::kAccent : theme::kSubjectMark);
    panels::paragraph(
        canvas, {sheet.x + ui.px(12.0F), sheet.y + ui.px(8.0F), inner, sheet.height}, font, theme::kInk,
        text);
}

}  // namespace jw::host
