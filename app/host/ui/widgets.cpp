#include "app/host/ui/widgets.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

namespace theme = panels::theme;
using panels::Box;

ImVec4 vec(const render::Colour& c) { return {c.r, c.g, c.b, c.a}; }

ImVec4 vec(const Ui& ui, const render::Colour& c) { return vec(render::toned(c, ui.state.tone())); }

constexpr float kBarWidth = 6.0F;
constexpr float kLeastThumb = 24.0F;
constexpr float kNotch = 54.0F;  // three lines

/// The scroll bar at the right edge, and the part of it that shows the visible range.
struct Bar {
    Box track;
    Box thumb;
};

Bar bar_of(const Ui& ui, const Box& box, float height, float offset) {
    Bar bar;
    bar.track = {
        box.right() - ui.px(kBarWidth + 2.0F), box.y + ui.px(3.0F), ui.px(kBarWidth),
        box.height - ui.px(6.0F)};
    const float size = std::max(ui.px(kLeastThumb), bar.track.height * box.height / height);
    const float way = std::max(0.0F, bar.track.height - size);
    bar.thumb = {bar.track.x, bar.track.y + way * offset / (height - box.height), bar.track.width, size};
    return bar;
}

void handle_bar(const Ui& ui, const Box& box, float height, Scroll& scroll) {
    const ImGuiIO& io = ImGui::GetIO();
    const panels::Point mouse{io.MousePos.x, io.MousePos.y};
    const Bar bar = bar_of(ui, box, height, scroll.offset);
    const bool over = box.contains(mouse) && !io.WantCaptureMouse;
    if (over && io.MouseWheel != 0.0F) { scroll.offset -= io.MouseWheel * ui.px(kNotch); }
    const Box wide = panels::shrunk(bar.track, -ui.px(3.0F), 0.0F);
    if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && wide.contains(mouse)) { scroll.held = true; }
    scroll.held = scroll.held && io.MouseDown[0];
    if (scroll.held) {
        const float way = std::max(1.0F, bar.track.height - bar.thumb.height);
        const float part = (mouse.y - bar.track.y - 0.5F * bar.thumb.height) / way;
        scroll.offset = part * (height - box.height);
    }
}

}  // namespace

Area::Area(const Ui& ui, const char* name, const panels::Box& box, bool scrolls) {
    ImGui::SetNextWindowPos({box.x, box.y});
    ImGui::SetNextWindowSize({box.width, box.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(12.0F), ui.px(8.0F)});
    ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                             ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse;
    if (scrolls) { flags &= ~(ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse); }
    ImGui::Begin(name, nullptr, flags);
    ImGui::PopStyleVar();
}

Area::~Area() { ImGui::End(); }

void set_style(ImGuiStyle& style, float scale, bool dark, bool for_fingers) {
    style = ImGuiStyle();
    if (for_fingers) {
        style.FramePadding.y = 9.0F;
        style.ItemSpacing.y = 8.0F;
        style.TouchExtraPadding = {2.0F, 4.0F};
        style.GrabMinSize = 20.0F;
    }
    style.ScaleAllSizes(scale);
    style.WindowRounding = 0.0F;
    style.FrameRounding = 4.0F * scale;
    style.GrabRounding = 4.0F * scale;
    style.PopupRounding = 4.0F * scale;
    style.ScrollbarRounding = 4.0F * scale;
    style.WindowBorderSize = 0.0F;
    style.FrameBorderSize = 1.0F;
    style.AntiAliasedLinesUseTex = false;  // the font atlas has no baked lines
    const render::Tone tone = dark ? render::Tone::dark : render::Tone::light;
    const auto set = [&](ImGuiCol which, const render::Colour& colour) {
        style.Colors[which] = vec(render::toned(colour, tone));
    };
    set(ImGuiCol_Text, theme::kInk);
    set(ImGuiCol_TextDisabled, theme::kFaint);
    set(ImGuiCol_WindowBg, theme::kPaper);
    set(ImGuiCol_PopupBg, theme::kWhite);
    set(ImGuiCol_Border, theme::kLine);
    set(ImGuiCol_FrameBg, theme::kWhite);
    set(ImGuiCol_FrameBgHovered, theme::kShade);
    set(ImGuiCol_FrameBgActive, theme::kSubject);
    set(ImGuiCol_Button, theme::kShade);
    set(ImGuiCol_ButtonHovered, theme::kSubject);
    set(ImGuiCol_ButtonActive, theme::kSubjectMark);
    set(ImGuiCol_Header, theme::kSubject);
    set(ImGuiCol_HeaderHovered, theme::kShade);
    set(ImGuiCol_HeaderActive, theme::kSubject);
    set(ImGuiCol_CheckMark, theme::kAccent);
    set(ImGuiCol_SliderGrab,
        render::mix(theme::kAccent, theme::kWhite, 0.6F));  // light, because the number is drawn over it
    set(ImGuiCol_SliderGrabActive, theme::kSubjectMark);
    set(ImGuiCol_ScrollbarBg, theme::kPaper);
    set(ImGuiCol_ScrollbarGrab, theme::kLine);
    set(ImGuiCol_ScrollbarGrabHovered, theme::kFaint);
    set(ImGuiCol_ScrollbarGrabActive, theme::kSoft);
    set(ImGuiCol_Separator, theme::kLine);
    set(ImGuiCol_NavHighlight, theme::kAccent);
    set(ImGuiCol_TextSelectedBg, theme::kSubject);
    set(ImGuiCol_ModalWindowDimBg, render::with_alpha(theme::kInk, 0.35F));
}

bool is_for_fingers() { return ImGui::GetStyle().TouchExtraPadding.y > 0.0F; }

void command_button(const Ui& ui, Command command, const char* label, float width, float height) {
    ImGui::PushID(static_cast<int>(command));
    if (ImGui::Button(label, {width, height})) { ui.requests.add(command); }
    ImGui::PopID();
    tip_of_command(command);
}

void tip_of_command(Command command) {
    const CommandInfo& info = info_of(command);
    tip_of_item(std::string(tr(info.text)) + "  (" + tr(info.keys) + ")");
}

bool small_button(const char* label) {
    return is_for_fingers() ? ImGui::Button(label) : ImGui::SmallButton(label);
}

void tip_of_item(const std::string& text, float widest) {
    if (!ImGui::IsItemHovered()) { return; }
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::BeginTooltip();
    // measured from the left edge of the tip
    ImGui::PushTextWrapPos(std::min(widest, ImGui::GetIO().DisplaySize.x - 2.0F * style.WindowPadding.x));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool toggle_button(const Ui& ui, const char* label, bool on, float width) {
    if (on) {
        ImGui::PushStyleColor(ImGuiCol_Button, vec(ui, theme::kSubject));
        ImGui::PushStyleColor(ImGuiCol_Border, vec(ui, theme::kSubjectMark));
    }
    const bool pressed = ImGui::Button(label, {width, 0.0F});
    if (on) { ImGui::PopStyleColor(2); }
    return pressed;
}

void section(const Ui& ui, const char* title) {
    ImGui::Dummy({0.0F, ui.px(4.0F)});
    ImGui::PushFont(ui.canvas.fonts().bold);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(title);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::Separator();
}

void note(const Ui& ui, const std::string& text) {
    if (text.empty()) { return; }
    ImGui::PushFont(ui.canvas.fonts().small);
    ImGui::PushStyleColor(ImGuiCol_Text, vec(ui, theme::kSoft));
    // ImGui would break lines within numbers
    const float room = std::max(ui.px(60.0F), ImGui::GetContentRegionAvail().x);
    std::string lines;
    for (const std::string& line :
         panels::wrapped(*ui.canvas.fonts().small, panels::with_minus_signs(text), room)) {
        lines += (lines.empty() ? "" : "\n") + line;
    }
    ImGui::TextUnformatted(lines.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void beside_if_it_fits(const char* label, float step) {
    const float width = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
                        ImGui::CalcTextSize(label, nullptr, true).x;
    const float begin = ImGui::GetWindowPos().x + ImGui::GetStyle().WindowPadding.x;
    const float after = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x - begin;
    const float left = std::ceil(after / step) * step;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (begin + left + width <= right) { ImGui::SameLine(begin - ImGui::GetWindowPos().x + left); }
}

void width_beside_label(const Ui& ui, const char* label, float most) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(label).x -
                       ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(std::clamp(room, 1.0F, ui.px(most)));
}

panels::Box rest_of_column(const Ui& ui, const panels::Box& column, float least) {
    const float top = ImGui::GetCursorScreenPos().y + ui.px(6.0F);
    const float margin = ui.px(14.0F);
    const float bar = ImGui::GetScrollMaxY() > 0.0F ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    const float room = column.bottom() - top - ImGui::GetScrollY() - ui.px(10.0F);
    return {column.x + margin, top, column.width - 2.0F * margin - bar, std::max(ui.px(least), room)};
}

void end_column_at(const panels::Box& place) {
    ImGui::SetCursorScreenPos({place.x, place.y});
    ImGui::Dummy({1.0F, place.height});
}

void scrolled(
    const Ui& ui, const Box& box, float height, Scroll& scroll,
    const std::function<void(const panels::Canvas&, const Box&)>& draw) {
    if (height <= box.height) {
        scroll = {};
        return draw(ui.canvas, box);
    }
    scroll.most = height - box.height;
    scroll.offset += scroll.wanted * box.height;
    scroll.wanted = 0.0F;
    handle_bar(ui, box, height, scroll);
    scroll.offset = std::round(std::clamp(scroll.offset, 0.0F, height - box.height));
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({box.x, box.y}, {box.right(), box.bottom()}, true);
    draw(ui.canvas.within(box), {box.x, box.y - scroll.offset, box.width, height});
    const Bar bar = bar_of(ui, box, height, scroll.offset);
    ui.canvas.fill(bar.track, theme::kShade, 0.5F * bar.track.width);
    ui.canvas.fill(bar.thumb, scroll.held ? theme::kSoft : theme::kFaint, 0.5F * bar.thumb.width);
    list.PopClipRect();
}

}  // namespace jw::host
