#pragma once

#include <cstdint>
#include <optional>

#include "render/gl_objects.hpp"
#include "render/instanced_meshes.hpp"
#include "render/shadow_view.hpp"

namespace jw::render {

/// The key light's picture of the bodies: how far its rays reach.
class ShadowMap {
public:
    static constexpr int kTexels = 512;
    static constexpr double kBorder = 0.006;  ///< softness of shadows, in widths of the map

    explicit ShadowMap(const GlFunctions& gl);

    /// Draws `casters`, unless the map shows just these from there already. Leaves the framebuffer that was
    /// bound bound.
    void update(const SceneMeshes& meshes, const InstanceLists& casters, const ShadowView& view);

    /// Number of times that the map has been drawn: as long as it is the same, so are the shadows.
    std::uint64_t version() const { return version_; }

    /// View that the map shows; `update` must have been called.
    const ShadowView& view() const { return shown_->view; }

    /// Binds the map to texture unit 0.
    void bind() const;

    /// Uniforms of the fragment shaders that look shadows up.
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
