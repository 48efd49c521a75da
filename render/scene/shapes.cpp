#include "render/scene/shapes.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>

namespace jw::render {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr float kPi = std::numbers::pi_v<float>;

/// Numbers of points.
struct Points {
    int around;    ///< a circle
    int vector;    ///< a circle of a vector: vectors are thin and many
    int quarter;   ///< the quarter of a circle at the end of a rod, without its first point
    int rounding;  ///< the quarter of a circle at an edge, without its first point
};

constexpr std::array<Points, kDetails> kPoints{
    {{12, 12, 3, 1}, {18, 18, 4, 1}, {28, 18, 6, 2}, {36, 18, 8, 2}}};

/// Largest distance of a polygon from its circle [pixels]: too small to be seen in a smoothed border.
constexpr double kMostMissed = 0.15;

Points points_of(Detail detail) { return kPoints[static_cast<std::size_t>(detail)]; }

Vector2f direction(float angle) { return {std::cos(angle), std::sin(angle)}; }

/// A point of the outline that is rotated about z.
struct ProfilePoint {
    float radius;
    float z;
    Vector2f normal;     ///< radial, axial
    bool inner = false;  ///< scales with the inner radius
};

/// A point of the cross-section: where the core is and where the normal points, in the plane z = 0.
struct SectionPoint {
    Vector2f core;
    Vector2f normal;
};

std::vector<SectionPoint> circle(int points) {
    std::vector<SectionPoint> section;
    for (int n = 0; n < points; ++n) {
        const Vector2f at = direction(2.0F * kPi * static_cast<float>(n) / static_cast<float>(points));
        section.push_back({at, at});
    }
    return section;
}

/// Section of a hexagonal prism; at each corner the normal turns by 60 degrees.
std::vector<SectionPoint> hexagon(int around) {
    const int steps = around / 6;
    std::vector<SectionPoint> section;
    for (int corner = 0; corner < 6; ++corner) {
        const float at = static_cast<float>(corner) * kPi / 3.0F;
        for (int n = 0; n <= steps; ++n) {
            const float turned = (static_cast<float>(n) / static_cast<float>(steps) - 0.5F) * kPi / 3.0F;
            section.push_back({direction(at), direction(at + turned)});
        }
    }
    return section;
}

/// Normals from `first` to `last` [rad from the radial direction] at one core point.
void add_arc(
    std::vector<ProfilePoint>& profile, float radius, float z, float first, float last, int steps,
    bool inner) {
    for (int n = 0; n <= steps; ++n) {
        const float angle = first + (last - first) * static_cast<float>(n) / static_cast<float>(steps);
        profile.push_back({radius, z, direction(angle), inner});
    }
}

void add_quads(Mesh& mesh, std::size_t rows, std::size_t columns, bool wrap) {
    const std::size_t last = wrap ? columns : columns - 1;
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        for (std::size_t column = 0; column < last; ++column) {
            const std::size_t next = (column + 1) % columns;
            const std::size_t base = mesh.vertices.size() - rows * columns;
            const auto index = [&](std::size_t r, std::size_t c) {
                return static_cast<std::uint16_t>(base + r * columns + c);
            };
            const std::array corners{
                index(row, column), index(row, next), index(row + 1, next), index(row + 1, column)};
            for (const int n : {0, 1, 2, 0, 2, 3}) {
                mesh.indices.push_back(corners[static_cast<std::size_t>(n)]);
            }
        }
    }
}

Mesh lathe(const std::vector<ProfilePoint>& profile, const std::vector<SectionPoint>& section) {
    Mesh mesh;
    for (const ProfilePoint& p : profile) {
        for (const SectionPoint& s : section) {
            // a hole is round for any shape of the outside
            const Vector2f core = p.radius * (p.inner ? s.normal : s.core);
            mesh.vertices.push_back({
                {core.x(), core.y(), p.z, p.inner ? 1.0F : 0.0F},
                {p.normal.x() * s.normal.x(), p.normal.x() * s.normal.y(), p.normal.y()},
            });
        }
    }
    add_quads(mesh, profile.size(), section.size(), true);
    return mesh;
}

Mesh round_bar(Points points) {
    std::vector<ProfilePoint> profile{{0.0F, 0.0F, {0.0F, -1.0F}}};
    add_arc(profile, 1.0F, 0.0F, -kPi / 2, 0.0F, points.rounding, false);
    add_arc(profile, 1.0F, 1.0F, 0.0F, kPi / 2, points.rounding, false);
    profile.push_back({0.0F, 1.0F, {0.0F, 1.0F}});
    return lathe(profile, circle(points.around));
}

Mesh shaft(Points points) {
    return lathe(
        {{0.0F, 0.0F, {0.0F, -1.0F}},
         {1.0F, 0.0F, {0.0F, -1.0F}},
         {1.0F, 0.0F, {1.0F, 0.0F}},
         {1.0F, 1.0F, {1.0F, 0.0F}}},
        circle(points.vector));
}

Mesh rod(Points points) {
    std::vector<ProfilePoint> profile;
    add_arc(profile, 0.0F, 0.0F, -kPi / 2, 0.0F, points.quarter, false);
    add_arc(profile, 0.0F, 1.0F, 0.0F, kPi / 2, points.quarter, false);
    return lathe(profile, circle(points.around));
}

std::vector<ProfilePoint> hollow_profile(Points points) {
    std::vector<ProfilePoint> profile;
    add_arc(profile, 1.0F, 0.0F, -kPi / 2, 0.0F, points.rounding, false);
    add_arc(profile, 1.0F, 1.0F, 0.0F, kPi / 2, points.rounding, false);
    add_arc(profile, 1.0F, 1.0F, kPi / 2, kPi, points.rounding, true);
    add_arc(profile, 1.0F, 0.0F, kPi, 1.5F * kPi, points.rounding, true);
    profile.push_back(profile.front());
    return profile;
}

Mesh ring(Points points) {
    std::vector<ProfilePoint> profile;
    add_arc(profile, 1.0F, 0.0F, -kPi, kPi, points.around / 3, false);
    return lathe(profile, circle(points.around * 4 / 3));
}

Mesh cone(Points points) {
    const float slope = std::atan2(1.0F, kConeLength);  // of the side's normal above the plane of the base
    std::vector<ProfilePoint> profile{{0.0F, 0.0F, {0.0F, -1.0F}}};
    add_arc(profile, 1.0F, 0.0F, -kPi / 2, slope, 1, false);
    add_arc(profile, 0.0F, kConeLength, slope, kPi / 2, 1, false);
    return lathe(profile, circle(points.vector));
}

/// Every face is a grid. Each half of it has the normals of one corner, spread like the squares of a cube
/// inflated to a sphere, so that the faces meet without a seam.
Mesh box(Points points) {
    struct Step {
        float core;
        float slope;
    };
    std::vector<Step> steps;
    for (const float side : {-1.0F, 1.0F}) {
        for (int n = 0; n <= points.rounding; ++n) {
            const float angle = kPi / 4 * static_cast<float>(n) / static_cast<float>(points.rounding);
            steps.push_back({side, side < 0.0F ? -std::tan(kPi / 4 - angle) : std::tan(angle)});
        }
    }
    Mesh mesh;
    for (int face = 0; face < 6; ++face) {
        const int axis = face % 3;
        const Vector3f out = (face < 3 ? 1.0F : -1.0F) * Vector3f::Unit(axis);
        const Vector3f across = Vector3f::Unit((axis + 1) % 3);
        const Vector3f along = out.cross(across);
        for (const Step& v : steps) {
            for (const Step& u : steps) {
                const Vector3f core = out + u.core * across + v.core * along;
                const Vector3f normal = (out + u.slope * across + v.slope * along).normalized();
                mesh.vertices.push_back({{core.x(), core.y(), core.z(), 0.0F}, normal});
            }
        }
        add_quads(mesh, steps.size(), steps.size(), false);
    }
    return mesh;
}

/// One turn of a trapezoidal ridge: up from the valley at z = u, crest, down to the valley at z = u + 1.
Mesh right_thread(Points points) {
    struct RidgePoint {
        float z;
        float inner;
        float lean;  ///< axial part of the normal of a flank
    };
    constexpr float lean = 0.8F;
    constexpr std::array<RidgePoint, 8> ridge{{
        {0.05F, 1.0F, -lean},
        {0.4F, 0.0F, -lean},
        {0.4F, 0.0F, 0.0F},
        {0.6F, 0.0F, 0.0F},
        {0.6F, 0.0F, lean},
        {0.95F, 1.0F, lean},
        {0.95F, 1.0F, 0.0F},
        {1.05F, 1.0F, 0.0F},
    }};
    Mesh mesh;
    for (const RidgePoint& point : ridge) {
        for (int n = 0; n <= points.around; ++n) {
            const float turn = static_cast<float>(n) / static_cast<float>(points.around);
            const Vector2f at = direction(2.0F * kPi * turn);
            mesh.vertices.push_back(
                {{at.x(), at.y(), turn + point.z, point.inner},
                 Vector3f(at.x(), at.y(), point.lean).normalized()});
        }
    }
    add_quads(mesh, ridge.size(), static_cast<std::size_t>(points.around) + 1, false);
    return mesh;
}

Mesh mirrored(Mesh mesh) {
    for (MeshVertex& vertex : mesh.vertices) {
        vertex.core.y() = -vertex.core.y();
        vertex.normal.y() = -vertex.normal.y();
    }
    for (std::size_t n = 0; n + 2 < mesh.indices.size(); n += 3) {
        std::swap(mesh.indices[n], mesh.indices[n + 1]);
    }
    return mesh;
}

}  // namespace

Detail detail_for(double radius) {
    if (!(radius >= 0.0)) { return Detail::high; }
    for (const Detail detail : {Detail::coarse, Detail::low, Detail::medium}) {
        const double missed = radius * (1.0 - std::cos(std::numbers::pi / points_of(detail).around));
        if (missed <= kMostMissed) { return detail; }
    }
    return Detail::high;
}

Mesh make_mesh(MeshKind kind, Detail detail) {
    const Points points = points_of(detail);
    switch (kind) {
        case MeshKind::box: return box(points);
        case MeshKind::round_bar: return round_bar(points);
        case MeshKind::rod: return rod(points);
        case MeshKind::tube: return lathe(hollow_profile(points), circle(points.around));
        case MeshKind::ring: return ring(points);
        case MeshKind::nut: return lathe(hollow_profile(points), hexagon(points.around));
        case MeshKind::right_thread: return right_thread(points);
        case MeshKind::left_thread: return mirrored(right_thread(points));
        case MeshKind::shaft: return shaft(points);
        case MeshKind::cone: return cone(points);
    }
    throw std::invalid_argument("make_mesh: no such mesh");
}

Mesh make_mesh(std::size_t number) {
    return make_mesh(static_cast<MeshKind>(number / kDetails), static_cast<Detail>(number % kDetails));
}

}  // namespace jw::render
