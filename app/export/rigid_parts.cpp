#include "app/export/moving_scene.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "app/session/picture/picture_parts.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/lesson/things.hpp"

namespace jw {

namespace {

/// Largest difference that does not count as a move, relative to the size of the mechanism: joints are closed
/// to 1e-10 of it, and pictures are made of doubles.
constexpr double kSamePlace = 1e-6;

/// Transformation of coordinates from the global frame to that of a body.
struct IntoBody {
    picture::BodyFrame frame;

    Vec3 point(const Vec3& p) const { return frame.A.transpose() * (p - frame.r); }
    Vec3 direction(const Vec3& d) const { return frame.A.transpose() * d; }
    render::Pose pose(const render::Pose& p) const { return {frame.A.transpose() * p.A, point(p.r)}; }
};

render::Geometry moved(const render::Geometry& geometry, const IntoBody& to) {
    return std::visit(
        Overloaded{
            [&](render::Box g) -> render::Geometry {
                g.pose = to.pose(g.pose);
                return g;
            },
            [&](render::Sphere g) -> render::Geometry {
                g.centre = to.point(g.centre);
                return g;
            },
            [&](render::Ring g) -> render::Geometry {
                g.centre = to.point(g.centre);
                g.axis = to.direction(g.axis);
                return g;
            },
            [&]<class Sided>(Sided g) -> render::Geometry {
                g.from = to.point(g.from);
                g.to = to.point(g.to);
                if constexpr (requires { g.side; }) { g.side = to.direction(g.side); }
                return g;
            }},
        geometry);
}

/// All numbers of a geometry. Two geometries are the same if their numbers are.
std::vector<double> numbers_of(const render::Geometry& geometry) {
    std::vector<double> numbers{static_cast<double>(geometry.index())};
    const auto add = [&](const auto&... values) { (numbers.push_back(values), ...); };
    const auto add_vector = [&](const Vec3& v) { add(v.x(), v.y(), v.z()); };
    std::visit(
        Overloaded{
            [&](const render::Box& g) {
                add_vector(g.pose.r);
                for (Eigen::Index k = 0; k < 3; ++k) { add_vector(g.pose.A.col(k)); }
                add_vector(g.half_size);
            },
            [&](const render::Sphere& g) {
                add_vector(g.centre);
                add(g.radius);
            },
            [&](const render::Ring& g) {
                add_vector(g.centre);
                add_vector(g.axis);
                add(g.radius, g.wire_radius);
            },
            [&]<class Sided>(const Sided& g) {
                add_vector(g.from);
                add_vector(g.to);
                if constexpr (requires { g.side; }) { add_vector(g.side); }
                if constexpr (requires { g.radius; }) { add(g.radius); }
                if constexpr (requires { g.outer_radius; }) { add(g.outer_radius, g.inner_radius); }
                if constexpr (requires { g.pitch; }) { add(g.pitch); }
                if constexpr (requires { g.corner_radius; }) { add(g.corner_radius, g.hole_radius); }
            }},
        geometry);
    return numbers;
}

bool are_same(const render::Geometry& a, const render::Geometry& b, double length) {
    const std::vector<double> p = numbers_of(a);
    const std::vector<double> q = numbers_of(b);
    return std::ranges::equal(
        p, q, [length](double x, double y) { return std::abs(x - y) <= kSamePlace * length; });
}

std::string owner_of(const render::Shape& shape, const Mechanism& mechanism) {
    const Pointable link = pointable_of(shape.id);
    if (link.kind == Pointable::Kind::body) { return name_of(Thing::body(link.index), mechanism); }
    if (link.kind == Pointable::Kind::joint) { return name_of(Thing::joint(link.index), mechanism); }
    return "part";
}

/// The solids of all pictures, one list per picture.
class Pictures {
public:
    Pictures(const Story& story, const PictureStyle& style, const std::vector<int>& steps)
        : story_(story), unit_(std::max(style.unit, 1e-9)) {
        for (const int step : steps) {
            std::vector<render::Shape> shapes = picture_of(story, style, step).scene.shapes;
            std::erase_if(shapes, [](const render::Shape& shape) { return shape.colour.a < 1.0F; });
            shapes_.push_back(std::move(shapes));
            states_.push_back(&story.steps()[at(step)].state);
        }
    }

    std::size_t count() const {
        return std::ranges::min(shapes_, {}, &std::vector<render::Shape>::size).size();
    }
    const render::Shape& first(std::size_t k) const { return shapes_.front()[k]; }

    /// Shape `k` in the frame of a body, if it keeps its place there.
    std::optional<render::Geometry> fixed_in(int body, std::size_t k) const {
        const render::Geometry place = in_body(body, 0, k);
        for (std::size_t moment = 1; moment < shapes_.size(); ++moment) {
            if (!are_same(place, in_body(body, moment, k), unit_)) { return std::nullopt; }
        }
        return place;
    }

    /// Bodies that shape `k` may be fixed in: its own body, or else all bodies, those of its joint first.
    std::vector<int> candidates(std::size_t k) const {
        const Pointable link = pointable_of(first(k).id);
        if (link.kind == Pointable::Kind::body) { return {link.index}; }
        std::vector<int> bodies;
        if (link.kind == Pointable::Kind::joint) {
            const Joint& joint = story_.lesson().mechanism.joints[at(link.index)];
            bodies = {joint.body_i, joint.body_j};
        }
        for (int b = 0; b < static_cast<int>(story_.lesson().mechanism.bodies.size()); ++b) {
            bodies.push_back(b);
        }
        return bodies;
    }

private:
    render::Geometry in_body(int body, std::size_t moment, std::size_t k) const {
        return moved(shapes_[moment][k].geometry, {picture::frame_of(*states_[moment], body)});
    }

    const Story& story_;
    double unit_;
    std::vector<std::vector<render::Shape>> shapes_;
    std::vector<const State*> states_;
};

}  // namespace

std::vector<RigidPart> rigid_parts_of(
    const Story& story, const PictureStyle& style, const std::vector<int>& steps) {
    const Pictures pictures(story, style, steps);
    std::vector<RigidPart> parts;
    std::map<std::string, int> counts;
    for (std::size_t k = 0; k < pictures.count(); ++k) {
        for (const int body : pictures.candidates(k)) {
            const std::optional<render::Geometry> place = pictures.fixed_in(body, k);
            if (!place) { continue; }
            const std::string owner = owner_of(pictures.first(k), story.lesson().mechanism);
            RigidPart part{body, owner + " · shape " + std::to_string(++counts[owner]), pictures.first(k)};
            part.shape.geometry = *place;
            part.shape.highlighted = false;
            parts.push_back(std::move(part));
            break;
        }
    }
    return parts;
}

}  // namespace jw
