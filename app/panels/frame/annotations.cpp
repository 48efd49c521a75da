#include "app/panels/frame/annotations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <imgui.h>

#include "app/panels/parts/formula.hpp"
#include "app/panels/parts/theme.hpp"

namespace jw::panels {

namespace {

constexpr float kGap = 9.0F;

/// A label with its formula and annotation, to be drawn.
struct Drawn {
    Label label;
    Formula formula;  ///< empty for the name of a body
    const Annotation* annotation = nullptr;
};

/// Direction of a global vector on the picture, from the point `at`.
Point direction_on_picture(
    const render::Camera& camera, const render::Rect& viewport, const Vec3& at, const Vec3& towards) {
    if (towards.isZero()) { return {}; }
    const double step = 0.01 * camera.distance();
    const render::Projected from = render::project(camera, viewport, at);
    const render::Projected to = render::project(camera, viewport, at + step * towards.normalized());
    return {static_cast<float>(to.x - from.x), static_cast<float>(to.y - from.y)};
}

Point on_picture(const render::Camera& camera, const render::Rect& viewport, const Vec3& point) {
    const render::Projected seen = render::project(camera, viewport, point);
    return {static_cast<float>(seen.x), static_cast<float>(seen.y)};
}

std::vector<Segment> arrows_on_picture(
    const render::Scene& scene, const render::Camera& camera, const render::Rect& viewport) {
    std::vector<Segment> segments;
    for (const render::Arrow& arrow : scene.arrows) {
        segments.push_back(
            {on_picture(camera, viewport, arrow.from), on_picture(camera, viewport, arrow.to)});
    }
    return segments;
}

/// Font of a name: bold for joints, so that their names differ from those of bodies.
const ImFont* font_of(const Canvas& canvas, const Annotation& name) {
    return name.link.kind == Pointable::Kind::joint ? canvas.fonts().bold : canvas.fonts().small;
}

Drawn prepared(
    const Canvas& canvas, const Annotation& annotation, const render::Camera& camera,
    const render::Rect& viewport) {
    const render::Projected seen = render::project(camera, viewport, annotation.at);
    Drawn drawn;
    drawn.annotation = &annotation;
    drawn.label.at = {static_cast<float>(seen.x), static_cast<float>(seen.y)};
    drawn.label.towards = direction_on_picture(camera, viewport, annotation.at, annotation.towards);
    drawn.label.optional = annotation.body_name;
    if (annotation.body_name) {
        const ImFont* const font = font_of(canvas, annotation);
        drawn.label.width = canvas.text_width(font, annotation.text);
        drawn.label.height = canvas.line_height(font);
    } else {
        drawn.formula = layout_formula(annotation.text, formula_fonts(canvas.fonts()));
        drawn.label.width = drawn.formula.width;
        drawn.label.height = std::ceil(drawn.formula.ascent) + std::ceil(drawn.formula.descent);
    }
    return drawn;
}

void draw_words(const Canvas& canvas, const Drawn& drawn, Point at, Colour colour) {
    if (drawn.annotation->body_name) {
        canvas.text(at, font_of(canvas, *drawn.annotation), colour, drawn.annotation->text);
    } else {
        const Point baseline{at.x, at.y + std::ceil(drawn.formula.ascent)};
        draw_formula(canvas, baseline, drawn.formula, colour);
    }
}

/// Draws a light rim around dark letters, so that they are readable over any body.
void draw_halo(const Canvas& canvas, const Drawn& drawn, Point at) {
    const Colour light = render::with_alpha(theme::kWhite, 0.55F);
    // in large pictures, eight copies would be visible as steps
    const int copies = 8 * std::max(1, static_cast<int>(canvas.px(0.5F)));
    for (const float radius : {canvas.px(2.0F), canvas.px(1.0F)}) {
        for (int k = 0; k < copies; ++k) {
            const float angle = 6.283185F * static_cast<float>(k) / static_cast<float>(copies);
            draw_words(
                canvas, drawn, {at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)}, light);
        }
    }
}

void draw_leader(const Canvas& canvas, const Label& label, const Box& box, Colour colour) {
    const Point nearest{
        std::clamp(label.at.x, box.x, box.right()), std::clamp(label.at.y, box.y, box.bottom())};
    canvas.line(nearest, label.at, render::with_alpha(theme::kWhite, 0.7F), canvas.px(3.0F));
    canvas.line(nearest, label.at, colour, std::max(1.0F, canvas.px(1.0F)));
}

constexpr int kDirections = 12;
// distances between point and label, in units of the gap; the last ones only for labels that must be shown
constexpr std::array kRings{1.0F, 2.2F, 4.0F, 7.0F, 11.0F, 16.0F};
constexpr std::size_t kRingsOfOptional = 2;
constexpr std::size_t kFirstFarRing = 2;

/// The box whose edge is `distance` from the point in direction `angle`.
Box candidate(const Label& label, float angle, float distance) {
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    const float x = label.at.x + c * distance + 0.5F * c * label.width;
    const float y = label.at.y + s * distance + 0.5F * s * label.height;
    return {x - 0.5F * label.width, y - 0.5F * label.height, label.width, label.height};
}

/// Cost of a label's place: its distance from the place where one would look for it; 0 is best.
float cost_of(const Label& label, float angle, std::size_t ring) {
    const float length = std::hypot(label.towards.x, label.towards.y);
    float turned_away = 0.0F;
    if (length > 0.0F) {
        const float along = (std::cos(angle) * label.towards.x + std::sin(angle) * label.towards.y) / length;
        turned_away = 1.0F - along;
    }
    return 1.2F * static_cast<float>(ring) + turned_away;
}

bool is_free(
    const Box& box, std::size_t self, const std::vector<Label>& labels,
    const std::vector<PlacedLabel>& placed, float gap) {
    const float margin = 0.35F * gap;
    const Box around{box.x - margin, box.y - margin, box.width + 2.0F * margin, box.height + 2.0F * margin};
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (placed[k].shown && overlap(around, placed[k].box)) { return false; }
        if (k != self && !labels[k].optional && around.contains(labels[k].at)) { return false; }
    }
    return !around.contains(labels[self].at);
}

float cost_of_cover(const Box& box, const std::vector<Segment>& lines) {
    const auto covered =
        std::ranges::count_if(lines, [&](const Segment& segment) { return crosses(segment, box); });
    return 0.9F * static_cast<float>(covered);
}

PlacedLabel place(
    std::size_t self, const std::vector<Label>& labels, const std::vector<Segment>& lines,
    const std::vector<PlacedLabel>& placed, const Box& area, float gap) {
    const Label& label = labels[self];
    const std::size_t rings = label.optional ? kRingsOfOptional : kRings.size();
    float least = std::numeric_limits<float>::max();
    PlacedLabel best;
    for (std::size_t ring = 0; ring < rings; ++ring) {
        for (int k = 0; k < kDirections; ++k) {
            const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(k) / kDirections;
            const Box box = candidate(label, angle, kRings[ring] * gap);
            const float cost = cost_of(label, angle, ring) + cost_of_cover(box, lines);
            if (cost < least && area.contains(box) && is_free(box, self, labels, placed, gap)) {
                least = cost;
                best = {true, box, ring >= kFirstFarRing};
            }
        }
    }
    return best;
}

}  // namespace

void draw_annotations(
    const Canvas& canvas, const Picture& picture, const render::Camera& camera, const render::Rect& viewport,
    float foot, BodyNames body_names) {
    std::vector<Drawn> drawn;
    for (const Annotation& annotation : picture.annotations) {
        if (render::project(camera, viewport, annotation.at).visible) {
            drawn.push_back(prepared(canvas, annotation, camera, viewport));
        }
    }
    std::vector<Label> labels;
    for (const Drawn& d : drawn) {
        labels.push_back(d.label);
        labels.back().optional = d.label.optional && body_names == BodyNames::where_room;
    }

    Box area = shrunk(box_of(viewport), canvas.px(6.0F), canvas.px(6.0F));
    area.height = std::max(0.0F, area.height - foot);
    const std::vector<PlacedLabel> placed =
        place_labels(labels, arrows_on_picture(picture.scene, camera, viewport), area, canvas.px(kGap));
    for (std::size_t k = 0; k < drawn.size(); ++k) {
        if (!placed[k].shown) { continue; }
        const Point at{placed[k].box.x, placed[k].box.y};
        if (placed[k].far) { draw_leader(canvas, labels[k], placed[k].box, drawn[k].annotation->colour); }
        const Pointable& link = drawn[k].annotation->link;
        canvas.spot(placed[k].box, link);
        if (canvas.lit(link)) {
            const Box around = shrunk(placed[k].box, -canvas.px(3.0F), -canvas.px(2.0F));
            canvas.fill(around, theme::kSubject, canvas.px(3.0F));
            canvas.outline(around, theme::kSubjectMark, std::max(1.0F, canvas.px(1.0F)), canvas.px(3.0F));
        }
        draw_halo(canvas, drawn[k], at);
        draw_words(canvas, drawn[k], at, drawn[k].annotation->colour);
    }
}

bool crosses(const Segment& segment, const Box& box) {
    return clipped(segment.from, segment.to, box).has_value();
}

std::vector<PlacedLabel> place_labels(
    const std::vector<Label>& labels, const std::vector<Segment>& lines, const Box& area, float gap) {
    std::vector<PlacedLabel> placed(labels.size());
    for (const bool optional : {false, true}) {
        for (std::size_t k = 0; k < labels.size(); ++k) {
            if (labels[k].optional == optional && area.contains(labels[k].at)) {
                placed[k] = place(k, labels, lines, placed, area, gap);
            }
        }
    }
    return placed;
}

}  // namespace jw::panels
