#include <algorithm>
#include <cmath>

#include "app/session/picture/picture_parts.hpp"
#include "core/elementary/elementary.hpp"

namespace jw::picture {

namespace {

constexpr render::Colour kWire = render::from_hex(0x5B6672);
constexpr double kWireWidth = 2.4;
/// Sizes relative to the picture's unit, or to the length of the spring.
constexpr double kCoilRadius = 0.028;
constexpr double kStraightEnd = 0.14;
constexpr double kFreeLength = 0.35;
constexpr double kShortest = 0.05;
constexpr int kCoils = 9;
constexpr int kPointsOfCoil = 24;
constexpr double kInnermost = 0.02;
constexpr double kOutermost = 0.10;
constexpr double kSpiralTurns = 2.5;
constexpr double kPadDistance = 0.075;
constexpr double kPadLength = 0.09;
constexpr double kPadRadius = 0.02;
constexpr render::Colour kRubber = render::from_hex(0x33383E);
constexpr double kSleeveLength = 0.06;
constexpr double kSleeveRadius = 0.03;
constexpr double kSleevePin = 0.11;
constexpr double kSleevePinRadius = 0.011;

void add_wire(std::vector<Vec3> points, render::Scene& scene) {
    render::Polyline wire{std::move(points), kWireWidth, kWire};
    wire.see_through = false;
    scene.polylines.push_back(std::move(wire));
}

/// Adds a coil spring; the number of coils does not depend on how far it is stretched.
void add_coils(const PictureStyle& style, const Vec3& from, const Vec3& to, render::Scene& scene) {
    const Vec3 way = to - from;
    // the coils face the eye, so that they do not jump when the spring turns
    const Vec3 first = beside(style, way);
    const Vec3 second = way.normalized().cross(first);
    const double radius = kCoilRadius * style.unit;
    const int count = kCoils * kPointsOfCoil;
    std::vector<Vec3> points{from};
    for (int k = 0; k <= count; ++k) {
        const double angle = kWholeTurn * k / kPointsOfCoil;
        const double along = kStraightEnd + (1.0 - 2.0 * kStraightEnd) * k / count;
        // the wire leaves the axis and comes back to it within a coil
        const double out = radius * std::min(1.0, std::min(k, count - k) / (0.5 * kPointsOfCoil));
        const auto [sine, cosine] = elementary::sine_and_cosine(angle);
        points.push_back(from + along * way + out * (sine * first + cosine * second));
    }
    points.push_back(to);
    add_wire(std::move(points), scene);
}

/// Both ends of a spring along an axis. Its displacement without force is not a length, so kFreeLength takes
/// its place: the spring ends at the point of body j and is visible at every displacement.
std::pair<Vec3, Vec3> ends_along_axis(const PictureStyle& style, const State& state, const Spring& spring) {
    const BodyFrame i = frame_of(state, spring.body_i);
    const Vec3 axis = i.direction(*spring.s_i_local);
    const Vec3 to = frame_of(state, spring.body_j).point(spring.P_j_local);
    const double displacement = axis.dot(to - i.point(spring.P_i_local));
    const double length = kFreeLength * style.unit + displacement - spring.free_length;
    return {to - std::max(length, kShortest * style.unit) * axis, to};
}

/// Adds the symbol of a pure damper: a cylinder on a rod.
void add_dashpot(const PictureStyle& style, const Vec3& from, const Vec3& to, render::Scene& scene) {
    add_wire({from, to}, scene);
    scene.shapes.push_back(
        {render::Cylinder{from + 0.3 * (to - from), from + 0.6 * (to - from), 0.6 * kCoilRadius * style.unit},
         kWire});
}

/// Adds two pads that press on body j along the axis of a sliding joint: dry friction.
void add_pads(const PictureStyle& style, const Vec3& axis, const Vec3& at, render::Scene& scene) {
    for (const double side : {-1.0, 1.0}) {
        const Vec3 middle = at + side * kPadDistance * style.unit * beside(style, axis);
        const Vec3 half = 0.5 * kPadLength * style.unit * axis;
        scene.shapes.push_back(
            {render::Cylinder{middle - half, middle + half, kPadRadius * style.unit}, kWire});
    }
}

/// Adds a spiral from the shaft, which is body j, out to body i. Angles are known only up to whole turns.
void add_spiral(const PictureStyle& style, const PlacedJoint& j, render::Scene& scene) {
    const Vec3 v = j.s_i.cross(j.u_i);
    const double theta = elementary::atan2(j.u_j.dot(v), j.u_j.dot(j.u_i));
    const Vec3 centre = j.P_i + style.joints[static_cast<std::size_t>(j.index)].lift_i * j.s_i;
    const int count = static_cast<int>(kPointsOfCoil * (kSpiralTurns + 1.0));
    std::vector<Vec3> points;
    for (int k = 0; k <= count; ++k) {
        const double share = static_cast<double>(k) / count;
        const double angle = (1.0 - share) * theta + share * kWholeTurn * kSpiralTurns;
        const double radius = style.unit * (kInnermost + share * (kOutermost - kInnermost));
        const auto [sine, cosine] = elementary::sine_and_cosine(angle);
        points.push_back(centre + radius * (cosine * j.u_i + sine * v));
    }
    add_wire(std::move(points), scene);
}

/// Adds a sleeve of rubber in body i about a pin of body j, which leaves its middle as the rubber yields.
void add_bushing(
    const PictureStyle& style, const State& state, const Bushing& bushing, render::Scene& scene) {
    const auto add = [&](int body, const Vec3& point_local, const Vec3& axis_local, double length,
                         double radius, const render::Colour& colour) {
        const BodyFrame frame = frame_of(state, body);
        const Vec3 half = 0.5 * length * style.unit * frame.direction(axis_local);
        const Vec3 middle = frame.point(point_local);
        scene.shapes.push_back({render::Cylinder{middle - half, middle + half, radius * style.unit}, colour});
    };
    add(bushing.body_i, bushing.P_i_local, bushing.axes_i_local.col(2), kSleeveLength, kSleeveRadius,
        kRubber);
    add(bushing.body_j, bushing.P_j_local, bushing.axes_j_local.col(2), kSleevePin, kSleevePinRadius, kWire);
}

}  // namespace

void add_springs(const Lesson& lesson, const PictureStyle& style, const State& state, render::Scene& scene) {
    if (!lesson.dynamics) { return; }
    for (const Spring& spring : lesson.dynamics->loads.springs) {
        const Vec3 P_i = frame_of(state, spring.body_i).point(spring.P_i_local);
        const Vec3 P_j = frame_of(state, spring.body_j).point(spring.P_j_local);
        const bool only_rubs =
            spring.stiffness == 0.0 && spring.damping == 0.0 && !spring.law && spring.friction.size != 0.0;
        if (only_rubs && spring.s_i_local) {
            add_pads(style, frame_of(state, spring.body_i).direction(*spring.s_i_local), P_j, scene);
            continue;
        }
        const auto [from, to] =
            spring.s_i_local ? ends_along_axis(style, state, spring) : std::pair(P_i, P_j);
        if (!((to - from).norm() > kInnermost * style.unit)) { continue; }
        const auto add = spring.stiffness != 0.0 || spring.law ? add_coils : add_dashpot;
        add(style, from, to, scene);
    }
    for (const RotationalSpring& spring : lesson.dynamics->loads.rotational_springs) {
        const std::vector<Joint>& joints = lesson.mechanism.joints;
        const auto joint =
            std::ranges::find_if(joints, [&](const Joint& j) { return acts_about(spring, j); });
        if (joint == joints.end()) { continue; }
        add_spiral(style, placed(lesson.mechanism, static_cast<int>(joint - joints.begin()), state), scene);
    }
    for (const Bushing& bushing : lesson.dynamics->loads.bushings) {
        add_bushing(style, state, bushing, scene);
    }
}

}  // namespace jw::picture
