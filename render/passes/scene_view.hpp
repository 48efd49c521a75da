#pragma once

#include "render/gl/gl_objects.hpp"
#include "render/passes/instances.hpp"
#include "render/scene/camera.hpp"
#include "render/scene/scene.hpp"

namespace jw::render {

/// A scene as one camera sees it. The picture and the id picture share it, so that they agree.
struct SceneView {
    /// Detail of meshes: `by_size` as in pictures; `full` does not depend on the rules for sizes, because
    /// layers of golden snapshots are compared pixel by pixel, also with those of earlier versions.
    enum class Details { by_size, full };

    Camera camera;
    DrawLists lists;
    Matrix4d clip_from_world;
    float clip_per_pixel_x;
    float clip_per_pixel_y;
    float pixel_scale;  ///< device pixels per pixel of a picture 720 high

    SceneView(
        const Scene& scene, const Camera& seen_by, const Rect& viewport, const FrameSize& frame,
        Tone tone = Tone::light, Details details = Details::by_size);

    /// Uniforms of `shaders::kBodyVertex` except those of shadows. @param edge_scale  0 or `pixel_scale`
    void set_solid_uniforms(const GlProgram& program, float edge_scale) const;

    /// Uniforms of `shaders::kLineVertex`.
    void set_line_uniforms(const GlProgram& program) const;
};

}  // namespace jw::render
