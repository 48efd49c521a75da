#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "app/panels/frame/annotations.hpp"

namespace jw::panels {

namespace {

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

bool crosses(const Segment& segment, const Box& box) {
    // range of the segment, within 0 to 1, that lies between both pairs of edges
    float first = 0.0F;
    float last = 1.0F;
    const auto clip = [&](float from, float to, float low, float high) {
        const float length = to - from;
        if (length == 0.0F) { return from >= low && from <= high; }
        const float a = (low - from) / length;
        const float b = (high - from) / length;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
        return first <= last;
    };
    return clip(segment.from.x, segment.to.x, box.x, box.right()) &&
           clip(segment.from.y, segment.to.y, box.y, box.bottom());
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
