#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/picture/picture_parts.hpp"
#include "core/numerics/variants.hpp"

namespace jw::picture {

namespace {

namespace palette = render::palette;

Mat3 axes_with_z(const Vec3& z, const Vec3& x_hint) {
    Mat3 A;
    const Vec3 side = x_hint - x_hint.dot(z) * z;
    const Vec3 x = side.norm() > 0.1 ? Vec3(side.normalized()) : perpendicular_to(z);
    A << x, z.cross(x), z;
    return A;
}

// half the length of a bar that is drawn only near its slide, in radii of the pin
constexpr double kStub = 4.2;

/// Draws the glyph of one joint. `g` is the radius of a pin.
class Glyph {
public:
    Glyph(
        const Lesson& lesson, const PictureStyle& style, const PlacedJoint& placed, bool highlighted,
        render::Scene& scene)
        : lesson_(&lesson),
          style_(&style),
          j_(placed),
          g_(pin_radius(style.unit)),
          colour_i_(colour_of_body(lesson, placed.joint->body_i)),
          colour_j_(colour_of_body(lesson, placed.joint->body_j)),
          highlighted_(highlighted),
          scene_(&scene) {}

    void draw() {
        switch (j_.joint->type->glyph) {
            case JointGlyph::none: return;
            case JointGlyph::pin: return pin();
            case JointGlyph::ball: return ball();
            case JointGlyph::cross: return cross();
            case JointGlyph::sleeve: return sleeve();
            case JointGlyph::slide: return slide();
            case JointGlyph::thread: return thread();
            case JointGlyph::block: return block();
            case JointGlyph::plate: return plate();
            case JointGlyph::rod: return rod();
            case JointGlyph::rod_from_pin_to_ball: return rod_from_pin_to_ball();
            case JointGlyph::rod_between_pins: return rod_between_pins();
            case JointGlyph::rod_from_cross_to_ball: return rod_from_cross_to_ball();
            case JointGlyph::bead_on_bar: return bead_on_bar();
            case JointGlyph::bead_on_plate: return bead_on_plate();
            case JointGlyph::bead_on_curve: return bead_on_curve();
            case JointGlyph::gear:
            case JointGlyph::bevel:
            case JointGlyph::belt:
            case JointGlyph::rack:
                return add_wheels(*style_, j_, {colour_i_, colour_j_}, highlighted_, *scene_);
        }
    }

private:
    void add(const render::Geometry& geometry, const render::Colour& colour) {
        scene_->shapes.push_back({geometry, colour, highlighted_, false});
    }
    void bar(const Vec3& centre, const Vec3& axis, double half, double radius, const render::Colour& colour) {
        add(render::Cylinder{centre - half * axis, centre + half * axis, radius}, colour);
    }
    void tube(const Vec3& centre, const Vec3& axis, double half, const render::Colour& colour) {
        add(render::Tube{centre - half * axis, centre + half * axis, 1.9 * g_, 1.12 * g_}, colour);
    }
    bool has_own_shapes(int body) const { return !lesson_->looks[at(body)].shapes.empty(); }
    /// The part of the line through P_i along s_i that body j ever covers, and a bit more: fixed in body i.
    std::pair<Vec3, Vec3> travel(double beyond) const {
        const JointStyle& range = style_->joints[at(j_.index)];
        return {j_.P_i + (range.lowest - beyond) * j_.s_i, j_.P_i + (range.highest + beyond) * j_.s_i};
    }
    /// Ends of the guide; if the lesson draws body i, and so the guide, only those of a short part at body j.
    std::pair<Vec3, Vec3> guide() const {
        if (!has_own_shapes(j_.joint->body_i)) { return travel(5.5 * g_); }
        const Vec3 middle = j_.P_i + j_.displacement() * j_.s_i;
        return {middle - kStub * g_ * j_.s_i, middle + kStub * g_ * j_.s_i};
    }
    /// Direction from a point of the joint towards the body that it belongs to; zero if the body surrounds
    /// the point.
    Vec3 towards_body(int body, const Vec3& P, const BodyFrame& frame) const {
        const Vec3 way = frame.point(centre_of(style_->bodies[at(body)])) - P;
        return way.norm() > 0.1 * g_ ? Vec3(way.normalized()) : Vec3::Zero();
    }

    void pin() {
        bar(j_.P_i, j_.s_i, 2.6 * g_, g_, palette::kSteel);
        tube(j_.P_j, j_.s_j, 1.6 * g_, colour_j_);
    }
    void ball() {
        add(render::Sphere{j_.P_i, 1.7 * g_}, palette::kSteel);
        const Vec3 way = towards_body(j_.joint->body_j, j_.P_j, j_.frame_j);
        add(render::Ring{j_.P_j, way.isZero() ? j_.s_j : way, 1.75 * g_, 0.5 * g_}, colour_j_);
    }
    void cross() {
        bar(j_.P_i, j_.s_i, 2.8 * g_, 0.75 * g_, colour_i_);
        bar(j_.P_j, j_.s_j, 2.8 * g_, 0.75 * g_, colour_j_);
        add(render::Sphere{j_.P_i, 1.2 * g_}, palette::kSteel);
        if (!has_own_shapes(j_.joint->body_i)) { fork(j_.joint->body_i, j_.P_i, j_.s_i, j_.frame_i); }
        if (!has_own_shapes(j_.joint->body_j)) { fork(j_.joint->body_j, j_.P_j, j_.s_j, j_.frame_j); }
    }
    /// Adds the fork that holds the two ends of an arm of the cross.
    void fork(int body, const Vec3& P, const Vec3& s, const BodyFrame& frame) {
        const Vec3 way = towards_body(body, P, frame);
        const Vec3 across = way - way.dot(s) * s;
        const Vec3 back = across.norm() > 0.2 ? Vec3(across.normalized()) : perpendicular_to(s);
        const render::Colour colour = colour_of_body(*lesson_, body);
        const Vec3 half = 2.6 * g_ * s;
        const Vec3 depth = 3.4 * g_ * back;
        add(render::Rod{P + half, P + half + depth, 0.7 * g_}, colour);
        add(render::Rod{P - half, P - half + depth, 0.7 * g_}, colour);
        add(render::Rod{P + half + depth, P - half + depth, 0.7 * g_}, colour);
    }
    void sleeve() {
        const auto [from, to] = guide();
        add(render::Cylinder{from, to, g_}, palette::kSteel);
        tube(j_.P_j, j_.s_j, 3.2 * g_, colour_j_);
    }
    void slide() {
        const auto [from, to] = guide();
        const Mat3 A_i = axes_with_z(j_.s_i, j_.h_i);
        const Mat3 A_j = axes_with_z(j_.s_j, j_.h_j);
        add(render::Box{{A_i, 0.5 * (from + to)}, {g_, g_, 0.5 * (to - from).norm()}}, palette::kSteel);
        add(render::Box{{A_j, j_.P_j}, {1.9 * g_, 1.9 * g_, 3.2 * g_}}, colour_j_);
    }
    void thread();
    void block() {
        add(render::Box{{axes_with_z(j_.s_j, j_.h_j), j_.P_j}, Vec3::Constant(1.6 * g_)}, colour_j_);
    }
    void plate() {
        // thin enough to be seen as a plane, and light enough to see what slides on it from below
        const render::Colour colour = render::with_alpha(colour_i_, 0.5F);
        add(render::Box{{axes_with_z(j_.s_i, j_.u_i), j_.P_i}, {8.0 * g_, 8.0 * g_, 0.2 * g_}}, colour);
        add(render::Cylinder{j_.P_j, j_.P_j + 1.2 * g_ * j_.s_j, 2.0 * g_}, colour_j_);
    }
    void rod() {
        add(render::Rod{j_.P_i, j_.P_j, 0.7 * g_}, palette::kSteel);
        add(render::Sphere{j_.P_i, 1.4 * g_}, colour_i_);
        add(render::Sphere{j_.P_j, 1.4 * g_}, colour_j_);
    }
    /// The massless link of a composite joint.
    void link() { add(render::Rod{j_.P_i, j_.P_j, 0.7 * g_}, palette::kSteel); }
    /// The end of the link around a pin of one of the bodies.
    void eye(const Vec3& P, const Vec3& s, const render::Colour& pin_colour) {
        bar(P, s, 2.6 * g_, g_, pin_colour);
        tube(P, s, 1.4 * g_, palette::kSteel);
    }
    void rod_from_pin_to_ball() {
        link();
        eye(j_.P_i, j_.s_i, colour_i_);
        add(render::Sphere{j_.P_j, 1.7 * g_}, colour_j_);
    }
    void rod_between_pins() {
        link();
        eye(j_.P_i, j_.s_i, colour_i_);
        eye(j_.P_j, j_.s_j, colour_j_);
    }
    void rod_from_cross_to_ball() {
        link();
        const Vec3 d = j_.P_j - j_.P_i;
        const Vec3 along = d.norm() > 0.0 ? Vec3(d.normalized()) : Vec3(Vec3::UnitZ());
        // one arm of the cross turns in body i: it is drawn as nearly fixed there as the link allows
        const Mat3 A = axes_with_z(along, j_.frame_i.A.col(0));
        bar(j_.P_i, A.col(0), 2.8 * g_, 0.75 * g_, colour_i_);
        bar(j_.P_i, A.col(1), 2.8 * g_, 0.75 * g_, palette::kSteel);
        add(render::Sphere{j_.P_i, 1.2 * g_}, palette::kSteel);
        add(render::Sphere{j_.P_j, 1.7 * g_}, colour_j_);
    }
    void bead_on_bar() {
        const auto [from, to] = guide();
        add(render::Cylinder{from, to, g_}, palette::kSteel);
        add(render::Sphere{j_.P_j, 2.2 * g_}, colour_j_);
    }
    void bead_on_curve() {
        const Curve& curve = j_.joint->geometry.curve;
        const JointStyle& range = style_->joints[at(j_.index)];
        const double from = curve.is_closed() ? 0.0 : range.lowest - 0.5;
        const double to = curve.is_closed() ? kWholeTurn : range.highest + 0.5;
        const int parts = std::clamp(
            static_cast<int>(std::ceil(
                (to - from) * 16.0 * std::max<double>(1.0, static_cast<double>(curve.harmonics.size())) /
                kWholeTurn)),
            32, 400);
        const auto at = [&](int k) {
            return Vec3(j_.P_i + j_.frame_i.A * curve.at(from + (to - from) * k / parts).c);
        };
        for (int k = 0; k < parts; ++k) { add(render::Rod{at(k), at(k + 1), 0.6 * g_}, colour_i_); }
        add(render::Sphere{j_.P_j, 1.7 * g_}, colour_j_);
    }
    void bead_on_plate() {
        add(render::Sphere{j_.P_j, 1.7 * g_}, colour_j_);
        // the lesson has drawn the plane already
        if (has_own_shapes(j_.joint->body_i)) { return; }
        const render::Colour colour = render::with_alpha(colour_i_, 0.5F);
        const double half = style_->joints[at(j_.index)].farthest + 4.0 * g_;
        add(render::Box{{axes_with_z(j_.s_i, j_.frame_i.A.col(0)), j_.P_i}, {half, half, 0.2 * g_}}, colour);
    }

    const Lesson* lesson_;
    const PictureStyle* style_;
    const PlacedJoint& j_;
    double g_;
    render::Colour colour_i_;
    render::Colour colour_j_;
    bool highlighted_;
    render::Scene* scene_;
};

/// A round bar of a body along the joint's axis.
struct Shaft {
    Vec3 from, to;
    double radius = 0.0;
    int body = -1;

    double slenderness() const { return radius > 0.0 ? (to - from).norm() / radius : 0.0; }
};

/// The most slender bar along the axis that the lesson drew on `body`, radius 0 if there is none.
Shaft shaft_of(const Lesson& lesson, int body, const BodyFrame& frame, const Vec3& P, const Vec3& axis) {
    constexpr double same_direction = 1e-3;  // rad; an author's bar on the axis is on it exactly
    Shaft best;
    const auto consider = [&](const Vec3& from_local, const Vec3& to_local, double radius) {
        Shaft shaft{frame.point(from_local), frame.point(to_local), radius, body};
        const Vec3 way = (shaft.to - shaft.from).normalized();
        if (way.cross(axis).norm() > same_direction) { return; }
        if ((shaft.from - P).cross(axis).norm() > 0.1 * radius) { return; }
        if (way.dot(axis) < 0.0) { std::swap(shaft.from, shaft.to); }
        if (shaft.slenderness() > best.slenderness()) { best = shaft; }
    };
    const auto look_at = Overloaded{
        [](const Box&) {},
        [&](const Cylinder& c) { consider(c.from, c.to, c.radius); },
        [](const Sphere&) {},
        [&](const Rod& r) { consider(r.from, r.to, r.radius); },
    };
    for (const Shape& shape : lesson.looks[at(body)].shapes) { std::visit(look_at, shape); }
    return best;
}

/// Adds the thread, on the bar that the lesson drew on either body; if there is none, a bar is added.
void Glyph::thread() {
    constexpr double thread_height = 1.12;  // crest to the surface of the bar
    constexpr double slender = 4.0;         // below this it is a nut, not a bolt
    const double pitch = 2.0 * std::numbers::pi * j_.joint->geometry.alpha;
    const Shaft on_i = shaft_of(*lesson_, j_.joint->body_i, j_.frame_i, j_.P_i, j_.s_i);
    const Shaft on_j = shaft_of(*lesson_, j_.joint->body_j, j_.frame_j, j_.P_j, j_.s_j);
    const bool bolt_is_j = on_j.slenderness() > std::max(slender, on_i.slenderness());
    Shaft bolt = bolt_is_j ? on_j : on_i;
    if (bolt.slenderness() <= slender) {
        const auto [from, to] = travel(6.0 * g_);
        bolt = {from, to, g_, -1};
    }
    const render::Colour colour = bolt.body < 0 ? palette::kSteel : (bolt_is_j ? colour_j_ : colour_i_);
    const double crest = thread_height * bolt.radius;
    if (std::abs(pitch) > 0.2 * g_) {
        add(render::Screw{bolt.from, bolt.to, bolt_is_j ? j_.u_j : j_.u_i, crest, pitch}, colour);
    } else {
        add(render::Cylinder{bolt.from, bolt.to, crest}, colour);  // too fine to be seen as a thread
    }
    const Vec3& centre = bolt_is_j ? j_.P_i : j_.P_j;
    const Vec3 half = std::max(1.5 * g_, 0.9 * bolt.radius) * (bolt_is_j ? j_.s_i : j_.s_j);
    add(render::Nut{centre - half, centre + half, bolt_is_j ? j_.u_i : j_.u_j, 2.2 * crest, 1.04 * crest},
        bolt_is_j ? colour_i_ : colour_j_);
}

}  // namespace

PlacedJoint placed(const Mechanism& mechanism, int index, const State& state) {
    const Joint& joint = mechanism.joints[at(index)];
    const BodyFrame i = frame_of(state, joint.body_i);
    const BodyFrame j = frame_of(state, joint.body_j);
    const JointGeometry& g = joint.geometry;
    return {
        &joint,
        index,
        i,
        j,
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
