#include "render/passes/scene_view.hpp"

namespace jw::render {
namespace {

constexpr double kDashPixels = 9.0;
constexpr double kReferenceHeight = 720.0;  // widths in pixels are for pictures of this height

PixelAt pixels_of(const Camera& camera, const Rect& viewport, const FrameSize& frame) {
    return [=](const Vector3d& point) { return pixel_size(camera, viewport, point) / frame.pixel_ratio; };
}

}  // namespace

SceneView::SceneView(
    const Scene& scene, const Camera& seen_by, const Rect& viewport, const FrameSize& frame, Tone tone,
    Details details)
    : camera(seen_by),
      lists(draw_lists_of(
          scene,
          kDashPixels * frame.height / kReferenceHeight * pixel_size(seen_by, viewport, seen_by.target), tone,
          details == Details::full ? PixelAt() : pixels_of(seen_by, viewport, frame))),
      clip_from_world(projection_matrix(seen_by, viewport.width / viewport.height) * view_matrix(seen_by)),
      clip_per_pixel_x(static_cast<float>(2.0 / (viewport.width * frame.pixel_ratio))),
      clip_per_pixel_y(static_cast<float>(2.0 / (viewport.height * frame.pixel_ratio))),
      pixel_scale(static_cast<float>(frame.pixel_ratio * frame.height / kReferenceHeight)) {}

void SceneView::set_solid_uniforms(const GlProgram& program, float edge_scale) const {
    program.set("clip_from_world", clip_from_world);
    program.set("clip_per_pixel", clip_per_pixel_x, clip_per_pixel_y);
    program.set("edge_scale", edge_scale);
}

void SceneView::set_line_uniforms(const GlProgram& program) const {
    program.set("clip_from_world", clip_from_world);
    program.set("clip_per_pixel", clip_per_pixel_x, clip_per_pixel_y);
    program.set("width_scale", pixel_scale);
    // greater than 0, where directions in the picture are not defined, and nearer than the near plane at 5 %
    // of the distance
    program.set("near_w", camera.orthographic ? 0.0F : static_cast<float>(0.01 * camera.distance()));
}

}  // namespace jw::render
