#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "app/session/picture/picture_parts.hpp"
#include "core/elementary/elementary.hpp"

/// Wheels of gears, belts and racks. Their radii follow from the ratio and the distance of their axes, and
/// teeth mesh because both wheels are turned by the angles that the equations relate.
namespace jw::picture {

namespace {

namespace palette = render::palette;

// teeth of the smaller wheel: as many as give the other a whole number
constexpr int kFewestTeeth = 16;
constexpr int kMostTeeth = 30;
// more teeth are not seen as teeth
constexpr int kMostOnWheel = 200;
constexpr int kTeethOnRack = 20;
// heights of a tooth beyond the pitch circle and below it, in modules
constexpr double kAddendum = 1.0;
constexpr double kDedendum = 1.25;

Vec3 turned_about(const Vec3& axis, double angle, const Vec3& v) {
    const auto [sine, cosine] = elementary::sine_and_cosine(angle);
    return axis.dot(v) * axis + cosine * (v - axis.dot(v) * axis) + sine * axis.cross(v);
}

/// Right-handed angle about `axis` from e to u [rad].
double angle_about(const Vec3& axis, const Vec3& e, const Vec3& u) {
    return elementary::atan2(e.cross(u).dot(axis), e.dot(u));
}

/// A wheel and its place on the line where it meets the other.
struct DrawnWheel {
    Vec3 centre = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();
    Vec3 u = Vec3::UnitX();
    Vec3 contact = Vec3::UnitX();  ///< from the centre to where the wheels meet, unit, across the axis
    double angle = 0.0;            ///< from the line to u [rad]
    double radius = 0.0;           ///< of the pitch circle
    bool is_ring = false;

    /// Direction of a tooth: `number` teeth from where the wheels meet at angle 0.
    Vec3 tooth(double number, int teeth) const {
        return turned_about(axis, angle + kWholeTurn * number / teeth, contact);
    }
};

struct WheelPair {
    DrawnWheel i;
    DrawnWheel j;
};

DrawnWheel wheel_of(
    const PlacedJoint& joint, bool of_j, const Vec3& line, const Vec3& contact, double radius) {
    DrawnWheel w;
    w.centre = of_j ? joint.P_j : joint.P_i;
    w.axis = of_j ? joint.s_j : joint.s_i;
    w.u = of_j ? joint.u_j : joint.u_i;
    w.contact = contact;
    w.angle = angle_about(w.axis, line, w.u);
    w.radius = radius;
    return w;
}

/// Line of centres: from centre to centre, across the axis of i; zero if both lie on it.
Vec3 between_axes(const PlacedJoint& joint) {
    const Vec3 d = joint.P_j - joint.P_i;
    return d - joint.s_i.dot(d) * joint.s_i;
}

/// Wheels with parallel axes. Their radii are in proportion to the ratio: their sum is the distance, or their
/// difference if one is a ring.
WheelPair spur_wheels(const PlacedJoint& joint) {
    const double n = joint.joint->geometry.ratio;
    const std::array<double, 2>& given = joint.joint->geometry.radii;
    const Vec3 across = between_axes(joint);
    const double D = across.norm();
    const Vec3 e = across.normalized();
    const double apart = n < 0.0 ? 1.0 - n : std::abs(1.0 - n);
    const double radius_i = given[0] > 0.0 ? given[0] : apart > 0.0 ? std::abs(n) * D / apart : 0.5 * D;
    const double radius_j = given[0] > 0.0 ? std::abs(given[1]) : apart > 0.0 ? D / apart : 0.5 * D;
    const bool ring_i = n > 0.0 && radius_i > radius_j;
    const bool ring_j = n > 0.0 && radius_j > radius_i;
    WheelPair pair{
        wheel_of(joint, false, e, ring_j ? Vec3(-e) : e, radius_i),
        wheel_of(joint, true, e, ring_i ? e : Vec3(-e), radius_j)};
    pair.i.is_ring = ring_i;
    pair.j.is_ring = ring_j;
    return pair;
}

/// Wheels whose axes meet in an apex. They touch along the axis of their relative motion.
WheelPair bevel_wheels(const PlacedJoint& joint) {
    const Vec3 normal = joint.s_i.cross(joint.s_j);
    const Vec3 d = joint.P_j - joint.P_i;
    const Vec3 apex = joint.P_i + d.cross(joint.s_j).dot(normal) / normal.squaredNorm() * joint.s_i;
    Vec3 c = joint.s_i - joint.joint->geometry.ratio * joint.s_j;
    if (c.dot(joint.P_i - apex) < 0.0) { c = -c; }
    const auto wheel = [&](bool of_j) {
        const Vec3& s = of_j ? joint.s_j : joint.s_i;
        const double height = std::abs(s.dot((of_j ? joint.P_j : joint.P_i) - apex));
        const Vec3 across = c - c.dot(s) * s;
        const double slope = across.norm() / std::max(std::abs(c.dot(s)), 1e-3 * c.norm());
        return wheel_of(joint, of_j, normal.normalized(), across.normalized(), height * slope);
    };
    return {wheel(false), wheel(true)};
}

/// The pinion of a rack: only the wheel of j.
WheelPair rack_wheel(const PlacedJoint& joint) {
    const double alpha = joint.joint->geometry.alpha;
    const Vec3 contact = (alpha < 0.0 ? -1.0 : 1.0) * joint.s_j.cross(joint.s_i).normalized();
    return {{}, wheel_of(joint, true, joint.s_i, contact, std::abs(alpha))};
}

/// The toothed wheels of a joint; nothing if it has none, or if their contact is undefined at this pose.
std::optional<WheelPair> toothed_wheels(const PlacedJoint& joint) {
    switch (joint.joint->type->glyph) {
        case JointGlyph::gear: {
            const WheelPair pair = spur_wheels(joint);
            return pair.i.contact.allFinite() ? std::optional(pair) : std::nullopt;
        }
        case JointGlyph::bevel: {
            const WheelPair pair = bevel_wheels(joint);
            const bool sound = pair.i.contact.allFinite() && pair.j.contact.allFinite();
            return sound ? std::optional(pair) : std::nullopt;
        }
        case JointGlyph::rack: return rack_wheel(joint);
        default: return std::nullopt;
    }
}

/// Teeth of two wheels: as few as make whole numbers for both.
WheelStyle new_teeth(double radius_i, double radius_j) {
    const double ratio = std::max(radius_i, radius_j) / std::min(radius_i, radius_j);
    int best = kFewestTeeth;
    double least = 1.0;
    for (int n = kFewestTeeth; n <= kMostTeeth; ++n) {
        const double off = std::abs(ratio * n - std::round(ratio * n));
        if (off < least - 1e-9) {
            least = off;
            best = n;
        }
    }
    const int many = static_cast<int>(std::round(std::min<double>(ratio * best, kMostOnWheel)));
    return radius_i < radius_j ? WheelStyle{best, many} : WheelStyle{many, best};
}

/// Wheels of the joints before, whose teeth are known.
class KnownWheels {
public:
    KnownWheels(const Mechanism& mechanism, const PictureStyle& style, int before, const State& state)
        : unit_(style.unit) {
        for (int k = 0; k < before; ++k) {
            const PlacedJoint joint = placed(mechanism, k, state);
            const auto pair = toothed_wheels(joint);
            if (!pair) { continue; }
            const WheelStyle& wheels = style.joints[at(k)].wheels;
            if (wheels.teeth_i > 0) { add(joint.joint->body_i, pair->i, wheels.teeth_i, wheels.offset_i); }
            add(joint.joint->body_j, pair->j, wheels.teeth_j, wheels.offset_j);
        }
    }
    /// Teeth of the wheel, if they are known, with their offset from where `w` meets another.
    std::optional<std::pair<int, double>> find(int body, const DrawnWheel& w) const {
        for (const Known& known : known_) {
            const bool same = known.body == body && (known.wheel.centre - w.centre).norm() < 1e-3 * unit_ &&
                              known.wheel.axis.cross(w.axis).norm() < 1e-3 &&
                              std::abs(known.wheel.radius - w.radius) < 1e-3 * w.radius;
            if (!same) { continue; }
            const double angle = angle_about(w.axis, w.tooth(0.0, known.teeth), known.tooth);
            const double offset = angle * known.teeth / kWholeTurn;
            return std::pair{known.teeth, offset - std::floor(offset)};
        }
        return std::nullopt;
    }

private:
    struct Known {
        int body;
        DrawnWheel wheel;
        int teeth;
        Vec3 tooth;
    };
    void add(int body, const DrawnWheel& w, int teeth, double offset) {
        known_.push_back({body, w, teeth, w.tooth(offset, teeth)});
    }

    double unit_;
    std::vector<Known> known_;
};

class WheelsGlyph {
public:
    WheelsGlyph(
        const PictureStyle& style, const PlacedJoint& placed, const WheelColours& colours, bool highlighted,
        render::Scene& scene)
        : joint_style_(&style.joints[at(placed.index)]),
          j_(placed),
          g_(pin_radius(style.unit)),
          colours_(&colours),
          highlighted_(highlighted),
          scene_(&scene) {}

    void draw() {
        if (j_.joint->type->glyph == JointGlyph::belt) { return belt(); }
        const auto pair = toothed_wheels(j_);
        if (!pair) { return; }
        const WheelStyle& style = joint_style_->wheels;
        toothed(pair->j, style.teeth_j, style.offset_j, colours_->j);
        if (j_.joint->type->glyph == JointGlyph::rack) {
            rack(pair->j);
        } else {
            toothed(pair->i, style.teeth_i, style.offset_i, colours_->i);
        }
    }

private:
    void add(const render::Geometry& geometry, const render::Colour& colour) {
        scene_->shapes.push_back({geometry, colour, highlighted_, false});
    }
    double half_width() const { return 1.6 * g_; }

    void toothed(const DrawnWheel& w, int teeth, double offset, const render::Colour& colour) {
        if (teeth <= 0) { return; }
        const double module = 2.0 * w.radius / teeth;
        const Vec3 half = half_width() * w.axis;
        // teeth of a ring point to its centre
        const double inside = w.is_ring ? -1.0 : 1.0;
        const double root = w.radius - inside * kDedendum * module;
        if (w.is_ring) {
            add(render::Tube{w.centre - half, w.centre + half, root + 2.5 * module, root}, colour);
        } else {
            add(render::Cylinder{w.centre - half, w.centre + half, root}, colour);
        }
        const double middle = w.radius + inside * 0.5 * (kAddendum - kDedendum) * module;
        const double half_thickness = 0.23 * kWholeTurn * 0.5 * module;
        for (int k = 0; k < teeth; ++k) {
            const Vec3 out = w.tooth(k + offset, teeth);
            Mat3 A;
            A << out, w.axis.cross(out), w.axis;
            add(
                render::Box{
                    {A, w.centre + middle * out},
                    {0.5 * (kAddendum + kDedendum) * module, half_thickness, half_width()}},
                colour);
        }
        mark(w, w.is_ring ? root + 1.3 * module : 0.6 * w.radius);
    }
    /// Adds dots towards u, which show how the wheel turns.
    void mark(const DrawnWheel& w, double at) {
        const double radius = std::min(1.1 * g_, 0.18 * w.radius);
        for (const double side : {-1.0, 1.0}) {
            add(render::Sphere{w.centre + at * w.u + side * half_width() * w.axis, radius}, palette::kSteel);
        }
    }

    void belt() {
        const Vec3 across = between_axes(j_);
        const double D = across.norm();
        const Vec3 e = across.normalized();
        if (!e.allFinite()) { return; }
        const double n = j_.joint->geometry.ratio;
        const std::array<double, 2>& given = j_.joint->geometry.radii;
        constexpr double larger = 0.3;  // share of the distance
        const double radius_i = given[0] > 0.0 ? given[0] : larger * D * std::min(std::abs(n), 1.0);
        const double radius_j =
            given[0] > 0.0 ? std::abs(given[1]) : larger * D * std::min(1.0 / std::abs(n), 1.0);
        for (const bool of_j : {false, true}) {
            const DrawnWheel w = wheel_of(j_, of_j, e, e, of_j ? radius_j : radius_i);
            const Vec3 half = half_width() * w.axis;
            add(render::Cylinder{w.centre - half, w.centre + half, w.radius - 0.4 * g_},
                of_j ? colours_->j : colours_->i);
            mark(w, 0.6 * w.radius);
        }
        const bool crossed = n < 0.0;
        const double sine = std::clamp((radius_i - (crossed ? -radius_j : radius_j)) / D, -1.0, 1.0);
        const double cosine = std::sqrt(1.0 - sine * sine);
        const Vec3 side = j_.s_i.cross(e);
        std::array<Vec3, 2> normals;  // of the two straight parts
        for (std::size_t k = 0; k < 2; ++k) {
            normals[k] = sine * e + (k == 0 ? cosine : -cosine) * side;
            const Vec3 at_j = crossed ? Vec3(-normals[k]) : normals[k];
            strand(j_.P_i + radius_i * normals[k], j_.P_j + radius_j * at_j);
        }
        const double wrapped = kWholeTurn - angle_between(normals[0], normals[1], e);
        arc(j_.P_i, radius_i, normals[0], wrapped);
        const Vec3 from = crossed ? Vec3(-normals[0]) : normals[0];
        arc(j_.P_j, radius_j, from, crossed ? wrapped : wrapped - kWholeTurn);
    }
    /// Angle between the two normals on the side of e.
    double angle_between(const Vec3& a, const Vec3& b, const Vec3& e) const {
        const double angle = elementary::atan2(a.cross(b).norm(), a.dot(b));
        return (a + b).dot(e) >= 0.0 ? angle : kWholeTurn - angle;
    }
    void strand(const Vec3& from, const Vec3& to) { add(render::Rod{from, to, 0.45 * g_}, palette::kInk); }
    /// Part of a belt around a wheel: from the direction `from` through an angle about s_i.
    void arc(const Vec3& centre, double radius, const Vec3& from, double angle) {
        const int parts = std::max(4, static_cast<int>(std::ceil(std::abs(angle) / 0.2)));
        for (int k = 0; k < parts; ++k) {
            const auto at = [&](int n) {
                return Vec3(centre + radius * turned_about(j_.s_i, angle * n / parts, from));
            };
            strand(at(k), at(k + 1));
        }
    }

    void rack(const DrawnWheel& pinion) {
        const JointGeometry& g = j_.joint->geometry;
        const int teeth = joint_style_->wheels.teeth_j;
        const double module = 2.0 * pinion.radius / teeth;
        const double step = kWholeTurn * pinion.radius / teeth;
        // a gap of the rack stands where the wheel has a tooth
        const double gap = g.d_0 - g.alpha * (g.theta_0 + kWholeTurn * joint_style_->wheels.offset_j / teeth);
        const double margin = 3.0 * step;
        const auto first = static_cast<int>(std::floor((joint_style_->lowest - margin - gap) / step));
        const auto last = static_cast<int>(std::ceil((joint_style_->highest + margin - gap) / step));
        Mat3 A;
        A << j_.s_i, j_.s_j.cross(j_.s_i).normalized(), j_.s_j;
        // points of the pitch line where the displacement of the wheel is 0, and x
        const Vec3 zero = j_.P_j - j_.displacement() * j_.s_i + pinion.radius * pinion.contact;
        const auto along = [&](double x) { return Vec3(zero + x * j_.s_i); };
        const Vec3 out = -0.5 * (kAddendum - kDedendum) * module * pinion.contact;
        for (int k = first; k < std::min(last, first + 2 * kMostOnWheel); ++k) {
            add(
                render::Box{
                    {A, along(gap + (k + 0.5) * step) + out},
                    {0.23 * step, 0.5 * (kAddendum + kDedendum) * module, half_width()}},
                colours_->i);
        }
        const double from = gap + first * step;
        const double to = gap + last * step;
        constexpr double half_height = 1.3;  // of the bar, in modules
        add(
            render::Box{
                {A, along(0.5 * (from + to)) + (kDedendum + half_height) * module * pinion.contact},
                {0.5 * (to - from), half_height * module, half_width()}},
            colours_->i);
    }

    const JointStyle* joint_style_;
    const PlacedJoint& j_;
    double g_;
    const WheelColours* colours_;
    bool highlighted_;
    render::Scene* scene_;
};

}  // namespace

WheelStyle wheel_style(const Mechanism& mechanism, const PictureStyle& style, int joint, const State& state) {
    const PlacedJoint placed_joint = placed(mechanism, joint, state);
    const auto pair = toothed_wheels(placed_joint);
    if (!pair) { return {}; }
    const Joint& of = *placed_joint.joint;
    const KnownWheels known(mechanism, style, joint, state);
    const auto on_j = known.find(of.body_j, pair->j);
    if (of.type->glyph == JointGlyph::rack) {
        return on_j ? WheelStyle{0, on_j->first, 0.0, on_j->second} : WheelStyle{0, kTeethOnRack, 0.0, 0.0};
    }
    const auto on_i = known.find(of.body_i, pair->i);
    const auto in_proportion = [](int teeth, double radius, double other) {
        return std::clamp(static_cast<int>(std::round(teeth * radius / other)), 1, kMostOnWheel);
    };
    // a tooth of i at an angle meets a gap of j at ratio times that angle
    const double sense = of.geometry.ratio < 0.0 ? -1.0 : 1.0;
    WheelStyle out = new_teeth(pair->i.radius, pair->j.radius);
    if (on_i) {
        out.teeth_i = on_i->first;
        out.teeth_j = in_proportion(on_i->first, pair->j.radius, pair->i.radius);
        out.offset_i = on_i->second;
    } else if (on_j) {
        out.teeth_i = in_proportion(on_j->first, pair->i.radius, pair->j.radius);
        out.offset_i = sense * (on_j->second - 0.5);
    }
    out.offset_j = 0.5 + sense * out.offset_i;
    if (on_j) {
        out.teeth_j = on_j->first;
        out.offset_j = on_j->second;
    }
    return out;
}

void add_wheels(
    const PictureStyle& style, const PlacedJoint& joint, const WheelColours& colours, bool highlighted,
    render::Scene& scene) {
    WheelsGlyph(style, joint, colours, highlighted, scene).draw();
}

}  // namespace jw::picture
