#include <cmath>

#include <imgui.h>

#include "app/panels/column/panels.hpp"
#include "app/panels/parts/formula.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

// about the reciprocal of a component that is zero except for rounding
constexpr double kInfinite = 1e12;

/// "|s_x| ▬▬▬▬── 0.816"
void draw_size(const Canvas& canvas, const Box& cell, int component, double size, bool dropped) {
    const ImFont* const small = canvas.fonts().small;
    const Formula name =
        layout_formula(std::string("|s_") + axis_name(component) + "|", small_formula_fonts(canvas.fonts()));
    const float baseline = cell.y + std::round(small->Ascent);
    draw_formula(canvas, {cell.x, baseline}, name, theme::kInk);

    const std::string number = fixed_text(size, 3);
    const float left = cell.x + canvas.px(34.0F);
    // with large text in a narrow column, the bar is short
    const float room = cell.right() - left - canvas.text_width(small, number) - canvas.px(12.0F);
    const float width = std::clamp(room, 0.0F, canvas.px(58.0F));
    const float height = canvas.px(9.0F);
    const float top = std::round(cell.y + 0.5F * (canvas.line_height(small) - height));
    const auto filled = static_cast<float>(std::min(1.0, size)) * width;
    canvas.fill({left, top, width, height}, theme::kShade);
    canvas.fill({left, top, std::round(filled), height}, dropped ? theme::kAccent : theme::kFaint);
    if (width > 0.0F) { canvas.outline({left, top, width, height}, theme::kLine); }
    canvas.text(
        {left + width + canvas.px(width > 0.0F ? 6.0F : 0.0F), cell.y}, small,
        dropped ? theme::kInk : theme::kSoft, number);
}

/// "without x: κ = 1.15"
void draw_condition(const Canvas& canvas, const Box& cell, int component, double condition, bool dropped) {
    const ImFont* const small = canvas.fonts().small;
    const std::string value = "κ = " + (condition > kInfinite ? std::string("∞") : number_text(condition, 3));
    const std::string whole = tr("without {0}: {1}", axis_name(component), value);
    const bool fits = canvas.text_width(small, whole) < cell.width - canvas.px(6.0F);
    canvas.text({cell.x, cell.y}, small, dropped ? theme::kInk : theme::kSoft, fits ? whole : value);
}

}  // namespace

float choice_table(const Canvas& canvas, const Box& box, const ChoiceView& choice, Density density) {
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    float height = canvas.px(density >= Density::tight ? 1.0F : 4.0F);
    for (int k = 0; k < 3; ++k) {
        const Box cell = column_of({box.x, box.y + height, box.width, 2.0F * line}, k, 3);
        const auto axis = static_cast<std::size_t>(k);
        const bool dropped = choice.dropped == k;
        if (dropped) {
            const float margin = canvas.px(4.0F);
            canvas.fill(
                {cell.x - margin, cell.y - 1.0F, cell.width - margin, 2.0F * line + 2.0F}, theme::kSubject,
                canvas.px(3.0F));
        }
        draw_size(canvas, cell, k, choice.axis_size[axis], dropped);
        draw_condition(
            canvas, {cell.x, cell.y + line, cell.width, line}, k, choice.pair_condition[axis], dropped);
    }
    height += 2.0F * line;
    if (density >= Density::tight) { return height + canvas.px(2.0F); }
    height += canvas.px(5.0F);
    const Box below{box.x, box.y + height, box.width, 0.0F};
    const std::size_t lines = density == Density::roomy ? 5 : 3;
    const Colour ink = choice.switched ? theme::kWarning : theme::kSoft;
    return height + paragraph(canvas, below, small, ink, choice.reason, lines);
}

}  // namespace jw::panels
