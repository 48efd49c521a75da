#include "app/panels/parts/tip.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/rich_text.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"

namespace jw::panels {

namespace {

constexpr float kPadding = 8.0F;
constexpr float kBetweenTipLines = 3.0F;
constexpr float kOff = 10.0F;         ///< distance from the subject of the tip
constexpr float kWidestTip = 640.0F;  ///< at 720

/// The first lines, as many as fit, and their size.
struct TipLines {
    std::vector<RichText> lines;
    float width = 0.0F;
    float height = 0.0F;
};

TipLines lines_in(const Canvas& canvas, const std::vector<std::string>& lines, float width, float height) {
    TipLines laid;
    for (const std::string& line : lines) {
        RichText text = layout_rich(canvas.fonts(), *canvas.fonts().small, with_minus_signs(line), width);
        const float gap = laid.lines.empty() ? 0.0F : canvas.px(kBetweenTipLines);
        if (text.width() > width || laid.height + gap + text.height > height) { continue; }
        laid.height += gap + text.height;
        laid.width = std::max(laid.width, std::ceil(text.width()));
        laid.lines.push_back(std::move(text));
    }
    return laid;
}

/// Place below the subject of the tip, else above it, else anywhere in `within`.
Box placed(const TipPlace& place, float width, float height, float off) {
    Box box{place.beside.x, place.beside.bottom() + off, width, height};
    if (box.bottom() > place.within.bottom()) {
        const float above = place.beside.y - off - height;
        box.y = above >= place.within.y ? above : place.within.bottom() - height;
    }
    box.x = std::max(place.within.x, std::min(box.x, place.within.right() - width));
    box.y = std::max(place.within.y, box.y);
    return box;
}

}  // namespace

Box draw_tip(const Canvas& canvas, const TipPlace& place, const std::vector<std::string>& lines) {
    const float padding = canvas.px(kPadding);
    const float widest = std::min(canvas.px(kWidestTip), place.within.width - 2.0F * padding);
    const TipLines laid = lines_in(canvas, lines, widest, place.within.height - 2.0F * padding);
    if (laid.lines.empty()) { return {}; }
    const Box box = placed(place, laid.width + 2.0F * padding, laid.height + 2.0F * padding, canvas.px(kOff));
    sheet(canvas, box, theme::kWhite, theme::kLine);
    float y = box.y + padding;
    for (const RichText& text : laid.lines) {
        draw_rich(canvas, {box.x + padding, y}, canvas.fonts().small, theme::kInk, text);
        y += text.height + canvas.px(kBetweenTipLines);
    }
    return box;
}

}  // namespace jw::panels
