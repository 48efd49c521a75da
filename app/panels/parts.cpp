#include "app/panels/parts.hpp"

#include <cmath>

#include <imgui.h>

#include "app/panels/text.hpp"
#include "app/panels/theme.hpp"
#include "app/session/numbers.hpp"

namespace jw::panels {

float heading(const Canvas& canvas, const Box& box, std::string_view title, std::string_view note) {
    const ImFont* const bold = canvas.fonts().bold;
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(bold);
    const float room = box.width - canvas.text_width(small, note) - canvas.px(note.empty() ? 0.0F : 12.0F);
    canvas.text({box.x, box.y}, bold, theme::kInk, shortened(*bold, title, room));
    const float drop = std::round(bold->Ascent) - std::round(small->Ascent);
    canvas.text({box.right(), box.y + drop}, small, theme::kSoft, note, Align::right);
    const float y = box.y + line + canvas.px(2.0F);
    canvas.fill({box.x, y, box.width, std::max(1.0F, canvas.px(1.0F))}, theme::kLine);
    return line + canvas.px(8.0F);
}

float paragraph(
    const Canvas& canvas, const Box& box, const ImFont* font, Colour colour, std::string_view text,
    std::size_t most_lines) {
    const float line = canvas.line_height(font);
    float y = box.y;
    for (const std::string& words : wrapped_to(*font, text, box.width, most_lines)) {
        canvas.text({box.x, y}, font, colour, words);
        y += line;
    }
    return y - box.y;
}

std::string live_text(double value) {
    // four decimals say nothing about what is smaller
    constexpr double kSmallest = 5e-4;
    constexpr double kLargest = 1e4;
    const double size = std::abs(value);
    if (value != 0.0 && (size < kSmallest || size >= kLargest)) { return small_text(value); }
    return fixed_text(value, 4);
}

std::string column_text(double value) {
    const double size = std::abs(value);
    if (!(size < 1e5)) { return small_text(value); }
    return fixed_text(value, size < 100.0 ? 3 : (size < 1000.0 ? 2 : 1));
}

}  // namespace jw::panels
