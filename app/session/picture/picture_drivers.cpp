#include <algorithm>
#include <cmath>

#include "app/session/picture/picture_parts.hpp"
#include "app/session/wording/labels.hpp"
#include "core/elementary/elementary.hpp"
#include "core/numerics/variants.hpp"

namespace jw::picture {

namespace {

namespace palette = render::palette;

constexpr int kArcPoints = 72;  // enough for a full turn to look round
constexpr double kHead = 0.03;  // length of the arrow at the end of an arc, of the unit

constexpr double kArm = 1.22;  // length of u_i, relative to the arc's radius

/// A circle about the axis of a joint.
struct Circle {
    Vec3 centre;
    Vec3 u;  ///< angle 0
    Vec3 v;  ///< a quarter turn
    double radius = 1.0;

    Vec3 direction(double angle) const {
        const auto [sine, cosine] = elementary::sine_and_cosine(angle);
        return cosine * u + sine * v;
    }
    Vec3 at(double angle) const { return centre + radius * direction(angle); }
};

/// Finds the place along the axis where the circle is not hidden: as near to P_i as possible, preferably in
/// front of the bodies.
Circle circle_in_sight(const PictureStyle& style, const PlacedJoint& j, const State& state) {
    constexpr int samples = 16;
    constexpr int places = 8;
    const Solid solid(style, state, j.joint->body_i, j.joint->body_j);
    const double side = style.joints[at(j.index)].side;
    Circle best{
        j.P_i, j.u_i, j.s_i.cross(j.u_i),
        std::clamp(side + 0.06 * style.unit, 0.14 * style.unit, 0.25 * style.unit)};
    const Vec3 to_front = j.s_i.dot(style.view) > 0.0 ? Vec3(-j.s_i) : j.s_i;
    int fewest = 2 * samples + 1;
    for (int k = 0; k < 2 * places; ++k) {
        Circle circle = best;
        const double along = 0.02 * style.unit * (k + 1) / 2 * (k % 2 == 0 ? 1.0 : -1.0);
        circle.centre = j.P_i + along * to_front;
        int hidden = 0;
        for (int n = 0; n < samples; ++n) {
            hidden += solid.contains(circle.at(kWholeTurn * n / samples)) ? 1 : 0;
            // the outer half of u_i and u_j, as far as they are drawn
            const Vec3 along_u =
                (n % 2 == 0 ? j.u_i : j.u_j) * circle.radius * (0.5 + (kArm - 0.5) * n / samples);
            hidden += solid.contains(circle.centre + along_u) ? 1 : 0;
        }
        if (hidden < fewest) {
            fewest = hidden;
            best.centre = circle.centre;
        }
    }
    return best;
}

/// Adds the arc from u_i to u_j about s_i, and these two vectors.
void add_angle(
    const PictureStyle& style, const PlacedJoint& j, const State& state, double angle, Picture& picture) {
    const Circle circle = circle_in_sight(style, j, state);
    // whole turns would be drawn on top of each other
    const double shown = std::remainder(angle, 2.0 * kWholeTurn);
    const int count = std::max(2, static_cast<int>(std::ceil(kArcPoints * std::abs(shown) / kWholeTurn)));
    render::Polyline arc{{}, 3.0, palette::kVectorD};
    for (int k = 0; k <= count; ++k) { arc.points.push_back(circle.at(shown * k / count)); }
    picture.scene.polylines.push_back(std::move(arc));
    const double head = kHead * style.unit / circle.radius;
    if (std::abs(shown) > head) {
        picture.scene.arrows.push_back(
            {circle.at(shown - std::copysign(head, shown)), circle.at(shown), vector_radius(style.unit),
             palette::kVectorD});
    }
    const double middle = 0.5 * shown;
    picture.annotations.push_back({circle.at(middle), circle.direction(middle), "θ", palette::kVectorD});
    const double length = kArm * circle.radius;
    // at angle zero, one would hide the other
    const Vec3 apart = 1.5 * vector_radius(style.unit) * (j.s_i.dot(style.view) > 0.0 ? -1.0 : 1.0) * j.s_i;
    const Vec3 foot_i = circle.centre - apart;
    const Vec3 foot_j = circle.centre + apart;
    add_vector(style, foot_i, foot_i + length * j.u_i, palette::kVectorI, "\\mathbf{u}_i", picture);
    add_vector(style, foot_j, foot_j + 0.9 * length * j.u_j, palette::kVectorJ, "\\mathbf{u}_j", picture);
}

/// Adds the displacement of a joint beside its bar.
void add_displacement(const PictureStyle& style, const PlacedJoint& j, Picture& picture) {
    const double aside = style.joints[at(j.index)].aside_i + 0.03 * style.unit;
    const Vec3 from = j.P_i + aside * beside(style, j.s_i);
    add_distance(style, from, from + j.displacement() * j.s_i, "d", picture);
}

void add_coordinate(const PictureStyle& style, const Vec3& r, int coordinate, Picture& picture) {
    Vec3 foot = r;
    foot(coordinate) = 0.0;
    add_distance(style, foot, r, axis_name(coordinate), picture);
}

}  // namespace

void add_driver(
    const Lesson& lesson, const PictureStyle& style, const State& state, int driver, Picture& picture) {
    const Mechanism& mechanism = lesson.mechanism;
    const Driver& d = mechanism.drivers[at(driver)];
    const auto k = at(d.joint);  // only if the measure belongs to a joint
    const BodyFrame i = frame_of(state, d.body_i);
    const BodyFrame j = frame_of(state, d.body_j);
    std::visit(
        Overloaded{
            [&](const AngleMeasure&) {
                const double angle = relative_angle(mechanism.joints[k], state);
                add_angle(style, placed(mechanism, d.joint, state), state, angle, picture);
            },
            [&](const ThetaMeasure&) {
                const auto theta = at(mechanism.theta_indices()[k]);
                add_angle(style, placed(mechanism, d.joint, state), state, state.theta[theta], picture);
            },
            [&](const DisplacementMeasure&) {
                add_displacement(style, placed(mechanism, d.joint, state), picture);
            },
            [&](const SquaredDistanceMeasure& m) {
                add_distance(style, i.point(m.P_i_local), j.point(m.P_j_local), "d", picture);
            },
            [&](const CoordinateMeasure& m) {
                // a coordinate of p is not a length that can be drawn
                if (m.coordinate < 3) { add_coordinate(style, j.r, m.coordinate, picture); }
            },
        },
        d.measure);
}

}  // namespace jw::picture
