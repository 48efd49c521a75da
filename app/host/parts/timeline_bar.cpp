#include "app/host/parts/timeline_bar.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/host/parts/bar_buttons.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::host {

namespace {

using panels::Box;
using panels::Canvas;
using panels::Point;
namespace theme = panels::theme;

/// Draws the mark of a step. The shapes differ as well as the colours: a square for an addition, a dot for an
/// iteration, a ring for closed, × for failed.
void draw_mark(const Canvas& canvas, Point at, Step::Kind kind, bool present) {
    const float size = canvas.px(present ? 9.0F : 6.0F);
    const render::Colour ink = present ? theme::kSubjectMark : theme::kSoft;
    switch (kind) {
        case Step::Kind::bodies:
        case Step::Kind::equations: canvas.square(at, size, ink, true); break;
        case Step::Kind::iteration: canvas.disc(at, 0.36F * size, ink); break;
        case Step::Kind::assembled: canvas.ring(at, 0.5F * size, ink, std::max(1.0F, canvas.px(1.6F))); break;
        case Step::Kind::failed: {
            const float half = 0.5F * size;
            const float thick = canvas.px(2.0F);
            canvas.line({at.x - half, at.y - half}, {at.x + half, at.y + half}, theme::kRedundant, thick);
            canvas.line({at.x - half, at.y + half}, {at.x + half, at.y - half}, theme::kRedundant, thick);
            break;
        }
        // these marks have no letters, because marks are close together
        case Step::Kind::question: canvas.square(at, size, ink, false); break;
        case Step::Kind::answer: canvas.disc(at, 0.5F * size, ink); break;
        case Step::Kind::motion: break;
    }
}

/// A word for bodies and motion, the name for joints and drivers.
std::string shown_name(const Stretch& stretch) {
    if (stretch.kind == Step::Kind::motion) { return tr("motion"); }
    return stretch.kind == Step::Kind::bodies ? tr("bodies") : stretch.name;
}

void draw_stretch(
    const Canvas& canvas, const Box& box, const Story& story, const Stretch& stretch,
    const TimelineScale& scale, std::size_t index, int present) {
    const ImFont* const small = canvas.fonts().small;
    const float left = scale.left_of(index);
    const float right = scale.right_of(index);
    const bool here = present >= stretch.first && present <= stretch.last;
    const float middle = box.bottom() - canvas.px(13.0F);
    if (here) {
        canvas.fill({left + 1.0F, box.y, right - left - 2.0F, box.height}, theme::kSubject, canvas.px(3.0F));
    }
    if (index > 0) {
        canvas.fill({left, box.y + canvas.px(4.0F), 1.0F, box.height - canvas.px(8.0F)}, theme::kLine);
    }
    const float room = right - left - canvas.px(8.0F);
    const std::string name = panels::shortened_name(*small, shown_name(stretch), room);
    // a name that does not fit at all is only in the tip
    if (canvas.text_width(small, name) <= room) {
        canvas.text(
            {left + canvas.px(5.0F), box.y + canvas.px(2.0F)}, small, here ? theme::kInk : theme::kSoft,
            name);
    }
    if (stretch.kind == Step::Kind::motion) {
        const float thick = canvas.px(4.0F);
        const float from = scale.x_of(stretch.first);
        const float to = scale.x_of(stretch.last);
        canvas.fill({from, middle - 0.5F * thick, to - from, thick}, theme::kLine, 0.5F * thick);
        if (here) {
            const float x = scale.x_of(present);
            canvas.fill({from, middle - 0.5F * thick, x - from, thick}, theme::kAccent, 0.5F * thick);
            canvas.disc({x, middle}, canvas.px(6.0F), theme::kAccent);
        }
        for (int k = stretch.first; k <= stretch.last; ++k) {
            const Step& step = story.steps()[static_cast<std::size_t>(k)];
            if (!step.rows_switched && !step.change_point && !step.failed()) { continue; }
            const float x = scale.x_of(k);
            const render::Colour ink = step.failed() ? theme::kRedundant : theme::kSoft;
            canvas.fill(
                {x - 0.5F, middle - canvas.px(7.0F), std::max(1.0F, canvas.px(1.5F)), canvas.px(14.0F)}, ink);
        }
        return;
    }
    for (int k = stretch.first; k <= stretch.last; ++k) {
        draw_mark(
            canvas, {scale.x_of(k), middle}, story.steps()[static_cast<std::size_t>(k)].kind, k == present);
    }
}

/// Handles clicks and drags on the line, and the wheel, which steps.
void scrub(
    const LessonUi& ui, const Box& box, const std::vector<Stretch>& stretches, const TimelineScale& scale) {
    ImGui::SetCursorScreenPos({box.x, box.y});
    ImGui::InvisibleButton("timeline", {std::max(1.0F, box.width), std::max(1.0F, box.height)});
    const float x = ImGui::GetIO().MousePos.x;
    if (ImGui::IsItemActive()) {
        ui.state.playback.pause();
        ui.requests.add(GoTo{scale.step_at(x)});
    }
    if (!ImGui::IsItemHovered()) { return; }
    if (const float notches = ImGui::GetIO().MouseWheel; notches != 0.0F) {
        ui.requests.add(notches < 0.0F ? Command::next : Command::back);
    }
    const int step = scale.step_at(x);
    const auto here =
        std::ranges::find_if(stretches, [&](const Stretch& s) { return step >= s.first && step <= s.last; });
    if (here == stretches.end()) { return; }
    std::string tip = tr("{0}, step {1}", shown_name(*here), step + 1);
    if (here->kind == Step::Kind::motion) {
        const Step& moment = ui.session.story().steps()[static_cast<std::size_t>(step)];
        tip = tr("{0}, t = {1} s", tip, fixed_text(moment.t, 3));
        if (moment.rows_switched) { tip = tr("{0}, another pair of equations", tip); }
        if (moment.change_point) { tip = tr("{0}, change point", tip); }
    }
    tip_of_item(tip);
}

/// Height of the line in an upright window: names above marks.
constexpr float kLineHeight = 40.0F;

/// Width of the buttons at the right end, with a gap.
constexpr float kRightButtons = 178.0F;

void right_buttons(const LessonUi& ui, const Box& box, float top) {
    ImGui::SetCursorScreenPos({box.right() - ui.px(kRightButtons - 10.0F), box.y + top});
    buttons_beside_line(ui, false);
}

/// Distance of the buttons from the upper edge of the bar; high buttons for fingers are centred.
float top_of_buttons(const Ui& ui, const Box& bar) {
    const float usual = ImGui::GetCursorPosY() + ui.px(4.0F);
    return std::round(std::min(usual, 0.5F * (bar.height - ImGui::GetFrameHeight())));
}

/// Draws the steps of the lesson on a line for jumping and scrubbing.
void line_of_steps(const LessonUi& ui, const Box& line) {
    const std::vector<Stretch> stretches = stretches_of(ui.session.story());
    const TimelineScale scale(stretches, line.x, line.width);
    for (std::size_t k = 0; k < stretches.size(); ++k) {
        draw_stretch(ui.canvas, line, ui.session.story(), stretches[k], scale, k, ui.session.index());
    }
    scrub(ui, line, stretches, scale);
}

/// Parts of the bar of an upright window: the line above the buttons.
struct UprightBar {
    Box line;
    Box buttons;
};

UprightBar places_in(const Ui& ui, const Box& bar) {
    Box rest = panels::shrunk(bar, ui.px(8.0F), ui.px(3.0F));
    UprightBar places;
    places.line = panels::cut_top(rest, ui.px(kLineHeight));
    panels::cut_top(rest, ui.px(4.0F));
    places.buttons = rest;
    // room for the line below the play button that shows the time until the next still
    places.buttons.height -= ui.px(4.0F);
    return places;
}

void draw_bar(const Canvas& canvas, const Box& box) {
    canvas.fill(box, theme::kPaper);
    canvas.fill({box.x, box.y, box.width, 1.0F}, theme::kLine);
}

}  // namespace

TimelineScale::TimelineScale(const std::vector<Stretch>& stretches, float left, float width)
    : stretches_(&stretches) {
    // a dot needs some room, a moment of the motion very little. The whole motion gets at most the room of
    // all stretches before it, because their names would be cut otherwise
    double total = 0.0;
    std::vector<double> shares;
    for (const Stretch& s : stretches) {
        const double count = s.last - s.first + 1;
        const auto letters = static_cast<double>(s.name.size());
        const bool moves = s.kind == Step::Kind::motion;
        const double steps = moves ? std::min(8.0 + 0.15 * count, std::max(total, 8.0)) : 2.0 + count;
        shares.push_back(std::max(steps, std::min(1.1 * letters, 8.0)));
        total += shares.back();
    }
    edges_.push_back(left);
    double sum = 0.0;
    for (const double share : shares) {
        sum += share;
        edges_.push_back(left + width * static_cast<float>(sum / total));
    }
}

float TimelineScale::x_of(int step) const {
    for (std::size_t k = 0; k < stretches_->size(); ++k) {
        const Stretch& s = (*stretches_)[k];
        if (step < s.first || step > s.last) { continue; }
        const auto count = static_cast<float>(s.last - s.first + 1);
        const float part = (static_cast<float>(step - s.first) + 0.5F) / count;
        return edges_[k] + part * (edges_[k + 1] - edges_[k]);
    }
    return edges_.front();
}

int TimelineScale::step_at(float x) const {
    for (std::size_t k = 0; k < stretches_->size(); ++k) {
        const Stretch& s = (*stretches_)[k];
        if (x >= edges_[k + 1] && k + 1 < stretches_->size()) { continue; }
        const float part = (x - edges_[k]) / std::max(1.0F, edges_[k + 1] - edges_[k]);
        const auto count = static_cast<float>(s.last - s.first + 1);
        const int at = static_cast<int>(std::floor(std::clamp(part, 0.0F, 1.0F) * count));
        return std::clamp(s.first + at, s.first, s.last);
    }
    return 0;
}

void timeline_bar(const LessonUi& ui, const panels::FrameLayout& layout) {
    const Canvas& canvas = ui.canvas;
    const Box& box = layout.bar;
    draw_bar(canvas, box);
    Area area(ui, "timeline bar", box);
    if (layout.upright) {
        const UprightBar places = places_in(ui, box);
        line_of_steps(ui, places.line);
        return row_of_buttons(ui, places.buttons, true);
    }
    const float top = top_of_buttons(ui, box);
    ImGui::SetCursorPosY(top);
    buttons_beside_line(ui, true);
    ImGui::SameLine(0.0F, ui.px(12.0F));

    const float left = ImGui::GetCursorScreenPos().x;
    const float right = box.right() - ui.px(kRightButtons);
    line_of_steps(ui, {left, box.y + ui.px(6.0F), std::max(10.0F, right - left), box.height - ui.px(12.0F)});
    right_buttons(ui, box, top);
}

void bar_of_figure(const LessonUi& ui, const panels::FrameLayout& layout) {
    const Box& box = layout.bar;
    draw_bar(ui.canvas, box);
    Area area(ui, "timeline bar", box);
    const float top = top_of_buttons(ui, box);
    const ImFont* const small = ui.canvas.fonts().small;
    const std::string words =
        tr("The lesson is at step {0} of {1}: open another tab to see it.", ui.session.index() + 1,
           ui.session.story().steps().size());
    const float left = box.x + ui.px(theme::kMargin);
    if (layout.upright) {
        const UprightBar places = places_in(ui, box);
        panels::paragraph(ui.canvas, places.line, small, theme::kSoft, words, 2);
        return row_of_buttons(ui, places.buttons, false);
    }
    const float room = box.right() - ui.px(kRightButtons) - left;
    const float y = box.y + 0.5F * (box.height - ui.canvas.line_height(small));
    ui.canvas.text({left, y}, small, theme::kSoft, panels::shortened(*small, words, room));
    right_buttons(ui, box, top);
}

}  // namespace jw::host
