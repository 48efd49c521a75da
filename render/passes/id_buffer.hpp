#pragma once

#include <cstdint>
#include <vector>

#include "render/passes/instanced_meshes.hpp"
#include "render/passes/scene_view.hpp"
#include "render/scene/picture_layers.hpp"

namespace jw::render {

/// Finds what the pointer hits: the scene is drawn again with ids as colours, by the same meshes and vertex
/// shaders as the picture, so that both agree to the pixel. No blending, no multisampling.
///
/// Vectors, points and lines that are visible through bodies are also hit through bodies. Opaque bodies
/// without an id hide what is behind them; anything else without an id lets the pointer through.
class IdBuffer {
public:
    /// @param meshes  of the `SceneRenderer` of the same context. Both must outlive this object; the context
    /// must be current here, in every call and at destruction.
    IdBuffer(const GlFunctions& gl, const SceneMeshes& meshes);

    /// Draws the ids, unless version, camera, viewport and frame are those of the previous call. The
    /// framebuffer that was bound stays bound.
    /// @param version  a number that changes whenever the scene changes
    /// @param details  `by_size` covers the pixels that a picture colours
    /// @return whether anything had to be drawn
    /// @throws std::invalid_argument if an id is out of range
    bool update(
        const Scene& scene, const Camera& camera, const Rect& viewport, const FrameSize& frame,
        std::uint64_t version, SceneView::Details details = SceneView::Details::by_size);

    /// The id for a pointer that need not be exact: that of the nearest vector, point or line within `radius`
    /// pixels; otherwise of the body under the pointer; otherwise of the nearest body within `radius`;
    /// otherwise 0.
    int nearest_id(double x, double y, double radius) const;

    /// All ids and depths of the frame of the last `update`; there is nothing outside the viewport.
    PictureLayers read_layers() const;

private:
    /// Inputs that `update` compares with the previous ones.
    struct Seen {
        std::uint64_t version = 0;
        Camera camera;
        Rect viewport;
        FrameSize frame;
        SceneView::Details details = SceneView::Details::by_size;

        bool operator==(const Seen&) const = default;
    };

    void make_framebuffer_for(const DeviceRect& rect);
    void draw(const SceneView& view) const;
    void begin_hidden() const;
    void end_hidden() const;
    void draw_solids(const SceneView& view, const InstanceLists& lists, float rank) const;
    void draw_solid_parts(const SceneView& view, const InstanceLists& lists, float rank, bool edges) const;
    void draw_lines(const SceneView& view, const std::vector<LineSegment>& lines) const;

    const GlFunctions& gl_;
    const SceneMeshes& meshes_;
    GlProgram solid_;
    GlProgram line_;
    GlFramebuffer framebuffer_;
    GlRenderbuffer colour_;
    GlRenderbuffer depth_;
    DeviceRect rect_{};  // the viewport; empty before the first `update`
    Seen seen_;
};

}  // namespace jw::render
