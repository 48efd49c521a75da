#include "app/host/parts/notice.hpp"

#include <algorithm>
#include <limits>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

namespace theme = panels::theme;
using panels::Box;
using panels::Canvas;

constexpr double kNoticeSeconds = 6.0;
constexpr float kWaitingWidth = 380.0F;

/// Draws text on a sheet at the foot of the 3D picture. @return the foot for the next sheet, above this one
float draw_sheet(
    const Canvas& canvas, const Box& scene, float bottom, const std::string& text, bool is_error) {
    const ImFont* const font = is_error ? canvas.fonts().mono : canvas.fonts().normal;
    const float margin = canvas.px(12.0F);
    const Box room{scene.x + canvas.px(16.0F), 0.0F, scene.width - canvas.px(32.0F), scene.height};
    const Box inner{room.x + margin, 0.0F, room.width - 2.0F * margin, room.height};
    const std::size_t most = is_error ? 14 : 3;
    const float height = panels::paragraph(canvas.measuring(), inner, font, theme::kInk, text, most);
    const Box sheet{
        room.x, bottom - height - 2.0F * canvas.px(8.0F), room.width, height + 2.0F * canvas.px(8.0F)};
    panels::sheet(
        canvas, sheet, is_error ? theme::kFailureShade : theme::kWarningShade,
        is_error ? theme::kRedundant : theme::kSubjectMark);
    panels::paragraph(
        canvas, {inner.x, sheet.y + canvas.px(8.0F), inner.width, height}, font, theme::kInk, text, most);
    return sheet.y - canvas.px(6.0F);
}

}  // namespace

void Notice::say(const std::string& message) {
    if (message.empty()) { return; }
    text_ = message;
    seconds_left_ = kNoticeSeconds;
}

void Notice::blame_address(const std::string& why) {
    mistakes_ = tr("This address cannot be opened: {0}", why);
    are_of_file_ = false;
}

bool Notice::advance(double seconds) {
    if (text_.empty()) { return false; }
    seconds_left_ -= seconds;
    if (seconds_left_ > 0.0) { return false; }
    text_.clear();
    return true;
}

double Notice::seconds_left() const {
    return text_.empty() ? std::numeric_limits<double>::infinity() : seconds_left_;
}

void Notice::draw(const Ui& ui, const Box& scene, bool has_lesson) const {
    float bottom = scene.bottom() - ui.px(10.0F);
    const Canvas canvas(ImGui::GetForegroundDrawList(), ui.canvas);
    if (!text_.empty()) { bottom = draw_sheet(canvas, scene, bottom, text_, false); }
    if (mistakes_.empty()) { return; }
    const std::string kept =
        has_lesson && are_of_file_
            ? tr("The file has mistakes; the last version without mistakes is shown.") + std::string("\n")
            : "";
    draw_sheet(canvas, scene, bottom, kept + mistakes_, true);
}

float badge_height(const Ui& ui) { return ui.canvas.line_height(ui.canvas.fonts().normal) + ui.px(32.0F); }

void draw_badge(const Ui& ui, const Box& scene, float foot) {
    const Canvas& canvas = ui.canvas;
    const ImFont* const font = canvas.fonts().normal;
    const std::string text = tr("not the step's pose   ·   Escape goes back");
    const Box badge{
        scene.x + canvas.px(12.0F), scene.y + scene.height - foot - badge_height(ui) + canvas.px(12.0F),
        canvas.text_width(font, text) + canvas.px(20.0F), canvas.line_height(font) + canvas.px(8.0F)};
    panels::sheet(canvas, badge, theme::kWarningShade, theme::kSubjectMark);
    canvas.text({badge.x + canvas.px(10.0F), badge.y + canvas.px(4.0F)}, font, theme::kInk, text);
}

const char* words_of_waiting() { return tr("Solving the lesson, joint by joint …"); }

bool waiting_sheet(const Ui& ui, const Box& room, double part) {
    const float width = std::min(ui.px(kWaitingWidth), room.width);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float margin = ui.px(14.0F);
    const float height = 2.0F * (line + ImGui::GetStyle().ItemSpacing.y + margin) + ImGui::GetFrameHeight();
    const Box sheet{
        room.x + 0.5F * (room.width - width), room.y + 0.5F * (room.height - height), width, height};
    ImGui::SetNextWindowPos({sheet.x, sheet.y});
    ImGui::SetNextWindowSize({sheet.width, sheet.height});
    // above the widgets of the lesson that is still shown; but a slider that is held must stay held
    if (!ImGui::IsAnyItemActive()) { ImGui::SetNextWindowFocus(); }
    ImGui::Begin(
        "waiting", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::SetCursorPos({margin, margin});
    ImGui::BeginGroup();
    const Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const float line_width = ui.px(1.0F);
    const Box inside{
        sheet.x + line_width, sheet.y + line_width, sheet.width - 2.0F * line_width,
        sheet.height - 2.0F * line_width};
    panels::sheet(canvas, inside, theme::kWhite, theme::kAccent);
    ImGui::TextUnformatted(words_of_waiting());
    ImGui::ProgressBar(static_cast<float>(part), {width - 2.0F * margin, line});
    const bool pressed = ImGui::Button(tr("Stop"));
    if (!is_for_fingers()) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(tr("or press Escape; the open lesson stays"));
    }
    ImGui::EndGroup();
    ImGui::End();
    return pressed;
}

}  // namespace jw::host
