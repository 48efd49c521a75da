#include "app/panels/column/direction_sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <imgui.h>

#include "app/panels/parts/formula.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr double kAxisLength = 1.22;  // in radii
constexpr double kLetterAt = 1.36;    // in radii
constexpr float kRoomAround = 1.46F;  // in radii, from the centre to the edge of the box
constexpr float kWide = 1.6F;         // width over height of a box with text beside the sphere
constexpr float kMostWords = 0.45F;   // of the height of a box with text below the sphere
constexpr double kNearRim = 0.3;      // names keep off the rim, where the surface is seen edge-on

/// Texts that are already placed; a new one must not overlap them, and must stay within `bounds`.
class Labels {
public:
    Labels(const Canvas& canvas, const Box& bounds) : canvas_(canvas), bounds_(bounds) {}

    const Box& bounds() const { return bounds_; }

    void keep_clear(const Box& box) { taken_.push_back(box); }
    bool is_free(const Box& box) const {
        return bounds_.contains(box) &&
               std::ranges::none_of(taken_, [&](const Box& b) { return overlap(b, box); });
    }

    bool try_text(Point centre, Colour colour, const std::string& text) {
        const ImFont* const small = canvas_.fonts().small;
        const float width = canvas_.text_width(small, text) + canvas_.px(4.0F);
        const float height = canvas_.line_height(small);
        const Box box{centre.x - 0.5F * width, centre.y - 0.5F * height, width, height};
        if (!is_free(box)) { return false; }
        taken_.push_back(box);
        canvas_.fill(box, render::with_alpha(theme::kPaper, 0.8F), canvas_.px(3.0F));
        canvas_.text({centre.x, box.y}, small, colour, text, Align::centre);
        return true;
    }

private:
    const Canvas& canvas_;
    Box bounds_;
    std::vector<Box> taken_;
};

void draw_run(const Canvas& canvas, const std::vector<Point>& run, Colour colour, float width) {
    for (std::size_t k = 1; k < run.size(); ++k) {
        const Point a = run[k - 1];
        const Point b = run[k];
        canvas.line({a.x - 0.5F, a.y - 0.5F}, {b.x - 0.5F, b.y - 0.5F}, colour, width);
    }
}

void draw_lines(const Canvas& canvas, const SphereView& view, const std::vector<SphereLine>& lines) {
    const float thin = std::max(1.0F, 1.1F * canvas.fonts().scale);
    for (const SphereLine& line : lines) {
        for (const auto& run : front_of(view, line.points)) {
            switch (line.kind) {
                case SphereLine::Kind::contour:
                    draw_run(canvas, run, render::with_alpha(theme::kInk, 0.45F), thin);
                    break;
                case SphereLine::Kind::border: draw_run(canvas, run, theme::kInk, 1.8F * thin); break;
                case SphereLine::Kind::lost: draw_run(canvas, run, theme::kRedundant, 3.2F * thin); break;
            }
        }
    }
}

/// Writes the name of each line where the line is seen best and the place is free.
void name_lines(const SphereView& view, const std::vector<SphereLine>& lines, Labels& labels) {
    for (const SphereLine& line : lines) {
        if (line.label.empty()) { continue; }
        std::vector<Vec3> places;
        for (const Vec3& d : line.points) {
            if (d.dot(view.towards) > kNearRim) { places.push_back(d); }
        }
        // names of neighbouring contours are side by side, in a row towards the lower right
        const Vec3 aside = (view.towards + 0.45 * view.right - 0.35 * view.up).normalized();
        std::ranges::sort(places, std::greater<>(), [&](const Vec3& d) { return d.dot(aside); });
        const Colour ink = line.kind == SphereLine::Kind::lost ? theme::kRedundant : theme::kInk;
        for (std::size_t k = 0; k < places.size(); k += 3) {
            if (labels.try_text(view.pixel(places[k]), ink, line.label)) { break; }
        }
    }
}

/// Writes the labels of the rule: the component whose equation is left out in each cap, and the worst value,
/// at a corner.
void name_caps(const SphereView& view, Labels& labels) {
    for (int k = 0; k < 3; ++k) {
        const Vec3 pole = (view.faces(Vec3::Unit(k)) ? 1.0 : -1.0) * Vec3::Unit(k);
        if (pole.dot(view.towards) < kNearRim) { continue; }
        const Vec3 below = (pole - 0.28 * view.up).normalized();
        labels.try_text(view.pixel(below), theme::kInk, tr("without {0}", axis_name(k)));
    }
    Vec3 corner = Vec3::Ones() / std::numbers::sqrt3;
    for (int k = 0; k < 3; ++k) { corner(k) = std::copysign(corner(k), view.towards(k)); }
    const Point at = view.pixel(corner);
    labels.try_text({at.x, at.y + 0.12F * view.radius}, theme::kInk, "0.577");
}

void draw_arrow_head(const Canvas& canvas, Point tip, Point from, Colour colour) {
    const float length = std::hypot(tip.x - from.x, tip.y - from.y);
    if (length < 1.0F) { return; }
    const Point u{(tip.x - from.x) / length, (tip.y - from.y) / length};
    const float size = canvas.px(7.0F);
    const Point base{tip.x - size * u.x, tip.y - size * u.y};
    const float half = 0.45F * size;
    const std::array<Point, 3> corners{
        tip, Point{base.x - half * u.y, base.y + half * u.x},
        Point{base.x + half * u.y, base.y - half * u.x}};
    canvas.gradient_mesh(corners, std::array{colour, colour, colour}, std::array<unsigned short, 3>{0, 1, 2});
}

void draw_letter(const Canvas& canvas, Point at, Colour colour, const std::string& text, Labels& labels) {
    const ImFont* const bold = canvas.fonts().bold;
    const float line = canvas.line_height(bold);
    canvas.text({at.x, at.y - 0.5F * line}, bold, colour, text, Align::centre);
    labels.keep_clear({at.x - 0.5F * line, at.y - 0.5F * line, line, line});
}

/// Draws the axes that point away. It is called before the sphere is drawn, which hides parts of them.
void draw_axes_behind(const Canvas& canvas, const SphereView& view, Labels& labels) {
    for (int k = 0; k < 3; ++k) {
        const Vec3 d = Vec3::Unit(k);
        if (view.faces(d)) { continue; }
        const Colour colour = theme::palette::kAxes[static_cast<std::size_t>(k)];
        const Point tip = view.pixel(d, kAxisLength);
        canvas.line(view.centre, tip, colour, std::max(1.0F, canvas.px(2.0F)));
        draw_arrow_head(canvas, tip, view.centre, colour);
        const Point at = view.pixel(d, kLetterAt);
        if (std::hypot(at.x - view.centre.x, at.y - view.centre.y) > 1.1F * view.radius) {
            draw_letter(canvas, at, colour, axis_name(k), labels);
        }
    }
}

constexpr float kClearOfPresent = 9.0F;  // the current direction may be at the foot of an axis

/// Draws the axes that point towards the eye, and the other ends of those that do not.
void draw_axes_before(const Canvas& canvas, const SphereView& view, Labels& labels) {
    const float line = canvas.line_height(canvas.fonts().bold);
    for (int k = 0; k < 3; ++k) {
        const bool front = view.faces(Vec3::Unit(k));
        const Vec3 d = (front ? 1.0 : -1.0) * Vec3::Unit(k);
        const Colour colour = theme::palette::kAxes[static_cast<std::size_t>(k)];
        const Point foot = view.pixel(d);
        canvas.disc(foot, canvas.px(3.0F), colour);
        if (!front) {
            draw_letter(
                canvas, {foot.x, foot.y - 0.5F * line - canvas.px(kClearOfPresent)}, colour,
                std::string("−") + axis_name(k), labels);
            continue;
        }
        const Point tip = view.pixel(d, kAxisLength);
        canvas.line(foot, tip, colour, std::max(1.0F, canvas.px(2.0F)));
        draw_arrow_head(canvas, tip, foot, colour);
        // the letter of an axis that points at the eye is beside the foot of the axis
        const Point at = view.pixel(d, kLetterAt);
        const bool end_on = std::hypot(at.x - view.centre.x, at.y - view.centre.y) < line;
        draw_letter(canvas, end_on ? Point{at.x + line, at.y - line} : at, colour, axis_name(k), labels);
    }
}

void draw_trail(const Canvas& canvas, const SphereView& view, const std::vector<Vec3>& trail) {
    const float width = std::max(1.0F, 2.2F * canvas.fonts().scale);
    for (std::size_t k = 1; k < trail.size(); ++k) {
        const Point a = view.pixel(trail[k - 1]);
        const Point b = view.pixel(trail[k]);
        const bool front = view.faces(trail[k - 1]) && view.faces(trail[k]);
        if (front) {
            canvas.line(a, b, theme::kSubjectMark, width);
        } else if (k % 4 < 2) {
            // behind the sphere: pale and dashed
            canvas.line(a, b, render::with_alpha(theme::kSubjectMark, 0.55F), std::max(1.0F, 0.5F * width));
        }
    }
}

int dropped_now(const DirectionSphere& sphere) {
    if (sphere.pair != PairInUse::rule) { return static_cast<int>(sphere.pair) - 1; }
    if (sphere.dropped >= 0) { return sphere.dropped; }
    Eigen::Index largest = 0;
    sphere.axis->cwiseAbs().maxCoeff(&largest);
    return static_cast<int>(largest);
}

double quality_now(const DirectionSphere& sphere) { return std::abs((*sphere.axis)(dropped_now(sphere))); }

/// Draws the current axis with its value; hollow if it points away from the eye.
void draw_present(
    const Canvas& canvas, const SphereView& view, const DirectionSphere& sphere, Labels& labels) {
    if (!sphere.axis) { return; }
    const Point at = view.pixel(*sphere.axis);
    const float radius = canvas.px(6.0F);
    const bool front = view.faces(*sphere.axis);
    canvas.disc(at, radius + canvas.px(2.0F), theme::kPaper);
    if (front) {
        canvas.disc(at, radius, theme::kAccent);
    } else {
        canvas.ring(at, radius, theme::kAccent, canvas.px(2.0F));
    }
    const Formula name = layout_formula("\\mathbf{s}_i", formula_fonts(canvas.fonts()));
    const ImFont* const bold = canvas.fonts().bold;
    const std::string value =
        front ? fixed_text(quality_now(sphere), 2) : tr("{0} (behind)", fixed_text(quality_now(sphere), 2));
    const float line = canvas.line_height(bold);
    const float gap = canvas.px(5.0F);
    const float width = name.width + gap + canvas.text_width(bold, value);
    // outwards, where the text hides less; letters of axes stay visible
    const float beside = radius + gap;
    const float outer = at.x < view.centre.x ? at.x - beside - width - 2.0F * gap : at.x + beside;
    const float inner = at.x < view.centre.x ? at.x + beside : at.x - beside - width - 2.0F * gap;
    const float middle = at.x - 0.5F * width - gap;
    const std::array<Point, 4> corners{
        {{outer, at.y - 0.5F * line},
         {middle, at.y + beside},
         {middle, at.y - beside - line},
         {inner, at.y - 0.5F * line}}};
    Box box{corners[0].x, corners[0].y, width + 2.0F * gap, line};
    for (const Point corner : corners) {
        const Box there{corner.x, corner.y, box.width, line};
        if (!labels.is_free(there)) { continue; }
        box = there;
        break;
    }
    const Box& bounds = labels.bounds();
    box.x = std::clamp(box.x, bounds.x, std::max(bounds.x, bounds.right() - box.width));
    const float x = box.x + gap;
    canvas.fill(box, render::with_alpha(theme::kPaper, 0.88F), canvas.px(3.0F));
    draw_formula(canvas, {x, box.y + std::round(bold->Ascent)}, name, theme::kAccent);
    canvas.text({x + name.width + gap, box.y}, bold, theme::kInk, value);
    labels.keep_clear(box);
    labels.keep_clear({at.x - 2.0F * radius, at.y - 2.0F * radius, 4.0F * radius, 4.0F * radius});
}

/// Draws the colour scale of the sphere from 0 to 1, with the values of its lines.
void draw_scale(const Canvas& canvas, const Box& box) {
    const ImFont* const small = canvas.fonts().small;
    constexpr int parts = 48;
    for (int k = 0; k < parts; ++k) {
        const Box part = column_of(box, k, parts);
        canvas.fill(
            {part.x, box.y, part.width + 0.5F, canvas.px(8.0F)}, colour_of_quality((k + 0.5) / parts));
    }
    canvas.outline({box.x, box.y, box.width, canvas.px(8.0F)}, theme::kSoft, hairline(canvas));
    for (const double value : {0.0, 0.2, 0.4, 0.577, 0.8, 1.0}) {
        const float x = box.x + static_cast<float>(value) * box.width;
        canvas.fill({std::round(x), box.y, hairline(canvas), canvas.px(11.0F)}, theme::kInk);
        canvas.text({x, box.y + canvas.px(11.0F)}, small, theme::kSoft, number_text(value, 3), Align::centre);
    }
}

/// Draws the scale and the sentences, beside the sphere or below it; nothing in a small box.
/// @return the part of the box that is left for the sphere
Box draw_words(const Canvas& canvas, const Box& box, const DirectionSphere& sphere) {
    const ImFont* const small = canvas.fonts().small;
    const std::string words = sphere_words(sphere);
    const float gap = canvas.px(12.0F);
    const float scale = canvas.px(34.0F);
    const bool beside = box.width > kWide * box.height;
    Box rest = box;
    Box place = box;
    if (beside) { cut_left(place, box.height + gap); }
    const float height = paragraph(canvas.measuring(), place, small, theme::kInk, words);
    if (height + scale > (beside ? 1.0F : kMostWords) * box.height) { return box; }
    if (beside) {
        rest.width = box.height;
        place.y += 0.5F * (box.height - height - scale);
    } else {
        rest.height -= height + scale;
        place.y = rest.bottom();
    }
    draw_scale(canvas, {place.x + gap, place.y, place.width - 2.0F * gap, scale});
    paragraph(canvas, {place.x, place.y + scale, place.width, height}, small, theme::kInk, words);
    return rest;
}

SphereView view_in(const Box& box, const render::CameraAxes& camera) {
    SphereView view;
    view.centre = box.centre();
    view.radius = std::max(1.0F, 0.5F * std::min(box.width, box.height) / kRoomAround);
    view.right = camera.right;
    view.up = camera.up;
    view.towards = -camera.forward;
    return view;
}

}  // namespace

Point SphereView::pixel(const Vec3& d, double size) const {
    const double reach = size * static_cast<double>(radius);
    return {
        centre.x + static_cast<float>(reach * d.dot(right)),
        centre.y - static_cast<float>(reach * d.dot(up))};
}

std::optional<Vec3> SphereView::direction(Point pixel) const {
    double x = static_cast<double>(pixel.x - centre.x) / static_cast<double>(radius);
    double y = static_cast<double>(centre.y - pixel.y) / static_cast<double>(radius);
    const double distance = std::hypot(x, y);
    if (distance > 1.5) { return std::nullopt; }
    if (distance > 1.0) {
        x /= distance;
        y /= distance;
    }
    const double depth = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    return Vec3((x * right + y * up + depth * towards).normalized());
}

std::string sphere_words(const DirectionSphere& sphere) {
    std::string words = tr(
        "Each point is a direction of sᵢ; its value is the smallest singular value of the two rows in use.");
    if (sphere.pair == PairInUse::rule) {
        words = followed(
            words, tr("The rule leaves out the equation of the largest component, so the value is never "
                      "below 1/√3 = 0.577."));
    } else {
        words = followed(
            words, tr("With the {0} equation left out, the value is the size of the {0} component: 1 along "
                      "{0}, and 0 on the thick circle, where the two rows are dependent.",
                      axis_name(static_cast<int>(sphere.pair) - 1)));
    }
    if (!sphere.axis) { return words; }
    const double quality = quality_now(sphere);
    const std::string name = axis_name(dropped_now(sphere));
    // in a unit vector, a smaller component is zero except for rounding
    const std::string condition = quality > 1e-15 ? number_text(1.0 / quality, 3) : "∞";
    words = followed(
        words, tr("Now sᵢ = {0}, {1} is left out: value {2}, condition {3}.", vector_text(*sphere.axis, 2),
                  name, number_text(quality, 3), condition));
    if (sphere.pair == PairInUse::rule && quality < pair_quality(PairInUse::rule, *sphere.axis) - 1e-9) {
        words =
            followed(words, tr("The earlier choice is kept: another one would be better, but not by much."));
    }
    return words;
}

SphereView direction_sphere(
    const Canvas& canvas, const Box& box, const DirectionSphere& sphere, const render::CameraAxes& camera) {
    const Box rest = draw_words(canvas, box, sphere);
    const SphereView view = view_in(rest, camera);
    const std::vector<SphereLine> lines = lines_of(sphere.pair);
    Labels labels(canvas, rest);
    draw_axes_behind(canvas, view, labels);
    draw_shading(canvas, view, sphere.pair);
    canvas.ring(view.centre, view.radius, theme::kSoft, std::max(1.0F, canvas.px(1.6F)));
    draw_lines(canvas, view, lines);
    draw_trail(canvas, view, sphere.trail);
    draw_axes_before(canvas, view, labels);
    draw_present(canvas, view, sphere, labels);
    if (sphere.pair == PairInUse::rule) { name_caps(view, labels); }
    name_lines(view, lines, labels);
    return view;
}

}  // namespace jw::panels
