#include <algorithm>
#include <cmath>

#include "app/session/picture/picture_parts.hpp"
#include "lessons/lesson/things.hpp"

namespace jw::picture {

namespace {

namespace palette = render::palette;

// lengths in the picture's unit
constexpr double kVectorLength = 0.20;
constexpr double kSideLength = 0.10;  // of h and u beyond the surface of the bodies
constexpr double kApart = 0.024;      // between two vectors that would lie on each other
constexpr double kPoint = 0.010;      // radius
constexpr double kOnePoint = 0.012;   // nearer points are seen as one
constexpr double kShort = 0.05;       // shorter vectors would be only a head

/// A direction as it is seen in the picture, unit; zero if it is seen end-on.
Vec3 on_picture(const PictureStyle& style, const Vec3& direction) {
    const Vec3 seen = direction - direction.dot(style.view) / style.view.squaredNorm() * style.view;
    return seen.norm() > 0.1 * direction.norm() ? Vec3(seen.normalized()) : Vec3::Zero();
}

/// 1 where two lines lie on each other, 0 where they look apart anyway; continuous in between.
double overlap(const Vec3& a, const Vec3& b, double distance, double apart) {
    constexpr double wide = 0.2;  // rad
    if (a.isZero() || b.isZero()) { return 0.0; }
    const double by_angle = 1.0 - a.cross(b).norm() / wide;
    const double by_distance = 2.0 - distance / apart;
    return std::clamp(std::min(by_angle, by_distance), 0.0, 1.0);
}

class Vectors {
public:
    Vectors(const PictureStyle& style, const PlacedJoint& joint, Picture& picture)
        : j_(joint),
          joint_style_(style.joints[at(joint.index)]),
          style_(style),
          unit_(style.unit),
          picture_(&picture) {}

    void draw() {
        const Joint& joint = *j_.joint;
        const JointType& type = *joint.type;
        const bool uses_d = contains(joint, kD, {FormulaVector::d});
        if (type.uses(Role::same_point) ||
            contains(joint, kD, {FormulaVector::d, FormulaVector::r_i_P, FormulaVector::r_j_P})) {
            const bool is_P = type.uses(Role::same_point) || type.uses(Role::length) || type.has_formula();
            points(is_P ? "P" : "B");
        }
        axes(contains(joint, kAxisI, {FormulaVector::s_i}), contains(joint, kAxisJ, {FormulaVector::s_j}));
        if (type.uses(kSidesH)) { sides("\\mathbf{h}", &j_.h_i, &j_.h_j); }
        const bool uses_u_i = contains(joint, kSidesU, {FormulaVector::u_i});
        const bool uses_u_j = contains(joint, kSidesU, {FormulaVector::u_j});
        sides("\\mathbf{u}", uses_u_i ? &j_.u_i : nullptr, uses_u_j ? &j_.u_j : nullptr);
        if (uses_d) {
            const Vec3 aside = aside_of_d(type);
            add_distance(style_, j_.P_i + aside, j_.P_j + aside, "\\mathbf{d}", *picture_);
        }
        if (type.uses(Role::same_point)) { add_gap(style_, j_, *picture_); }
    }

private:
    double gap() const { return (j_.P_j - j_.P_i).norm(); }

    void point(const Vec3& at, const std::string& name) {
        render::Shape dot{render::Sphere{at, kPoint * unit_}, palette::kPoint};
        dot.see_through = true;
        picture_->scene.shapes.push_back(dot);
        picture_->annotations.push_back({at, Vec3::Zero(), name, palette::kPoint});
    }
    void points(const std::string& name) {
        if (gap() < kOnePoint * unit_) { return point(j_.P_i, name); }
        point(j_.P_i, name + "_i");
        point(j_.P_j, name + "_j");
    }
    Vec3 seen(const Vec3& direction) const { return on_picture(style_, direction); }
    /// Overlap of the arrows s_i and s_j: 1 if one would hide the other.
    double axes_overlap() const {
        const Vec3 apart = j_.P_j - j_.P_i;
        const double distance = std::abs(apart.dot(beside(style_, j_.s_i)));
        return overlap(seen(j_.s_i), seen(j_.s_j), distance, kApart * unit_);
    }
    void axes(bool uses_i, bool uses_j) {
        // one on each side of their common line
        const double half = uses_j ? 0.5 * kApart * unit_ * axes_overlap() : 0.0;
        const double sense = beside(style_, j_.s_i).dot(beside(style_, j_.s_j)) < 0.0 ? -1.0 : 1.0;
        if (uses_i) {
            aside_i_ = std::max(half, margin(joint_style_.aside_i));
            const Vec3 foot = j_.P_i + aside_i_ * beside(style_, j_.s_i);
            add_vector(
                style_, foot, foot + length_of(j_.s_i) * j_.s_i, palette::kVectorI, "\\mathbf{s}_i",
                *picture_);
        }
        if (uses_j) {
            const double aside = sense * std::max(half, margin(joint_style_.aside_j));
            const Vec3 foot = j_.P_j - aside * beside(style_, j_.s_j);
            add_vector(
                style_, foot, foot + 0.82 * length_of(j_.s_j) * j_.s_j, palette::kVectorJ, "\\mathbf{s}_j",
                *picture_);
        }
    }
    /// Length of the arrow of s: longer if it is seen nearly end-on, so that more than its head is visible.
    double length_of(const Vec3& s) const {
        constexpr double long_enough = 0.6;
        const double seen = s.cross(style_.view).norm() / style_.view.norm();
        return kVectorLength * unit_ * std::clamp(long_enough / std::max(seen, 0.1), 1.0, 1.8);
    }
    double margin(double aside) const { return aside > 0.0 ? aside + 0.4 * kApart * unit_ : 0.0; }

    /// Offset of d, which runs from point to point, to beside s_i or the rod of a distance joint where these
    /// would hide it.
    Vec3 aside_of_d(const JointType& type) const {
        const Vec3 d = j_.P_j - j_.P_i;
        if (d.norm() < kOnePoint * unit_) { return Vec3::Zero(); }
        const Vec3 side = beside(style_, d.normalized());
        if (type.uses(Role::length)) { return kApart * unit_ * side; }
        const double way = beside(style_, j_.s_i).dot(side) < 0.0 ? -1.0 : 1.0;
        const double along = overlap(seen(j_.s_i), seen(d), 0.0, kApart * unit_);
        return way * along * (aside_i_ + kApart * unit_) * side;
    }
    /// Adds two vectors, one below and one above if they lie on each other, like u_i and u_j at angle zero.
    /// @param i  null where the equations do not contain it
    void sides(const std::string& name, const Vec3* i, const Vec3* j) {
        const double length = joint_style_.side + kSideLength * unit_;
        const bool both = i != nullptr && j != nullptr;
        const double same = both && i->dot(*j) > 0.0 ? overlap(*i, *j, 0.0, kApart * unit_) : 0.0;
        const double half = 0.5 * kApart * unit_ * same;
        if (i != nullptr) {
            const Vec3 foot = j_.P_i - std::max(half, margin(joint_style_.lift_i)) * j_.s_i;
            add_vector(style_, foot, foot + length * *i, palette::kVectorI, name + "_i", *picture_);
        }
        if (j != nullptr) {
            const Vec3 foot = j_.P_j + std::max(half, margin(joint_style_.lift_j)) * j_.s_j;
            add_vector(style_, foot, foot + 0.9 * length * *j, palette::kVectorJ, name + "_j", *picture_);
        }
    }

    const PlacedJoint& j_;
    const JointStyle& joint_style_;
    const PictureStyle& style_;
    double unit_;
    double aside_i_ = 0.0;
    Picture* picture_;
};

}  // namespace

bool contains(const Joint& joint, jw::Vectors vectors, std::initializer_list<FormulaVector> of_author) {
    if (!joint.type->has_formula()) { return joint.type->uses(vectors); }
    return contains_any(joint.geometry.formula, of_author);
}

Vec3 beside(const PictureStyle& style, const Vec3& line) {
    const Vec3 side = line.cross(style.view);
    // a line seen end-on has no side
    return side.norm() > 1e-3 * style.view.norm() ? Vec3(side.normalized()) : perpendicular_to(line);
}

void add_vector(
    const PictureStyle& style, const Vec3& from, const Vec3& to, const render::Colour& colour,
    const std::string& name, Picture& picture) {
    picture.scene.arrows.push_back({from, to, vector_radius(style.unit), colour});
    picture.annotations.push_back({to, (to - from).normalized(), name, colour});
}

void add_distance(
    const PictureStyle& style, const Vec3& from, const Vec3& to, const std::string& name, Picture& picture) {
    const double length = (to - from).norm();
    if (length < kOnePoint * style.unit) { return; }
    if (length < kShort * style.unit) {
        picture.scene.polylines.push_back({{from, to}, 3.0, palette::kVectorD, true});
    } else {
        picture.scene.arrows.push_back({from, to, vector_radius(style.unit), palette::kVectorD});
    }
    const Vec3 side = beside(style, (to - from).normalized());
    picture.annotations.push_back({0.5 * (from + to), side, name, palette::kVectorD});
}

void add_vectors(const PictureStyle& style, const PlacedJoint& joint, Picture& picture) {
    Vectors(style, joint, picture).draw();
}

void add_gap(const PictureStyle& style, const PlacedJoint& joint, Picture& picture) {
    if ((joint.P_j - joint.P_i).norm() < kOnePoint * style.unit) { return; }
    picture.scene.polylines.push_back({{joint.P_i, joint.P_j}, 2.5, palette::kBad, true});
}

}  // namespace jw::picture
