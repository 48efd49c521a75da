#include "app/panels/parts/parts.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/rich_text.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr float kLeastNote = 48.0F;

float heading_line(const Canvas& canvas, const Box& box) {
    return box.y + canvas.line_height(canvas.fonts().bold) + canvas.px(2.0F);
}

}  // namespace

float hairline(const Canvas& canvas) { return std::max(1.0F, std::floor(canvas.fonts().scale)); }

void sheet(const Canvas& canvas, const Box& box, Colour shade, Colour edge) {
    const float rounding = canvas.px(5.0F);
    canvas.fill(box, shade, rounding);
    canvas.outline(box, edge, hairline(canvas), rounding);
}

float heading_height(const Canvas& canvas) {
    return canvas.line_height(canvas.fonts().bold) + canvas.px(8.0F);
}

float heading(
    const Canvas& canvas, const Box& box, std::string_view symbol, std::string_view title,
    std::string_view note) {
    const Formula formula = layout_formula(symbol, formula_fonts(canvas.fonts()));
    const float baseline = box.y + std::round(canvas.fonts().bold->Ascent);
    draw_formula(canvas, {box.x, baseline}, formula, theme::kInk);
    const float shift = formula.width + canvas.px(4.0F);
    const float height = heading(canvas, {box.x + shift, box.y, box.width - shift, box.height}, title, note);
    canvas.fill({box.x, heading_line(canvas, box), shift, hairline(canvas)}, theme::kLine);
    return height;
}

float heading(const Canvas& canvas, const Box& box, std::string_view title, std::string_view note) {
    const ImFont* const bold = canvas.fonts().bold;
    const ImFont* const small = canvas.fonts().small;
    // the title has priority; a note that would be cut too short is left out
    const std::string name = shortened(*bold, title, box.width);
    const float room = box.width - canvas.text_width(bold, name) - canvas.px(12.0F);
    const std::string aside = room > canvas.px(kLeastNote) ? shortened(*small, note, room) : "";
    canvas.text({box.x, box.y}, bold, theme::kInk, name);
    const float drop = std::round(bold->Ascent) - std::round(small->Ascent);
    canvas.text({box.right(), box.y + drop}, small, theme::kSoft, aside, Align::right);
    canvas.fill({box.x, heading_line(canvas, box), box.width, hairline(canvas)}, theme::kLine);
    return heading_height(canvas);
}

float paragraph(
    const Canvas& canvas, const Box& box, const ImFont* font, Colour colour, std::string_view text,
    std::size_t most_lines) {
    const float line = canvas.line_height(font);
    if (math::has_marks(text)) {
        const float room = static_cast<float>(most_lines) * line;
        const RichText rich = layout_rich_to(canvas.fonts(), *font, text, box.width, room);
        draw_rich(canvas, {box.x, box.y}, font, colour, rich);
        return rich.height;
    }
    float y = box.y;
    for (const std::string& words : wrapped_to(*font, text, box.width, most_lines)) {
        canvas.text({box.x, y}, font, colour, words);
        y += line;
    }
    return y - box.y;
}

float paragraph_height(const Canvas& canvas, const ImFont* font, std::string_view text, float width) {
    if (math::has_marks(text)) { return layout_rich(canvas.fonts(), *font, text, width).height; }
    return static_cast<float>(wrapped(*font, text, width).size()) * canvas.line_height(font);
}

std::string live_text(double value) {
    // four decimals show nothing of a smaller value
    constexpr double kSmallest = 5e-4;
    constexpr double kLargest = 1e4;
    constexpr double kRounding = 1e-15;  // of an equation in metres and radians
    const double size = std::abs(value);
    if (size < kRounding) { return "0"; }
    if (!(size >= kSmallest && size < kLargest)) { return small_text(value); }
    return fixed_text(value, 4);
}

std::string column_text(double value, int decimals) {
    const double size = std::abs(value);
    if (!(size < 1e5)) { return small_text(value); }
    const int digits_before = size < 100.0 ? 2 : (size < 1000.0 ? 3 : 4);
    return fixed_text(value, std::max(0, decimals + 2 - digits_before));
}

}  // namespace jw::panels
