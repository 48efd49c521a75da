#include "app/session/picture/picture_parts.hpp"
#include "app/session/picture/picture_shapes.hpp"

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
    const Lesson& lesson, const PictureStyle& style, const State& state, int body, float alpha,
    render::Scene& scene) {
    const BodyFrame frame = frame_of(state, body);
    const render::Colour colour = render::with_alpha(colour_of_body(lesson, body), alpha);
    for (const Shape& shape : style.bodies[static_cast<std::size_t>(body)]) {
        scene.shapes.push_back({std::visit(ToGeometry{frame}, shape), colour});
    }
}

Vec3 middle_of_body(const PictureStyle& style, const State& state, int body) {
    const std::vector<Shape>& shapes = style.bodies[static_cast<std::size_t>(body)];
    // the author's first shape is the main one; in a star of rods, no rod has its middle at that of the star
    const Vec3 middle = shapes.empty() ? Vec3(Vec3::Zero()) : centre_of(shapes.front());
    return frame_of(state, body).point(middle);
}

}  // namespace jw::picture
