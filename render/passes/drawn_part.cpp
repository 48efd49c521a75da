#include "render/passes/drawn_part.hpp"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace jw::render {
namespace {

using Boxes = std::array<Eigen::AlignedBox3f, kMeshKinds>;

/// Box around the core of each mesh; a mesh with less detail is not larger.
const Boxes& core_boxes() {
    static const Boxes boxes = [] {
        Boxes made;
        for (std::size_t kind = 0; kind < kMeshKinds; ++kind) {
            for (const MeshVertex& vertex : make_mesh(static_cast<MeshKind>(kind)).vertices) {
                made[kind].extend(vertex.core.head<3>().eval());
            }
        }
        return made;
    }();
    return boxes;
}

void include(Bounds& bounds, const Instance& instance, const Eigen::AlignedBox3f& core) {
    const Eigen::Matrix<double, 3, 4> pose = instance.pose.cast<double>();
    // the inner radius is not larger than the outer one
    const Vector3d size = instance.size.head<3>().cast<double>();
    for (const auto corner :
         {Eigen::AlignedBox3f::BottomLeftFloor, Eigen::AlignedBox3f::BottomRightFloor,
          Eigen::AlignedBox3f::TopLeftFloor, Eigen::AlignedBox3f::TopRightFloor,
          Eigen::AlignedBox3f::BottomLeftCeil, Eigen::AlignedBox3f::BottomRightCeil,
          Eigen::AlignedBox3f::TopLeftCeil, Eigen::AlignedBox3f::TopRightCeil}) {
        const Vector3d local = core.corner(corner).cast<double>().cwiseProduct(size);
        bounds.include(pose.leftCols<3>() * local + pose.col(3), static_cast<double>(instance.rounding));
    }
}

template <class Do>
void for_each_solid(const DrawLists& lists, const Do& run) {
    for (const InstanceLists* const solids :
         {&lists.bodies, &lists.annotations, &lists.see_through, &lists.emphasised, &lists.ghosts}) {
        for (std::size_t number = 0; number < kMeshes; ++number) {
            for (const Instance& instance : (*solids)[number]) { run(number, instance); }
        }
    }
}

template <class Do>
void for_each_line(const DrawLists& lists, const Do& run) {
    for (const std::vector<LineSegment>* const lines : {&lists.lines, &lists.see_through_lines}) {
        for (const LineSegment& line : *lines) { run(line); }
    }
}

}  // namespace

Bounds bounds_of(const DrawLists& lists) {
    Bounds bounds;
    for_each_solid(lists, [&](std::size_t number, const Instance& instance) {
        include(bounds, instance, core_boxes()[number / kDetails]);
    });
    for_each_line(lists, [&](const LineSegment& line) {
        bounds.include(line.from.cast<double>());
        bounds.include(line.to.cast<double>());
    });
    return bounds;
}

float border_of(const DrawLists& lists) {
    float most = 0.0F;
    for_each_solid(
        lists, [&](std::size_t, const Instance& instance) { most = std::max(most, instance.edge_width); });
    for_each_line(lists, [&](const LineSegment& line) { most = std::max(most, 0.5F * line.width); });
    return most;
}

}  // namespace jw::render
