#include "app/panels/column/panels.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/theme.hpp"
#include "app/panels/plot/plot_axis.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr int kLowestPower = -16;  // smaller values are zero in double precision

/// Vertical place of a value; values beyond the axis are at its end.
float height_of(const Axis& axis, double value) {
    return axis.pixel(std::clamp(value, axis.range.from, axis.range.to));
}

int power_at(double value) { return static_cast<int>(std::lround(std::log10(value))); }

/// Draws lines and names of every few powers. @return the box that is left for the curve
Box draw_powers(const Canvas& canvas, const Box& box, const Axis& axis) {
    const ImFont* const small = canvas.fonts().small;
    const float left = box.x + canvas.px(38.0F);
    const float line = canvas.line_height(small);
    const float room = axis.start - axis.end;
    const int low = power_at(axis.range.from);
    const int high = power_at(axis.range.to);
    int step = 1;
    while (static_cast<float>(step) * room / static_cast<float>(high - low) < 1.3F * line) { ++step; }
    for (int power = high; power >= low; power -= step) {
        const float y = std::round(height_of(axis, std::pow(10.0, power)));
        canvas.fill({left, y, box.right() - left, 1.0F}, theme::kLine);
        canvas.text(
            {left - canvas.px(6.0F), y - 0.55F * line}, small, theme::kSoft, power_of_ten(power),
            Align::right);
    }
    return {left, axis.end, box.right() - left, room};
}

/// Text on a background of paper, so that lines do not run through it.
void draw_note(const Canvas& canvas, Point at, std::string_view text, Align align) {
    const ImFont* const small = canvas.fonts().small;
    const float width = canvas.text_width(small, text);
    const float left = align == Align::right ? at.x - width : at.x;
    const float margin = canvas.px(3.0F);
    canvas.fill({left - margin, at.y, width + 2.0F * margin, canvas.line_height(small)}, theme::kPaper);
    canvas.text({left, at.y}, small, theme::kRedundant, text);
}

void draw_threshold(const Canvas& canvas, const Box& plot, const Axis& axis, const RankView& rank) {
    if (!(rank.threshold > 0.0)) { return; }
    const float y = std::round(height_of(axis, rank.threshold));
    canvas.dashed_line({plot.x, y}, {plot.right(), y}, theme::kRedundant, hairline(canvas));
    const Point at{plot.x + canvas.px(8.0F), y - canvas.line_height(canvas.fonts().small) - 1.0F};
    draw_note(canvas, at, tr("threshold {0}", small_text(rank.threshold)), Align::left);
}

/// "1 of 18 is zero: rank 17", left of the first zero.
void draw_zero_label(const Canvas& canvas, Point at, std::size_t zeros, const RankView& rank) {
    const std::string text = tr_count(
        static_cast<int>(zeros), "{0} of {1} is zero: rank {2}", "{0} of {1} are zero: rank {2}",
        rank.singular_values.size(), rank.rank);
    const float line = canvas.line_height(canvas.fonts().small);
    draw_note(canvas, {at.x, at.y - 0.55F * line}, text, Align::right);
}

void draw_stem(const Canvas& canvas, Point tip, float bottom, float radius) {
    const Colour pale = render::with_alpha(theme::kAccent, 0.35F);
    canvas.line({tip.x, bottom}, tip, pale, std::max(1.0F, 0.5F * radius));
    canvas.disc(tip, radius, theme::kAccent);
}

}  // namespace

void singular_values_plot(const Canvas& canvas, const Box& box, const RankView& rank) {
    const float margin = 0.6F * canvas.line_height(canvas.fonts().small);
    // zeros are clearly below the threshold, whatever their size
    const int low =
        rank.threshold > 0.0 ? static_cast<int>(std::floor(std::log10(rank.threshold))) - 3 : kLowestPower;
    const Axis axis = axis_of_powers(rank.singular_values, low, box.bottom() - margin, box.y + margin);
    const Box plot = draw_powers(canvas, box, axis);

    const auto count = static_cast<float>(std::max<std::size_t>(1, rank.singular_values.size()));
    const float pitch = std::min(canvas.px(26.0F), (plot.width - canvas.px(12.0F)) / count);
    const float radius = std::clamp(0.36F * pitch, canvas.px(2.0F), canvas.px(4.0F));
    const auto at = [&](std::size_t k) {
        return Point{
            plot.x + canvas.px(6.0F) + pitch * (static_cast<float>(k) + 0.5F),
            height_of(axis, rank.singular_values[k])};
    };
    std::size_t zeros = 0;
    for (std::size_t k = 0; k < rank.singular_values.size(); ++k) {
        if (rank.singular_values[k] > rank.threshold) {
            draw_stem(canvas, at(k), plot.bottom(), radius);
        } else {
            ++zeros;
        }
    }
    draw_threshold(canvas, plot, axis, rank);
    for (std::size_t k = rank.singular_values.size() - zeros; k < rank.singular_values.size(); ++k) {
        canvas.disc(at(k), radius, theme::kPaper);
        canvas.ring(at(k), radius, theme::kRedundant, canvas.px(1.5F));
    }
    if (zeros > 0) {
        const Point first = at(rank.singular_values.size() - zeros);
        draw_zero_label(canvas, {first.x - radius - canvas.px(6.0F), first.y}, zeros, rank);
    }
}

void convergence_plot(const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows) {
    const float margin = 0.6F * canvas.line_height(canvas.fonts().small);
    std::vector<double> norms;
    for (const NewtonRow& row : rows) { norms.push_back(row.phi_norm); }
    // one axis for every iteration of every solve: quadratic convergence looks the same everywhere
    const Axis axis = axis_of_powers(norms, kLowestPower, box.bottom() - margin, box.y + margin);
    const Box plot = draw_powers(canvas, box, axis);
    const auto steps = static_cast<float>(std::max<std::size_t>(6, rows.size()));
    const auto at = [&](std::size_t k) {
        return Point{plot.x + plot.width * (static_cast<float>(k) + 0.5F) / steps, height_of(axis, norms[k])};
    };
    for (std::size_t k = 0; k + 1 < norms.size(); ++k) {
        canvas.line(at(k), at(k + 1), theme::kAccent, std::max(1.0F, canvas.px(1.6F)));
    }
    for (std::size_t k = 0; k < norms.size(); ++k) {
        const bool current = k + 1 == norms.size();
        canvas.disc(at(k), canvas.px(current ? 4.5F : 3.0F), current ? theme::kSubjectMark : theme::kAccent);
    }
}

}  // namespace jw::panels
