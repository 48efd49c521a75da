#include <cmath>
#include <numbers>

#include "app/session/picture_parts.hpp"

namespace jw::picture {

namespace {

/// Draws the glyph of one joint. `g` is the radius of a pin.
class Glyph {
public:
    Glyph(
        const Lesson& lesson, const PictureStyle& style, const PlacedJoint& placed, bool highlighted,
        render::Scene& scene)
        : j_(placed),
          g_(pin_radius(style)),
          colour_i_(colour_of_body(lesson, placed.joint->body_i)),
          colour_j_(colour_of_body(lesson, placed.joint->body_j)),
          highlighted_(highlighted),
          scene_(&scene) {}

    void draw() {
        const std::string_view name = j_.joint->type->name;
        if (name == "revolute") { return revolute(); }
        if (name == "spherical") { return spherical(); }
        if (name == "universal") { return universal(); }
        if (name == "cylindrical") { return cylindrical(); }
        if (name == "prismatic") { return prismatic(); }
        if (name == "screw") { return screw(); }
        if (name == "fixed") { return fixed(); }
        if (name == "planar") { return planar(); }
        if (name == "distance") { return distance(); }
        // bare primitives are their vectors and nothing else
    }

private:
    void add(const render::Geometry& geometry, const render::Colour& colour) {
        scene_->shapes.push_back({geometry, colour, highlighted_, false});
    }
    void bar(const Vec3& centre, const Vec3& axis, double half, double radius, const render::Colour& colour) {
        add(render::Cylinder{centre - half * axis, centre + half * axis, radius}, colour);
    }
    void sleeve(const Vec3& centre, const Vec3& axis, double half, const render::Colour& colour) {
        add(render::Tube{centre - half * axis, centre + half * axis, 1.9 * g_, 1.12 * g_}, colour);
    }
    /// From `before` the lower of the two points to beyond the upper one, along s_i through P_i.
    std::pair<Vec3, Vec3> span_along_axis(double beyond) const {
        const double d = j_.s_i.dot(j_.P_j - j_.P_i);
        return {j_.P_i + (std::min(0.0, d) - beyond) * j_.s_i, j_.P_i + (std::max(0.0, d) + beyond) * j_.s_i};
    }
    static Mat3 axes_with_z(const Vec3& z, const Vec3& x_hint) {
        Mat3 A;
        const Vec3 side = x_hint - x_hint.dot(z) * z;
        const Vec3 x = side.norm() > 0.1 ? Vec3(side.normalized()) : perpendicular_to(z);
        A << x, z.cross(x), z;
        return A;
    }

    void revolute() {
        bar(j_.P_i, j_.s_i, 2.6 * g_, g_, render::palette::kSteel);
        sleeve(j_.P_j, j_.s_j, 1.6 * g_, colour_j_);
    }
    void spherical() {
        add(render::Sphere{j_.P_i, 1.7 * g_}, render::palette::kSteel);
        add(render::Ring{j_.P_j, j_.s_j, 1.8 * g_, 0.45 * g_}, colour_j_);
    }
    void universal() {
        bar(j_.P_i, j_.s_i, 2.8 * g_, 0.75 * g_, colour_i_);
        bar(j_.P_j, j_.s_j, 2.8 * g_, 0.75 * g_, colour_j_);
        add(render::Sphere{j_.P_i, 1.2 * g_}, render::palette::kSteel);
    }
    void cylindrical() {
        const auto [from, to] = span_along_axis(7.0 * g_);
        add(render::Cylinder{from, to, g_}, render::palette::kSteel);
        sleeve(j_.P_j, j_.s_j, 3.2 * g_, colour_j_);
    }
    void prismatic() {
        const auto [from, to] = span_along_axis(7.0 * g_);
        const Mat3 A_i = axes_with_z(j_.s_i, j_.h_i);
        const Mat3 A_j = axes_with_z(j_.s_j, j_.h_j);
        add(render::Box{{A_i, 0.5 * (from + to)}, {g_, g_, 0.5 * (to - from).norm()}},
            render::palette::kSteel);
        add(render::Box{{A_j, j_.P_j}, {1.9 * g_, 1.9 * g_, 3.2 * g_}}, colour_j_);
    }
    void screw() {
        const auto [from, to] = span_along_axis(6.0 * g_);
        const double pitch = 2.0 * std::numbers::pi * j_.joint->geometry.alpha;
        if (std::abs(pitch) > 0.3 * g_) {
            add(render::Screw{from, to, j_.u_i, 1.15 * g_, pitch}, render::palette::kSteel);
        } else {
            add(render::Cylinder{from, to, g_}, render::palette::kSteel);  // too fine to be seen as a thread
        }
        const Vec3 half = 1.5 * g_ * j_.s_j;
        add(render::Nut{j_.P_j - half, j_.P_j + half, j_.u_j, 2.5 * g_, 1.2 * g_}, colour_j_);
    }
    void fixed() {
        add(render::Box{{axes_with_z(j_.s_j, j_.h_j), j_.P_j}, Vec3::Constant(1.6 * g_)}, colour_j_);
    }
    void planar() {
        const render::Colour colour = render::with_alpha(colour_i_, 0.45F);
        add(render::Box{{axes_with_z(j_.s_i, j_.u_i), j_.P_i}, {7.0 * g_, 7.0 * g_, 0.25 * g_}}, colour);
        add(render::Cylinder{j_.P_j, j_.P_j + 1.2 * g_ * j_.s_j, 1.5 * g_}, colour_j_);
    }
    void distance() {
        add(render::Rod{j_.P_i, j_.P_j, 0.7 * g_}, render::palette::kSteel);
        add(render::Sphere{j_.P_i, 1.4 * g_}, colour_i_);
        add(render::Sphere{j_.P_j, 1.4 * g_}, colour_j_);
    }

    const PlacedJoint& j_;
    double g_;
    render::Colour colour_i_;
    render::Colour colour_j_;
    bool highlighted_;
    render::Scene* scene_;
};

}  // namespace

PlacedJoint placed(const Joint& joint, const State& state) {
    const BodyFrame i = frame_of(state, joint.body_i);
    const BodyFrame j = frame_of(state, joint.body_j);
    const JointGeometry& g = joint.geometry;
    return {
        &joint,
        i.point(g.P_i_local),
        j.point(g.P_j_local),
        i.direction(g.s_i_local),
        j.direction(g.s_j_local),
        i.direction(g.h_i_local),
        j.direction(g.h_j_local),
        i.direction(g.u_i_local),
        j.direction(g.u_j_local)};
}

void add_joint(
    const Lesson& lesson, const PictureStyle& style, const PlacedJoint& joint, bool highlighted,
    render::Scene& scene) {
    Glyph(lesson, style, joint, highlighted, scene).draw();
}

}  // namespace jw::picture
