#include "render/passes/instanced_meshes.hpp"

#include <cstddef>
#include <span>

namespace jw::render {
namespace {

enum class Advance : GLuint { per_vertex = 0, per_instance = 1 };

/// Attribute `location` reads `count` floats at `offset` in every `stride` bytes of the bound buffer.
void attribute(
    const GlFunctions& gl, GLuint location, GLint count, std::size_t stride, std::size_t offset,
    Advance advance) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(
        location, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
        reinterpret_cast<const void*>(offset));
    gl.VertexAttribDivisor(location, static_cast<GLuint>(advance));
}

template <class T>
void fill(const GlFunctions& gl, GLenum target, std::span<const T> values, GLenum usage) {
    gl.BufferData(target, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), usage);
}

void instance_attributes(const GlFunctions& gl) {
    constexpr std::size_t stride = sizeof(Instance);
    constexpr std::size_t row = 4 * sizeof(float);
    for (GLuint n = 0; n < 3; ++n) {
        attribute(gl, 2 + n, 4, stride, offsetof(Instance, pose) + n * row, Advance::per_instance);
    }
    attribute(gl, 5, 4, stride, offsetof(Instance, size), Advance::per_instance);
    attribute(gl, 6, 4, stride, offsetof(Instance, rounding), Advance::per_instance);
    attribute(gl, 7, 4, stride, offsetof(Instance, colour), Advance::per_instance);
    attribute(gl, 8, 4, stride, offsetof(Instance, edge_colour), Advance::per_instance);
}

}  // namespace

InstancedMeshes::InstancedMeshes(const GlFunctions& gl) : gl_(gl), instances_(GlBuffer::make(gl)) {}

InstancedMeshes::OnCard InstancedMeshes::upload(const Mesh& mesh) const {
    OnCard card{
        GlVertexArray::make(gl_), GlBuffer::make(gl_), GlBuffer::make(gl_),
        static_cast<GLsizei>(mesh.indices.size())};
    gl_.BindVertexArray(card.array.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, card.vertices.name());
    fill(gl_, GL_ARRAY_BUFFER, std::span(mesh.vertices), GL_STATIC_DRAW);
    attribute(gl_, 0, 4, sizeof(MeshVertex), offsetof(MeshVertex, core), Advance::per_vertex);
    attribute(gl_, 1, 3, sizeof(MeshVertex), offsetof(MeshVertex, normal), Advance::per_vertex);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, card.indices.name());
    fill(gl_, GL_ELEMENT_ARRAY_BUFFER, std::span(mesh.indices), GL_STATIC_DRAW);
    gl_.BindBuffer(GL_ARRAY_BUFFER, instances_.name());
    instance_attributes(gl_);
    gl_.BindVertexArray(0);
    return card;
}

void InstancedMeshes::draw(const InstanceLists& lists) const {
    for (std::size_t number = 0; number < kMeshes; ++number) {
        if (lists[number].empty()) { continue; }
        std::optional<OnCard>& mesh = meshes_[number];
        if (!mesh) { mesh = upload(make_mesh(number)); }
        gl_.BindBuffer(GL_ARRAY_BUFFER, instances_.name());
        fill(gl_, GL_ARRAY_BUFFER, std::span(lists[number]), GL_STREAM_DRAW);
        gl_.BindVertexArray(mesh->array.name());
        gl_.DrawElementsInstanced(
            GL_TRIANGLES, mesh->index_count, GL_UNSIGNED_SHORT, nullptr,
            static_cast<GLsizei>(lists[number].size()));
    }
    gl_.BindVertexArray(0);
}

LineBatch::LineBatch(const GlFunctions& gl)
    : gl_(gl), array_(GlVertexArray::make(gl)), segments_(GlBuffer::make(gl)) {
    constexpr std::size_t stride = sizeof(LineSegment);
    gl_.BindVertexArray(array_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, segments_.name());
    attribute(gl_, 0, 3, stride, offsetof(LineSegment, from), Advance::per_instance);
    attribute(gl_, 1, 3, stride, offsetof(LineSegment, to), Advance::per_instance);
    attribute(gl_, 2, 1, stride, offsetof(LineSegment, width), Advance::per_instance);
    attribute(gl_, 3, 4, stride, offsetof(LineSegment, colour), Advance::per_instance);
    attribute(gl_, 4, 1, stride, offsetof(LineSegment, id), Advance::per_instance);
    gl_.BindVertexArray(0);
}

void LineBatch::draw(const std::vector<LineSegment>& segments) const {
    if (segments.empty()) { return; }
    gl_.BindBuffer(GL_ARRAY_BUFFER, segments_.name());
    fill(gl_, GL_ARRAY_BUFFER, std::span(segments), GL_STREAM_DRAW);
    gl_.BindVertexArray(array_.name());
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(segments.size()));
    gl_.BindVertexArray(0);
}

}  // namespace jw::render
