#include "app/session/picture/picture_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary/elementary.hpp"

namespace jw::picture {

namespace {

constexpr double kSame = 1e-6;  // of the unit: nearer points are drawn as one

struct Centre {
    Vec3 operator()(const Box& b) const { return b.centre; }
    Vec3 operator()(const Cylinder& c) const { return 0.5 * (c.from + c.to); }
    Vec3 operator()(const Sphere& s) const { return s.centre; }
    Vec3 operator()(const Rod& r) const { return 0.5 * (r.from + r.to); }
};

/// Place of a point along the line `from` .. `to`, and its distance from the line.
struct AlongLine {
    double part;
    double distance;

    AlongLine(const Vec3& from, const Vec3& to, const Vec3& point) {
        const Vec3 line = to - from;
        const double length_squared = line.squaredNorm();
        part = length_squared > 0.0 ? line.dot(point - from) / length_squared : 0.0;
        distance = (point - from - part * line).norm();
    }
};

struct Contains {
    const Vec3& point;

    bool operator()(const Box& b) const {
        return ((b.axes.transpose() * (point - b.centre)).cwiseAbs() - 0.5 * b.size).maxCoeff() < 0.0;
    }
    bool operator()(const Cylinder& c) const {
        const AlongLine along(c.from, c.to, point);
        return along.part > 0.0 && along.part < 1.0 && along.distance < c.radius;
    }
    bool operator()(const Sphere& s) const { return (point - s.centre).norm() < s.radius; }
    bool operator()(const Rod& r) const {
        const double part = std::clamp(AlongLine(r.from, r.to, point).part, 0.0, 1.0);
        return (point - r.from - part * (r.to - r.from)).norm() < r.radius;
    }
};

/// A joint on a body, local: its point, and a direction across its axis.
struct Attachment {
    Vec3 point;
    Vec3 across;
};

/// Joints on a body; of several at one point only the first.
std::vector<Attachment> attachments_of(const Lesson& lesson, int body, double unit) {
    std::vector<Attachment> found;
    const auto add = [&](const Vec3& point, const Vec3& across) {
        const bool known = std::ranges::any_of(
            found, [&](const Attachment& a) { return (a.point - point).norm() < kSame * unit; });
        if (!known) { found.push_back({point, across}); }
    };
    for (const Joint& joint : lesson.mechanism.joints) {
        const JointGeometry& g = joint.geometry;
        if (joint.body_i == body) { add(g.P_i_local, g.u_i_local); }
        if (joint.body_j == body) { add(g.P_j_local, g.u_j_local); }
    }
    return found;
}

/// A small stand under every joint.
std::vector<Shape> stands(const std::vector<Attachment>& joints, const Vec3& up_local, double pin) {
    std::vector<Shape> shapes;
    for (const Attachment& joint : joints) {
        const Vec3 foot = joint.point - 5.0 * pin * up_local;
        shapes.push_back(Cylinder{foot, joint.point, 0.9 * pin});
        shapes.push_back(Cylinder{foot - 0.8 * pin * up_local, foot, 3.0 * pin});
    }
    return shapes;
}

/// Shapes for a single joint: a rod to the origin or, if the joint is there, a handle that shows its turns.
std::vector<Shape> handle(const Attachment& joint, double unit, double radius) {
    if (joint.point.norm() > kSame * unit) { return {Rod{joint.point, Vec3::Zero(), radius}}; }
    const Vec3 end = joint.point + 12.0 * radius * joint.across.normalized();
    return {Rod{joint.point, end, radius}, Sphere{end, 2.0 * radius}};
}

/// The hub of a wheel, or a short bar along a rack: their joints draw the rest.
std::optional<Shape> hub(const Lesson& lesson, int body, double radius) {
    for (const Joint& joint : lesson.mechanism.joints) {
        if (!joint.type->has_own_coordinate()) { continue; }
        if (joint.body_i != body && joint.body_j != body) { continue; }
        const JointGeometry& g = joint.geometry;
        const Vec3& P = joint.body_i == body ? g.P_i_local : g.P_j_local;
        const Vec3 s = (joint.body_i == body ? g.s_i_local : g.s_j_local).normalized();
        return Cylinder{P - 2.4 * radius * s, P + 2.4 * radius * s, 2.2 * radius};
    }
    return std::nullopt;
}

/// Rods from joint to joint, or from the middle of more than two to each of them.
std::vector<Shape> rods(const std::vector<Attachment>& joints, double unit, double radius) {
    if (joints.empty()) { return {Box{Vec3(8.0, 6.0, 4.0) * radius}}; }
    if (joints.size() == 1) { return handle(joints.front(), unit, radius); }
    if (joints.size() == 2) { return {Rod{joints[0].point, joints[1].point, radius}}; }
    Vec3 middle = Vec3::Zero();
    for (const Attachment& joint : joints) { middle += joint.point / static_cast<double>(joints.size()); }
    std::vector<Shape> shapes;
    for (const Attachment& joint : joints) { shapes.push_back(Rod{joint.point, middle, radius}); }
    return shapes;
}

render::Colour to_render(const Colour& c) {
    return {static_cast<float>(c.red), static_cast<float>(c.green), static_cast<float>(c.blue), 1.0F};
}

struct ToGeometry {
    const BodyFrame& frame;

    render::Geometry operator()(const Box& b) const {
        return render::Box{{frame.A * b.axes, frame.point(b.centre)}, 0.5 * b.size};
    }
    render::Geometry operator()(const Cylinder& c) const {
        return render::Cylinder{frame.point(c.from), frame.point(c.to), c.radius};
    }
    render::Geometry operator()(const Sphere& s) const {
        return render::Sphere{frame.point(s.centre), s.radius};
    }
    render::Geometry operator()(const Rod& r) const {
        return render::Rod{frame.point(r.from), frame.point(r.to), r.radius};
    }
};

}  // namespace

std::vector<Shape> local_shapes(const Lesson& lesson, int body, double unit, const Vec3& up) {
    const auto b = at(body);
    if (!lesson.looks[b].shapes.empty()) { return lesson.looks[b].shapes; }
    const double pin = pin_radius(unit);
    const std::vector<Attachment> joints = attachments_of(lesson, body, unit);
    if (lesson.mechanism.bodies[b].fixed) {
        const Mat3 A = rotation_matrix(lesson.mechanism.bodies[b].p.normalized());
        return stands(joints, A.transpose() * up, pin);
    }
    if (joints.size() <= 1) {
        if (const std::optional<Shape> shape = hub(lesson, body, pin)) { return {*shape}; }
    }
    return rods(joints, unit, 0.9 * pin);
}

Vec3 centre_of(const Shape& shape) { return std::visit(Centre{}, shape); }

Vec3 centre_of(const std::vector<Shape>& shapes) {
    Vec3 centre = Vec3::Zero();
    for (const Shape& shape : shapes) { centre += centre_of(shape) / static_cast<double>(shapes.size()); }
    return centre;
}

Solid::Solid(const PictureStyle& style, const State& state, int body_i, int body_j) {
    for (const int body : {body_i, body_j}) {
        parts_.push_back({frame_of(state, body), &style.bodies[at(body)]});
    }
}

bool Solid::contains(const Vec3& point) const {
    return std::ranges::any_of(parts_, [&](const Part& part) {
        const Vec3 local = part.frame.A.transpose() * (point - part.frame.r);
        return std::ranges::any_of(
            *part.shapes, [&](const Shape& shape) { return std::visit(Contains{local}, shape); });
    });
}

double Solid::reach(const Vec3& from, const Vec3& direction, double limit) const {
    constexpr int steps = 40;  // fine enough for a gap that is only seen
    for (int k = 0; k < steps; ++k) {
        const double distance = limit * k / steps;
        if (!contains(from + distance * direction)) { return distance; }
    }
    return limit;
}

double Solid::clearance(const Vec3& from, const Vec3& to, double limit) const {
    constexpr int samples = 8;
    int hidden = 0;
    double widest = 0.0;
    // the first quarter begins inside every joint; only the rest counts
    for (int k = samples / 4; k <= samples; ++k) {
        const Vec3 at = from + (to - from) * k / samples;
        if (!contains(at)) { continue; }
        ++hidden;
        widest = std::max(widest, way_out(at, to - from, limit));
    }
    return 2 * hidden > samples ? widest : 0.0;
}

double Solid::way_out(const Vec3& at, const Vec3& line, double limit) const {
    constexpr std::size_t directions = 8;
    const Vec3 u = perpendicular_to(line);
    const Vec3 v = u.cross(line).normalized();
    std::array<double, directions> ways{};
    for (std::size_t k = 0; k < directions; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / directions;
        const auto [sine, cosine] = elementary::sine_and_cosine(angle);
        ways[k] = reach(at, cosine * u + sine * v, limit);
    }
    // in a few directions, a plate or a fork reaches far
    std::ranges::sort(ways);
    return ways[5 * directions / 8];
}

BodyFrame frame_of(const State& state, int body) {
    const auto b = at(body);
    return {rotation_matrix(state.p[b].normalized()), state.r[b]};
}

render::Colour colour_of_body(const Lesson& lesson, int body) {
    const auto b = at(body);
    if (lesson.looks[b].colour) { return to_render(*lesson.looks[b].colour); }
    if (lesson.mechanism.bodies[b].fixed) { return render::palette::kGroundBody; }
    // bodies[0] is the ground
    return render::palette::body(b - 1);
}

void add_body(
    const Lesson& lesson, const PictureStyle& style, const State& state, int body, float alpha,
    render::Scene& scene) {
    const BodyFrame frame = frame_of(state, body);
    const render::Colour colour = render::with_alpha(colour_of_body(lesson, body), alpha);
    for (const Shape& shape : style.bodies[at(body)]) {
        scene.shapes.push_back({std::visit(ToGeometry{frame}, shape), colour});
    }
}

Vec3 middle_of_body(const PictureStyle& style, const State& state, int body) {
    const std::vector<Shape>& shapes = style.bodies[at(body)];
    // the author's first shape is the main one; in a star of rods, no rod has its middle at that of the star
    const Vec3 middle = shapes.empty() ? Vec3(Vec3::Zero()) : centre_of(shapes.front());
    return frame_of(state, body).point(middle);
}

}  // namespace jw::picture
