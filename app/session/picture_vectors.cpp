#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/picture_parts.hpp"
#include "core/assembler.hpp"

namespace jw::picture {

namespace {

namespace palette = render::palette;

// of the picture's unit
constexpr double kVectorLength = 0.20;
constexpr double kSideLength = 0.13;
constexpr double kShaft = 0.0042;
constexpr double kApart = 0.022;  // between two vectors that would lie on each other

class Vectors {
public:
    Vectors(const PictureStyle& style, const PlacedJoint& joint, Picture& picture)
        : j_(joint), unit_(style.unit), picture_(&picture) {}

    void draw() {
        const JointType& type = *j_.joint->type;
        const bool moves_apart = type.uses(Role::distance_parallel) ||
                                 type.uses(Role::distance_perpendicular) || type.uses(Role::screw_advance) ||
                                 type.uses(Role::length);
        const bool has_points = moves_apart || type.uses(Role::same_point);
        const std::string name = type.uses(Role::same_point) || type.uses(Role::length) ? "P" : "B";
        if (has_points) { points(name); }
        axes(type);
        if (type.uses(Role::sides_perpendicular)) { sides("@h", j_.h_i, j_.h_j); }
        if (type.uses(Role::screw_angle)) { sides("@u", j_.u_i, j_.u_j); }
        if (moves_apart && gap() > 0.02 * unit_) {
            arrow(j_.P_i, j_.P_j, palette::kVectorD, "@d", 0.5);
        } else if (type.uses(Role::same_point) && gap() > 1e-3 * unit_) {
            picture_->scene.polylines.push_back({{j_.P_i, j_.P_j}, 2.0, palette::kBad, true});
        }
    }

private:
    double gap() const { return (j_.P_j - j_.P_i).norm(); }

    void point(const Vec3& at, const std::string& name) {
        render::Shape dot{render::Sphere{at, 0.010 * unit_}, palette::kPoint};
        dot.see_through = true;
        picture_->scene.shapes.push_back(dot);
        picture_->annotations.push_back({at, Vec3::Zero(), name, palette::kPoint});
    }
    void points(const std::string& name) {
        // drawn as one where the eye cannot tell them apart
        if (gap() < 0.012 * unit_) {
            point(j_.P_i, name);
        } else {
            point(j_.P_i, name + "_i");
            point(j_.P_j, name + "_j");
        }
    }
    /// @param where along the arrow its name stands: 1 at the tip
    void arrow(
        const Vec3& from, const Vec3& to, const render::Colour& colour, const std::string& name,
        double where = 1.0) {
        picture_->scene.arrows.push_back({from, to, kShaft * unit_, colour});
        const Vec3 towards = where > 0.9 ? Vec3((to - from).normalized()) : Vec3::Zero();
        picture_->annotations.push_back({from + where * (to - from), towards, name, colour});
    }
    void axes(const JointType& type) {
        const bool uses_i = type.uses(Role::axes_parallel) || type.uses(Role::axes_perpendicular) ||
                            type.uses(Role::distance_parallel) || type.uses(Role::distance_perpendicular);
        const bool uses_j = type.uses(Role::axes_parallel) || type.uses(Role::axes_perpendicular);
        // two arrows on one line are drawn side by side
        const bool on_one_line = uses_j && std::abs(j_.s_i.dot(j_.s_j)) > 0.995 &&
                                 (j_.P_j - j_.P_i).cross(j_.s_i).norm() < kApart * unit_;
        const Vec3 aside = on_one_line ? Vec3(kApart * unit_ * perpendicular_to(j_.s_i)) : Vec3::Zero();
        const double length = kVectorLength * unit_;
        if (uses_i) { arrow(j_.P_i + aside, j_.P_i + aside + length * j_.s_i, palette::kVectorI, "@s_i"); }
        if (uses_j) {
            arrow(j_.P_j - aside, j_.P_j - aside + 0.82 * length * j_.s_j, palette::kVectorJ, "@s_j");
        }
    }
    void sides(const std::string& name, const Vec3& i, const Vec3& j) {
        const double length = kSideLength * unit_;
        arrow(j_.P_i, j_.P_i + length * i, palette::kVectorI, name + "_i");
        arrow(j_.P_j, j_.P_j + 0.85 * length * j, palette::kVectorJ, name + "_j");
    }

    const PlacedJoint& j_;
    double unit_;
    Picture* picture_;
};

constexpr int kArcPoints = 48;  // a full turn looks round with so many

/// From u_i to u_j about s_i, with what marks its ends.
void add_angle(const PictureStyle& style, const PlacedJoint& j, double angle, Picture& picture) {
    const double radius = 0.15 * style.unit;
    const Vec3 v = j.s_i.cross(j.u_i);
    // whole turns lie on each other
    const double shown = std::remainder(angle, 4.0 * std::numbers::pi);
    const int count =
        std::max(2, static_cast<int>(std::ceil(kArcPoints * std::abs(shown) / (2.0 * std::numbers::pi))));
    render::Polyline arc{{}, 2.5, palette::kVectorD};
    for (int k = 0; k <= count; ++k) {
        const double a = shown * k / count;
        arc.points.push_back(j.P_i + radius * (std::cos(a) * j.u_i + std::sin(a) * v));
    }
    const Vec3 middle = std::cos(0.5 * shown) * j.u_i + std::sin(0.5 * shown) * v;
    picture.annotations.push_back({j.P_i + radius * middle, middle, "θ", palette::kVectorD});
    picture.scene.polylines.push_back(std::move(arc));
    const double length = 1.25 * radius;
    picture.scene.arrows.push_back({j.P_i, j.P_i + length * j.u_i, kShaft * style.unit, palette::kVectorI});
    picture.annotations.push_back({j.P_i + length * j.u_i, j.u_i, "@u_i", palette::kVectorI});
    picture.scene.arrows.push_back({j.P_i, j.P_i + length * j.u_j, kShaft * style.unit, palette::kVectorJ});
    picture.annotations.push_back({j.P_i + length * j.u_j, j.u_j, "@u_j", palette::kVectorJ});
}

void add_length(const PictureStyle& style, const Vec3& from, const Vec3& to, Picture& picture) {
    if ((to - from).norm() < 0.01 * style.unit) { return; }
    picture.scene.arrows.push_back({from, to, kShaft * style.unit, palette::kVectorD});
    picture.annotations.push_back({0.5 * (from + to), Vec3::Zero(), "@d", palette::kVectorD});
}

}  // namespace

void add_vectors(const PictureStyle& style, const PlacedJoint& joint, Picture& picture) {
    Vectors(style, joint, picture).draw();
}

void add_driver(
    const Lesson& lesson, const PictureStyle& style, const State& state, int driver, Picture& picture) {
    const Mechanism& mechanism = lesson.mechanism;
    const Driver& d = mechanism.drivers[static_cast<std::size_t>(driver)];
    if (d.joint >= 0) {
        const auto k = static_cast<std::size_t>(d.joint);
        const PlacedJoint joint = placed(mechanism.joints[k], state);
        if (std::holds_alternative<AngleMeasure>(d.measure)) {
            add_angle(style, joint, relative_angle(mechanism.joints[k], state), picture);
        } else if (std::holds_alternative<ThetaMeasure>(d.measure)) {
            const int theta = mechanism.theta_indices()[k];
            add_angle(style, joint, state.theta[static_cast<std::size_t>(theta)], picture);
        } else {
            add_length(style, joint.P_i, joint.P_j, picture);
        }
        return;
    }
    const BodyFrame i = frame_of(state, d.body_i);
    const BodyFrame j = frame_of(state, d.body_j);
    if (const auto* m = std::get_if<SquaredDistanceMeasure>(&d.measure)) {
        add_length(style, i.point(m->P_i_local), j.point(m->P_j_local), picture);
    } else if (const auto* c = std::get_if<CoordinateMeasure>(&d.measure);
               c != nullptr && c->coordinate < 3) {
        const Vec3 axis = Vec3::Unit(c->coordinate);
        picture.scene.arrows.push_back(
            {j.r - j.r(c->coordinate) * axis, j.r, kShaft * style.unit, palette::kVectorD});
        constexpr const char* names[] = {"x", "y", "z"};
        picture.annotations.push_back(
            {j.r - 0.5 * j.r(c->coordinate) * axis, Vec3::Zero(), names[c->coordinate], palette::kVectorD});
    }
}

}  // namespace jw::picture
