#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "render/scene/shapes.hpp"

namespace jw::render::test {
namespace {

/// Place where the vertex shader puts a vertex of an instance of typical size; threads are not rounded.
Eigen::Vector3f placed(const MeshVertex& vertex, MeshKind kind) {
    const float across = vertex.core.w() > 0.5F ? 0.6F : 1.0F;
    const float rounding = kind == MeshKind::right_thread || kind == MeshKind::left_thread ? 0.0F : 0.1F;
    return Eigen::Vector3f(vertex.core.x() * across, vertex.core.y() * across, vertex.core.z()) +
           rounding * vertex.normal;
}

using Key = std::array<long, 3>;

Key key_of(const Eigen::Vector3f& p) {
    const auto rounded = [](float x) { return std::lround(x * 1e4F); };
    return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

}  // namespace

TEST_CASE("triangles of every mesh face the way their normals point", "[render][shapes]") {
    const auto kind = static_cast<MeshKind>(GENERATE(range(0, static_cast<int>(kMeshKinds))));
    const auto detail = static_cast<Detail>(GENERATE(range(0, static_cast<int>(kDetails))));
    const Mesh mesh = make_mesh(kind, detail);
    CAPTURE(static_cast<int>(kind), static_cast<int>(detail));
    REQUIRE(mesh.indices.size() % 3 == 0);
    std::size_t solid = 0;
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
        const MeshVertex& a = mesh.vertices.at(mesh.indices[n]);
        const MeshVertex& b = mesh.vertices.at(mesh.indices[n + 1]);
        const MeshVertex& c = mesh.vertices.at(mesh.indices[n + 2]);
        const Eigen::Vector3f facing =
            (placed(b, kind) - placed(a, kind)).cross(placed(c, kind) - placed(a, kind));
        // triangles that collapse to a line, up to single precision, draw nothing: they lie at poles and at
        // seams of the nut
        if (facing.norm() < 1e-6F) { continue; }
        ++solid;
        CHECK(facing.normalized().dot((a.normal + b.normal + c.normal).normalized()) > 0.4F);
    }
    CHECK(solid > 20);
}

TEST_CASE("solid meshes are closed: every edge has a triangle on both sides", "[render][shapes]") {
    const MeshKind kind = GENERATE(
        MeshKind::box, MeshKind::round_bar, MeshKind::rod, MeshKind::tube, MeshKind::ring, MeshKind::nut,
        MeshKind::cone);
    const auto detail = static_cast<Detail>(GENERATE(range(0, static_cast<int>(kDetails))));
    const Mesh mesh = make_mesh(kind, detail);
    CAPTURE(static_cast<int>(kind), static_cast<int>(detail));
    std::map<std::pair<Key, Key>, int> crossings;
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
        std::array<Key, 3> corner;
        for (std::size_t k = 0; k < 3; ++k) {
            corner[k] = key_of(placed(mesh.vertices[mesh.indices[n + k]], kind));
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const Key& from = corner[k];
            const Key& to = corner[(k + 1) % 3];
            if (from < to) { ++crossings[{from, to}]; }
            if (to < from) { --crossings[{to, from}]; }
        }
    }
    for (const auto& [edge, balance] : crossings) { CHECK(balance == 0); }
}

TEST_CASE(
    "a circle misses at most a sixth of a pixel, with no more points than it needs", "[render][shapes]") {
    std::size_t last = 0;
    for (double radius = 0.2; radius < 30.0; radius *= 1.05) {
        const Detail detail = detail_for(radius);
        const Mesh mesh = make_mesh(MeshKind::round_bar, detail);
        // radius of the circle inside the chords, from the triangles of the mesh
        float inside = 1.0F;
        for (std::size_t n = 0; n + 1 < mesh.indices.size(); ++n) {
            const Eigen::Vector2f a = mesh.vertices[mesh.indices[n]].core.head<2>();
            const Eigen::Vector2f b = mesh.vertices[mesh.indices[n + 1]].core.head<2>();
            const bool is_chord = n % 3 != 2 && a.norm() > 0.9F && b.norm() > 0.9F;
            if (is_chord) { inside = std::min(inside, (0.5F * (a + b)).norm()); }
        }
        CAPTURE(radius, static_cast<int>(detail));
        if (detail != Detail::high) { CHECK(radius * (1.0 - static_cast<double>(inside)) < 1.0 / 6.0); }
        CHECK(mesh.vertices.size() >= last);
        last = mesh.vertices.size();
    }
    CHECK(detail_for(1.0) == Detail::coarse);
    CHECK(detail_for(100.0) == Detail::high);
    CHECK(detail_for(-1.0) == Detail::high);
    CHECK(detail_for(std::nan("")) == Detail::high);
}

TEST_CASE("normals have unit length", "[render][shapes]") {
    const auto kind = static_cast<MeshKind>(GENERATE(range(0, static_cast<int>(kMeshKinds))));
    const auto detail = static_cast<Detail>(GENERATE(range(0, static_cast<int>(kDetails))));
    for (const MeshVertex& vertex : make_mesh(kind, detail).vertices) {
        CHECK(vertex.normal.norm() == Approx(1.0F).margin(1e-5));  // single precision
    }
}

}  // namespace jw::render::test
