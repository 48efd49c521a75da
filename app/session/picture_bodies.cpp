#include <algorithm>

#include "app/session/picture_parts.hpp"

namespace jw::picture {

namespace {

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

/// Points of joints on a body, local, each once.
std::vector<Vec3> joint_points(const Lesson& lesson, int body, double unit) {
    std::vector<Vec3> points;
    const auto add = [&](const Vec3& point) {
        const bool known =
            std::ranges::any_of(points, [&](const Vec3& p) { return (p - point).norm() < 1e-6 * unit; });
        if (!known) { points.push_back(point); }
    };
    for (const Joint& joint : lesson.mechanism.joints) {
        if (joint.body_i == body) { add(joint.geometry.P_i_local); }
        if (joint.body_j == body) { add(joint.geometry.P_j_local); }
    }
    return points;
}

/// A small stand under every joint on the ground.
void add_stands(
    const Lesson& lesson, const PictureStyle& style, const BodyFrame& frame, int body, render::Scene& scene) {
    const double size = pin_radius(style);
    for (const Vec3& local : joint_points(lesson, body, style.unit)) {
        const Vec3 top = frame.point(local);
        const Vec3 foot = top - 5.0 * size * style.up;
        scene.shapes.push_back({render::Cylinder{top, foot, 0.8 * size}, render::palette::kGroundBody});
        scene.shapes.push_back(
            {render::Cylinder{foot, foot - 0.8 * size * style.up, 3.0 * size}, render::palette::kGroundBody});
    }
}

/// Rods from joint to joint, or from the middle to each of more than two.
void add_default_rods(
    const Lesson& lesson, const PictureStyle& style, const BodyFrame& frame, int body, render::Scene& scene) {
    const double radius = 0.9 * pin_radius(style);
    const render::Colour colour = colour_of_body(lesson, body);
    std::vector<Vec3> points = joint_points(lesson, body, style.unit);
    if (points.empty()) {
        scene.shapes.push_back({render::Box{{frame.A, frame.r}, Vec3::Constant(4.0 * radius)}, colour});
        return;
    }
    if (points.size() == 1) { points.push_back(Vec3::Zero()); }
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : points) { middle += p / static_cast<double>(points.size()); }
    if (points.size() == 2) { middle = points[1]; }
    for (const Vec3& p : points) {
        if ((p - middle).norm() < 1e-9 * style.unit) { continue; }
        scene.shapes.push_back({render::Rod{frame.point(p), frame.point(middle), radius}, colour});
    }
    // one joint, at the origin: something to see that turns
    if (points.size() == 2 && (points[0] - points[1]).norm() < 1e-9 * style.unit) {
        scene.shapes.push_back({render::Box{{frame.A, frame.r}, Vec3::Constant(4.0 * radius)}, colour});
    }
}

struct Centre {
    Vec3 operator()(const Box& b) const { return b.centre; }
    Vec3 operator()(const Cylinder& c) const { return 0.5 * (c.from + c.to); }
    Vec3 operator()(const Sphere& s) const { return s.centre; }
    Vec3 operator()(const Rod& r) const { return 0.5 * (r.from + r.to); }
};

}  // namespace

BodyFrame frame_of(const State& state, int body) {
    const auto b = static_cast<std::size_t>(body);
    return {rotation_matrix(state.p[b].normalized()), state.r[b]};
}

render::Colour colour_of_body(const Lesson& lesson, int body) {
    const auto b = static_cast<std::size_t>(body);
    if (lesson.looks[b].colour) { return to_render(*lesson.looks[b].colour); }
    if (lesson.mechanism.bodies[b].fixed) { return render::palette::kGroundBody; }
    // bodies[0] is the ground
    return render::palette::body(b - 1);
}

void add_body(
    const Lesson& lesson, const PictureStyle& style, const State& state, int body, render::Scene& scene) {
    const auto b = static_cast<std::size_t>(body);
    const BodyFrame frame = frame_of(state, body);
    if (lesson.looks[b].shapes.empty()) {
        if (lesson.mechanism.bodies[b].fixed) {
            add_stands(lesson, style, frame, body, scene);
        } else {
            add_default_rods(lesson, style, frame, body, scene);
        }
    }
    for (const Shape& shape : lesson.looks[b].shapes) {
        scene.shapes.push_back({std::visit(ToGeometry{frame}, shape), colour_of_body(lesson, body)});
    }
}

Vec3 middle_of_body(const Lesson& lesson, const State& state, int body) {
    const auto b = static_cast<std::size_t>(body);
    Vec3 middle = Vec3::Zero();
    if (!lesson.looks[b].shapes.empty()) {
        middle = std::visit(Centre{}, lesson.looks[b].shapes.front());
    } else if (const std::vector<Vec3> points = joint_points(lesson, body, 1.0); !points.empty()) {
        for (const Vec3& p : points) { middle += p / static_cast<double>(points.size()); }
        if (points.size() == 1) { middle *= 0.5; }
    }
    return frame_of(state, body).point(middle);
}

}  // namespace jw::picture
