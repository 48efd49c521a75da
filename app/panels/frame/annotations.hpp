#pragma once

#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "app/session/picture/picture.hpp"
#include "render/scene/camera.hpp"

/// Names beside points of the 3D picture.
namespace jw::panels {

/// A name to be placed.
struct Label {
    Point at;       ///< point that it names
    Point towards;  ///< direction with room on the picture; zero: anywhere
    float width = 0.0F;
    float height = 0.0F;
    bool optional = false;  ///< placed last, and left out rather than placed far away
};

struct PlacedLabel {
    bool shown = false;
    Box box;
    bool far = false;  ///< needs a line to its point
};

/// A drawn line that labels should not cover.
struct Segment {
    Point from;
    Point to;
};

/// Places labels near their points, within `area`, so that no label covers another one or the point of
/// another one. They also avoid the `lines` where that costs little. The same input gives the same places.
/// @param gap  between a point and its label, and between labels
std::vector<PlacedLabel> place_labels(
    const std::vector<Label>& labels, const std::vector<Segment>& lines, const Box& area, float gap);

/// True if the segment meets the box.
bool crosses(const Segment& segment, const Box& box);

/// Which names of bodies are drawn.
enum class BodyNames {
    where_room,  ///< those with room near their bodies
    all,         ///< all with room anywhere, with a line if it is far away
};

/// @param foot  height at the foot of the picture that is covered by something else
void draw_annotations(
    const Canvas& canvas, const Picture& picture, const render::Camera& camera, const render::Rect& viewport,
    float foot = 0.0F, BodyNames body_names = BodyNames::where_room);

}  // namespace jw::panels
