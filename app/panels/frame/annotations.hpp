#pragma once

#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "app/session/picture/picture.hpp"
#include "render/camera.hpp"

/// Names beside points of the 3D picture.
namespace jw::panels {

/// A name that wants a place.
struct Label {
    Point at;       ///< what it names
    Point towards;  ///< direction with room on the picture; zero: anywhere
    float width = 0.0F;
    float height = 0.0F;
    bool optional = false;  ///< comes last, and is left out rather than put far away
};

struct PlacedLabel {
    bool shown = false;
    Box box;
    bool far = false;  ///< needs a line to its point
};

/// A drawn line that labels had better not cover.
struct Segment {
    Point from;
    Point to;
};

/// Puts labels near their points, none over another or over a point that another names, all within `area`;
/// off the `lines` where that costs little. The same input gives the same places.
/// @param gap  between a point and its label, and between labels
std::vector<PlacedLabel> place_labels(
    const std::vector<Label>& labels, const std::vector<Segment>& lines, const Box& area, float gap);

/// Does the segment meet the box?
bool crosses(const Segment& segment, const Box& box);

/// Which names of bodies are written.
enum class BodyNames {
    where_room,  ///< those that find room near their bodies
    all,         ///< all that find room at all, with a line where that is far away
};

/// @param foot  height at the foot of the picture that something else covers
void draw_annotations(
    const Canvas& canvas, const Picture& picture, const render::Camera& camera, const render::Rect& viewport,
    float foot = 0.0F, BodyNames body_names = BodyNames::where_room);

}  // namespace jw::panels
