#pragma once

#include <vector>

#include "app/session/picture/picture_parts.hpp"

/// Shapes of bodies in their own frames, and what they hide.
namespace jw::picture {

/// Shapes of the lesson; for a body that has none, rods between its joints, or small stands under them if it
/// is fixed. @param unit see PictureStyle
std::vector<Shape> local_shapes(const Lesson& lesson, int body, double unit, const Vec3& up);

Vec3 centre_of(const Shape& shape);
Vec3 centre_of(const std::vector<Shape>& shapes);

/// The shapes of two bodies at a pose.
class Solid {
public:
    Solid(const PictureStyle& style, const State& state, int body_i, int body_j);

    bool contains(const Vec3& point) const;
    /// Distance from `from` to where a ray in `direction` leaves the shapes, at most `limit` [m]; 0 if `from`
    /// is outside.
    double reach(const Vec3& from, const Vec3& direction, double limit) const;
    /// Distance beside the line from `from` to `to` at which a vector is no longer hidden; 0 if most of it
    /// shows anyway, at most `limit`.
    double clearance(const Vec3& from, const Vec3& to, double limit) const;

private:
    /// Distance from a hidden point of a line that leads out of the shapes in most directions across the
    /// line.
    double way_out(const Vec3& at, const Vec3& line, double limit) const;

    struct Part {
        BodyFrame frame;
        const std::vector<Shape>* shapes;
    };
    std::vector<Part> parts_;
};

}  // namespace jw::picture
