#include "app/panels/column/failure_panel.hpp"

#include <imgui.h>

#include "app/panels/parts/theme.hpp"

namespace jw::panels {

float failure_panel(
    const Canvas& canvas, const Box& box, const std::string& title, const std::string& failure,
    Density density) {
    if (failure.empty()) { return 0.0F; }
    const render::Fonts& fonts = canvas.fonts();
    const float margin = canvas.px(12.0F);
    const float title_height = canvas.line_height(fonts.bold) + canvas.px(4.0F);
    const ImFont* const font = density == Density::roomy ? fonts.normal : fonts.small;
    const Box inner{
        box.x + margin + canvas.px(4.0F), box.y + margin, box.width - 2.0F * margin - canvas.px(4.0F), 0.0F};
    const Box words{inner.x, inner.y + title_height, inner.width, 0.0F};
    const std::size_t most = density >= Density::tight ? 6 : 12;
    const float text = paragraph(canvas.measuring(), words, font, theme::kInk, failure, most);
    const Box frame{box.x, box.y, box.width, title_height + text + 2.0F * margin};

    canvas.fill(frame, theme::kFailureShade, canvas.px(4.0F));
    canvas.fill({frame.x, frame.y, canvas.px(4.0F), frame.height}, theme::kRedundant);
    canvas.text({inner.x, inner.y}, fonts.bold, theme::kRedundant, title);
    paragraph(canvas, words, font, theme::kInk, failure, most);
    return frame.height;
}

}  // namespace jw::panels
