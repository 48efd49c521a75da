#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/gl/gl_objects.hpp"
#include "render/passes/instances.hpp"

namespace jw::render {

/// Meshes on the graphics card, each uploaded when it is first drawn, and the current instances.
class InstancedMeshes {
public:
    explicit InstancedMeshes(const GlFunctions& gl);

    /// Draws with the current program and state; attributes as in `shaders::kBodyVertex`.
    void draw(const InstanceLists& lists) const;

private:
    struct OnCard {
        GlVertexArray array;
        GlBuffer vertices;
        GlBuffer indices;
        GLsizei index_count = 0;
    };

    OnCard upload(const Mesh& mesh) const;

    const GlFunctions& gl_;
    GlBuffer instances_;
    mutable std::array<std::optional<OnCard>, kMeshes> meshes_;  // made when first drawn
};

/// Line segments as rectangles that face the camera; attributes as in `shaders::kLineVertex`.
class LineBatch {
public:
    explicit LineBatch(const GlFunctions& gl);

    void draw(const std::vector<LineSegment>& segments) const;

private:
    const GlFunctions& gl_;
    GlVertexArray array_;
    GlBuffer segments_;
};

/// Meshes on the graphics card, shared by everything that draws scenes.
struct SceneMeshes {
    explicit SceneMeshes(const GlFunctions& gl) : solids(gl), lines(gl) {}

    InstancedMeshes solids;
    LineBatch lines;
};

}  // namespace jw::render
