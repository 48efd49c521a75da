#pragma once

#include <cstdint>
#include <optional>

#include "render/gl/gl_objects.hpp"
#include "render/passes/instanced_meshes.hpp"
#include "render/passes/shadow_view.hpp"

namespace jw::render {

/// The key light's picture of the bodies: how far its rays reach.
class ShadowMap {
public:
    static constexpr int kTexels = 512;
    static constexpr double kBorder = 0.006;  ///< width of soft borders of shadows, in widths of the map

    explicit ShadowMap(const GlFunctions& gl);

    /// Draws `casters`, unless the map already shows exactly these in this view. The framebuffer that was
    /// bound stays bound.
    void update(const SceneMeshes& meshes, const InstanceLists& casters, const ShadowView& view);

    /// Number of times that the map has been drawn: the shadows are the same as long as this number is the
    /// same.
    std::uint64_t version() const { return version_; }

    /// View that the map shows; `update` must have been called.
    const ShadowView& view() const { return shown_->view; }

    /// Binds the map to texture unit 0.
    void bind() const;

    /// Uniforms of the fragment shaders that read shadows.
    static void set_uniforms(const GlProgram& program);

private:
    struct Shown {
        InstanceLists casters;
        ShadowView view;

        bool operator==(const Shown&) const = default;
    };

    const GlFunctions& gl_;
    GlProgram depth_;
    GlTexture map_;
    GlFramebuffer framebuffer_;
    std::optional<Shown> shown_;
    std::uint64_t version_ = 0;
};

}  // namespace jw::render
