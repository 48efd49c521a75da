#pragma once

#include <algorithm>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

#include "app/session/picture/picture.hpp"

/// Parts that picture.cpp puts together.
namespace jw::picture {

inline constexpr double kWholeTurn = 2.0 * std::numbers::pi;

/// A body's frame at a state.
struct BodyFrame {
    Mat3 A = Mat3::Identity();
    Vec3 r = Vec3::Zero();

    Vec3 point(const Vec3& s_local) const { return r + A * s_local; }
    Vec3 direction(const Vec3& s_local) const { return (A * s_local).normalized(); }
};
BodyFrame frame_of(const State& state, int body);

/// A joint's vectors at a state, global; directions unit.
struct PlacedJoint {
    const Joint* joint = nullptr;
    int index = 0;  ///< in the mechanism
    BodyFrame frame_i, frame_j;
    Vec3 P_i, P_j;
    Vec3 s_i, s_j;
    Vec3 h_i, h_j;
    Vec3 u_i, u_j;

    /// Along s_i, from P_i to P_j [m].
    double displacement() const { return s_i.dot(P_j - P_i); }
};
PlacedJoint placed(const Mechanism& mechanism, int joint, const State& state);

/// True if the equations of a joint contain one of `vectors`, or its author's formula one of `of_author`.
bool contains(const Joint& joint, jw::Vectors vectors, std::initializer_list<FormulaVector> of_author);

/// Radius of a pin; other sizes are multiples of it.
inline double pin_radius(double unit) { return 0.011 * unit; }
/// Radius of the shaft of a vector.
inline double vector_radius(double unit) { return 0.0042 * unit; }

/// Unit direction to the side of a line in the picture: perpendicular to the line and to the view.
Vec3 beside(const PictureStyle& style, const Vec3& line);

render::Colour colour_of_body(const Lesson& lesson, int body);
/// @param alpha below 1 for a ghost
void add_body(
    const Lesson& lesson, const PictureStyle& style, const State& state, int body, float alpha,
    render::Scene& scene);
/// Point where a body's name may stand [m].
Vec3 middle_of_body(const PictureStyle& style, const State& state, int body);

/// Adds the glyph of a joint; its two halves are apart where it is not assembled.
void add_joint(
    const Lesson& lesson, const PictureStyle& style, const PlacedJoint& joint, bool highlighted,
    render::Scene& scene);

/// Teeth of a joint's wheels, which fit those of the joints before it; none if it has no wheels.
/// @param style  with the styles of the joints before it
WheelStyle wheel_style(const Mechanism& mechanism, const PictureStyle& style, int joint, const State& state);
struct WheelColours {
    render::Colour i;
    render::Colour j;
};
/// Adds the wheels of a gear, a belt or a rack.
void add_wheels(
    const PictureStyle& style, const PlacedJoint& joint, const WheelColours& colours, bool highlighted,
    render::Scene& scene);

/// Points and vectors of the joint that the step is about, with their names.
void add_vectors(const PictureStyle& style, const PlacedJoint& joint, Picture& picture);
/// A dashed line where the two points of a joint should meet but do not.
void add_gap(const PictureStyle& style, const PlacedJoint& joint, Picture& picture);

/// Adds the symbol of a driver: an arc for an angle, an arrow for a distance.
void add_driver(
    const Lesson& lesson, const PictureStyle& style, const State& state, int driver, Picture& picture);

/// Keeps the first of all names that `repeats(first, name)` says mean the same.
template <class Repeats>
void leave_out_repeated(std::vector<Annotation>& names, Repeats&& repeats) {
    for (std::size_t k = 0; k < names.size(); ++k) {
        const Annotation first = names[k];
        const auto rest = names.begin() + static_cast<std::ptrdiff_t>(k) + 1;
        const auto is_repeated = [&](const Annotation& name) { return repeats(first, name); };
        names.erase(std::remove_if(rest, names.end(), is_repeated), names.end());
    }
}

/// A vector with its name at the tip.
void add_vector(
    const PictureStyle& style, const Vec3& from, const Vec3& to, const render::Colour& colour,
    const std::string& name, Picture& picture);
/// The distance between two points, its name beside its middle: an arrow, or dashes where it is too short for
/// one.
void add_distance(
    const PictureStyle& style, const Vec3& from, const Vec3& to, const std::string& name, Picture& picture);

/// Springs as coils, dampers as dashpots, dry friction along an axis as pads, rotational springs as spirals,
/// bushings as sleeves.
void add_springs(const Lesson& lesson, const PictureStyle& style, const State& state, render::Scene& scene);

/// Sets the lengths of the arrows of forces and torques from typical values of the story.
void set_reaction_scales(const Story& story, PictureStyle& style);
/// Adds the reactions of joints and drivers on their second bodies, in dynamics.
void add_reactions(const PictureStyle& style, const Reactions& reactions, Picture& picture);

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

/// Some bodies of a mechanism; by default all of them.
class BodyChoice {
public:
    BodyChoice() = default;
    explicit BodyChoice(std::vector<bool> chosen) : chosen_(std::move(chosen)) {}
    bool contains(int body) const { return chosen_.empty() || chosen_[at(body)]; }

private:
    std::vector<bool> chosen_;
};

/// Everything of a step except the ground plane and the path.
/// @param bodies  shown, with their joints; what the step is about is always shown
Picture compose(
    const Story& story, const PictureStyle& style, const Step& step, int index,
    const BodyChoice& bodies = {});

}  // namespace jw::picture
