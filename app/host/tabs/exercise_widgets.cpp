#include "app/host/tabs/exercise_tab.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/rich_text.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::host {

namespace {

using panels::Canvas;
namespace theme = panels::theme;

// digits shown of an entry: a student's numbers may have many more
constexpr int kEntryDigits = 6;
constexpr std::size_t kLongestAnswer = 200000;

/// Room for words between the cursor and the right edge.
float room_here(const Ui& ui) { return std::max(ui.px(60.0F), ImGui::GetContentRegionAvail().x); }

/// Draws at the cursor, and moves the cursor below.
void draw_here(
    const Ui& ui, const panels::RichText& rich, const ImFont* font, const render::Colour& colour,
    float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    panels::draw_rich(canvas, {at.x, at.y}, font, colour, rich);
    ImGui::Dummy({width, rich.height});
}

struct Field {
    std::string& text;
    Caret caret;
};

/// Callback of ImGui's field: lets the text grow as it is typed, and places the caret.
int follow_field(ImGuiInputTextCallbackData* data) {
    const Field& field = *static_cast<Field*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        field.text.resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = field.text.data();
    } else if (field.caret == Caret::over_all) {
        data->SelectAll();
    } else if (field.caret == Caret::at_end) {
        data->ClearSelection();
        data->CursorPos = data->BufTextLen;
    }
    return 0;
}

std::vector<std::vector<std::string>> cells_of(const MatrixX& value) {
    std::vector<std::vector<std::string>> cells(static_cast<std::size_t>(value.rows()));
    for (Eigen::Index r = 0; r < value.rows(); ++r) {
        for (Eigen::Index c = 0; c < value.cols(); ++c) {
            cells[static_cast<std::size_t>(r)].push_back(
                panels::with_minus_signs(number_text(value(r, c), kEntryDigits)));
        }
    }
    return cells;
}

std::vector<float> widths_of(const Ui& ui, const std::vector<std::vector<std::string>>& cells, float gap) {
    std::vector<float> widths(cells.front().size(), 0.0F);
    for (const auto& row : cells) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            const float width = ui.canvas.text_width(ui.canvas.fonts().normal, row[c]) + gap;
            widths[c] = std::max(widths[c], width);
        }
    }
    return widths;
}

void draw_bracket(const Canvas& canvas, const panels::Box& box, bool left) {
    const float x = left ? box.x : box.right();
    const float tick = canvas.px(4.0F) * (left ? 1.0F : -1.0F);
    canvas.line({x, box.y}, {x, box.bottom()}, theme::kInk);
    canvas.line({x, box.y}, {x + tick, box.y}, theme::kInk);
    canvas.line({x, box.bottom()}, {x + tick, box.bottom()}, theme::kInk);
}

}  // namespace

void rich_words(const Ui& ui, const std::string& text, const ImFont* font, const render::Colour& colour) {
    if (text.empty()) { return; }
    const float room = room_here(ui);
    panels::RichText rich = panels::layout_rich(ui.canvas.fonts(), *font, text, room);
    if (rich.width() > room + 0.5F && font != ui.canvas.fonts().small) {
        font = ui.canvas.fonts().small;
        rich = panels::layout_rich(ui.canvas.fonts(), *font, text, room);
    }
    if (rich.width() <= room + 0.5F) { return draw_here(ui, rich, font, colour, room); }
    const float height = rich.height + ImGui::GetStyle().ScrollbarSize + ui.px(2.0F);
    const ImGuiID id = ImGui::GetID(text.c_str());
    if (ImGui::BeginChild(id, {0.0F, height}, false, ImGuiWindowFlags_HorizontalScrollbar)) {
        draw_here(ui, rich, font, colour, rich.width());
    }
    ImGui::EndChild();
}

void marked_matrix(const Ui& ui, const MatrixX& value, const std::vector<std::vector<bool>>& marked) {
    if (value.size() == 0) { return; }
    const auto cells = cells_of(value);
    const std::vector<float> widths = widths_of(ui, cells, ui.px(16.0F));
    float width = ui.px(8.0F);
    for (const float w : widths) { width += w; }
    const float line = ui.canvas.line_height(ui.canvas.fonts().normal) + ui.px(2.0F);
    const float height = line * static_cast<float>(cells.size());
    const bool scrolls = width > room_here(ui);
    const float bar = scrolls ? ImGui::GetStyle().ScrollbarSize + ui.px(2.0F) : 0.0F;
    ImGui::BeginChild(
        "marked matrix", {0.0F, height + bar + ui.px(4.0F)}, false,
        scrolls ? ImGuiWindowFlags_HorizontalScrollbar : ImGuiWindowFlags_NoScrollbar);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const panels::Box box{at.x + 1.0F, at.y + 1.0F, width, height};
    for (std::size_t r = 0; r < cells.size(); ++r) {
        float x = box.x + ui.px(4.0F);
        const float y = box.y + line * static_cast<float>(r);
        for (std::size_t c = 0; c < cells[r].size(); ++c) {
            const bool wrong = !marked.empty() && marked[r][c];
            const panels::Box cell{x, y, widths[c], line};
            if (wrong) {
                canvas.fill(cell, theme::kWarningShade, ui.px(3.0F));
                canvas.outline(cell, theme::kRedundant, ui.px(1.0F), ui.px(3.0F));
            }
            canvas.text(
                {cell.right() - ui.px(8.0F), y + ui.px(1.0F)}, canvas.fonts().normal,
                wrong ? theme::kRedundant : theme::kInk, cells[r][c], panels::Align::right);
            x += widths[c];
        }
    }
    draw_bracket(canvas, box, true);
    draw_bracket(canvas, box, false);
    ImGui::Dummy({width + 2.0F, height + 2.0F});
    ImGui::EndChild();
}

bool text_field(
    const Ui& ui, const char* id, const char* hint, std::string& text, int lines, bool enter, Caret caret) {
    const std::string before = text;
    Field field{text, caret};
    ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackResize;
    if (caret != Caret::stays) { flags |= ImGuiInputTextFlags_CallbackAlways; }
    bool entered = false;
    if (lines <= 1) {
        ImGui::SetNextItemWidth(room_here(ui));
        entered =
            ImGui::InputTextWithHint(id, hint, text.data(), text.capacity() + 1, flags, follow_field, &field);
    } else {
        if (enter) { flags |= ImGuiInputTextFlags_CtrlEnterForNewLine; }
        const float height =
            ImGui::GetTextLineHeight() * static_cast<float>(lines) + 2.0F * ImGui::GetStyle().FramePadding.y;
        entered = ImGui::InputTextMultiline(
            id, text.data(), text.capacity() + 1, {room_here(ui), height}, flags, follow_field, &field);
    }
    // on Escape ImGui undoes the typing: keep the text
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) { text = before; }
    if (text.size() > kLongestAnswer) { text.resize(kLongestAnswer); }
    return entered;
}

void text_box(const Ui& ui, const char* id, const std::string& text, int most_lines) {
    const auto lines = static_cast<int>(std::ranges::count(text, '\n')) + 1;
    const float height = ImGui::GetTextLineHeight() * static_cast<float>(std::min(lines, most_lines)) +
                         ImGui::GetStyle().ScrollbarSize + 2.0F * ImGui::GetStyle().WindowPadding.y;
    if (ImGui::BeginChild(id, {room_here(ui), height}, true, ImGuiWindowFlags_HorizontalScrollbar)) {
        ImGui::TextUnformatted(text.c_str());
    }
    ImGui::EndChild();
}

void next_button(const char* label) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(label, nullptr, true).x + 2.0F * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) { ImGui::SameLine(); }
}

}  // namespace jw::host
