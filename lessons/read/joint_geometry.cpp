#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "core/elementary/elementary.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/read/scalar_formula.hpp"

namespace jw::reading {

namespace {

// two points closer than this do not define a usable distance [m]
constexpr double kSmallestLength = 1e-9;

double degrees_between(const Vec3& a, const Vec3& b) {
    return elementary::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

/// The curve that a table gives by its harmonics.
Curve harmonics_in(Fields& fields) {
    Curve curve;
    if (const auto constant = fields.vector("constant")) { curve.constant = constant->value; }
    if (const auto linear = fields.vector("linear")) { curve.linear = linear->value; }
    const auto take = [&](const char* key, Vec3 Curve::Harmonic::*part) {
        const auto list = fields.vectors(key);
        if (!list) { return; }
        curve.harmonics.resize(std::max(curve.harmonics.size(), list->value.size()));
        for (std::size_t k = 0; k < list->value.size(); ++k) { curve.harmonics[k].*part = list->value[k]; }
    };
    take("cos", &Curve::Harmonic::cos);
    take("sin", &Curve::Harmonic::sin);
    return curve;
}

/// Reads the geometry of a joint whose type and bodies are known.
struct GeometryReader {
    Fields& fields;
    const BodyPair& pair;
    const JointType& type;
    JointGeometry& g;
    JointNeeds needs{type};

    /// Checks that either the global key or all local keys are there. @return false after reporting a mistake
    bool one_way(const std::string& global, const std::vector<std::string>& local, const std::string& what) {
        std::vector<std::string> absent;
        std::string locals;
        for (const std::string& key : local) {
            if (!fields.at_most_one({global, key})) { return false; }
            if (!fields.has(key)) { absent.push_back(key); }
            locals += (locals.empty() ? "" : " and ") + in_quotes(key);
        }
        if (fields.has(global) || absent.empty()) { return true; }
        fields.missing(
            absent.size() == local.size() ? global : absent.front(),
            what + ": " + in_quotes(global) + " (global, at the start pose) or " + locals +
                (local.size() > 1 ? " (in the bodies)" : " (in the first body)"));
        return false;
    }

    void read_points() {
        const auto at = fields.vector("at");
        const auto to = needs.two_points ? fields.vector("to") : std::nullopt;
        const auto point_i = fields.vector("point_i");
        const auto point_j = fields.vector("point_j");
        if (!one_way("at", {"point_i", "point_j"}, "a point, three numbers in m")) { return; }
        if (needs.two_points && fields.has("to") && !fields.has("at")) {
            fields.report(
                Code::lonely_key, fields.span("to"),
                "'to' without 'at'; expected both or 'point_i' and 'point_j'");
            return;
        }
        if (at) {
            g.P_i_local = pair.point_i(at->value);
            g.P_j_local = pair.point_j(to ? to->value : at->value);
            if (type.uses(Role::length)) {
                fields.require("to", "the point of the second body, global, in m");
            }
        }
        if (point_i) { g.P_i_local = point_i->value; }
        if (point_j) { g.P_j_local = point_j->value; }
    }

    /// Description of the second axis for the message about its absence.
    const char* second_axis() {
        if (type.uses(Role::bevel_i)) { return "the axis of the second wheel, global"; }
        if (type.uses(Role::rack_angle)) { return "the axis of the wheel, global, perpendicular to 'axis'"; }
        return "the arm of the second body, global, perpendicular to 'axis'";
    }

    void read_arms(const Located<Vec3>& axis) {
        fields.require("axis2", second_axis());
        const auto axis2 = fields.direction("axis2");
        if (!axis2) { return; }
        g.s_j_local = pair.vector_j(axis2->value.normalized());
        if (needs.right_angle && !is_perpendicular(axis.value, axis2->value)) {
            fields.report(
                Code::not_perpendicular, axis2->span,
                "'axis' and 'axis2' make an angle of " +
                    short_number(degrees_between(axis.value, axis2->value), 4) + " deg; expected 90 deg",
                "a start that is not assembled is given by 'axis_i' and 'axis_j'");
        }
    }

    /// @return whether the axes are known
    bool read_axes() {
        const int errors = fields.problems().errors_count();
        const auto axis = fields.direction("axis");
        const auto axis_i = fields.direction("axis_i");
        const auto axis_j = needs.axis_j ? fields.direction("axis_j") : std::nullopt;
        const std::vector<std::string> local =
            needs.axis_j ? std::vector<std::string>{"axis_i", "axis_j"} : std::vector<std::string>{"axis_i"};
        if (needs.arms) { fields.has("axis2"); }
        if (!one_way("axis", local, "an axis, three numbers")) { return false; }
        if (axis) {
            g.s_i_local = pair.vector_i(axis->value.normalized());
            if (needs.axis_j) { g.s_j_local = pair.vector_j(axis->value.normalized()); }
            if (needs.arms) { read_arms(*axis); }
        } else if (needs.arms && !fields.has("axis") && fields.has("axis2")) {
            fields.report(
                Code::lonely_key, fields.span("axis2"),
                "'axis2' without 'axis'; expected both or 'axis_i' and 'axis_j'");
        }
        if (axis_i) { g.s_i_local = axis_i->value; }
        if (axis_j) { g.s_j_local = axis_j->value; }
        return fields.problems().errors_count() == errors;
    }

    /// Checks that a side vector is perpendicular to the axis of its body. Otherwise it is an error if the
    /// angle is measured from it; for the h of n1, it is a warning, because the equation as typed still has a
    /// meaning.
    void check_side(const std::string& key, const Located<Vec3>& side, const Vec3& axis, bool must_be) {
        if (is_perpendicular(side.value, axis)) { return; }
        const std::string message = in_quotes(key) + " makes an angle of " +
                                    short_number(degrees_between(side.value, axis), 4) +
                                    " deg with the axis; expected 90 deg";
        const Vec3 s = axis.normalized();
        const Vec3 across = side.value - side.value.dot(s) * s;
        const std::string hint = across.norm() < kShortestDirection
                                     ? ""
                                     : "perpendicular: " + key + " = [" + short_number(across.x()) + ", " +
                                           short_number(across.y()) + ", " + short_number(across.z()) + "]";
        const Severity severity = must_be ? Severity::error : Severity::warning;
        fields.problems().add(Code::not_perpendicular, side.span, message, hint, severity);
    }

    /// Sides of wheels where the author gives none.
    void read_marks(const IfGiven<Vec3>& side) {
        if (side) {
            fields.report(
                Code::exclusive_keys, side->span,
                fields.what() +
                    " has 'side'; expected 'side_i' and 'side_j', or neither: then the sides lie on "
                    "the line between the wheels at the start");
        }
        if (!pair.sound) { return; }
        if (const auto line = wheel_line(pair, type, g)) {
            set_marks(pair, *line, g);
        } else if (type.uses(Role::bevel_i)) {
            fields.report(
                Code::zero_direction, fields.span(),
                fields.what() + ": the axes are parallel; expected two axes that are not",
                "for parallel axes use type = \"gear\"");
        } else {
            fields.report(
                Code::points_coincide, fields.span(),
                fields.what() + ": the two centres lie on one axis; expected a distance between the axes");
        }
    }

    void read_sides(bool axes_known) {
        const auto side = fields.direction("side");
        const auto side_i = fields.direction("side_i");
        const auto side_j = fields.direction("side_j");
        if (!axes_known) { return; }
        const bool any = fields.has("side") || fields.has("side_i") || fields.has("side_j");
        if (any && !one_way("side", {"side_i", "side_j"}, "a side vector, three numbers")) { return; }

        const Vec3 axis = pair.axis_i(g);
        if ((!side_i || !side_j) && type.has_own_coordinate()) {
            read_marks(side);
            return;
        }
        if (!side_i || !side_j) {
            if (side) { check_side("side", *side, axis, true); }
            set_sides(pair, type, side ? side->value.normalized() : perpendicular_to(axis), g);
            return;
        }
        // the direction of a rack is its line, and its side is not used
        const bool is_rack = type.uses(Role::rack_angle);
        if (!is_rack) { check_side("side_i", *side_i, g.s_i_local, type.has_marks()); }
        check_side("side_j", *side_j, g.s_j_local, type.has_marks());
        g.u_i_local = unit_of(side_i->value);
        g.u_j_local = unit_of(side_j->value);
        // as typed: the length of h scales the equation
        g.h_i_local = type.has_marks() ? g.u_i_local : side_i->value;
        g.h_j_local = type.has_marks() ? g.u_j_local : side_j->value;
    }

    void read_pitch() {
        const bool alone = fields.at_most_one({"pitch", "advance_per_rad"});
        if (alone && !fields.has("advance_per_rad")) {
            fields.require("pitch", "the advance in one turn [m], negative for a left-hand thread");
        }
        const auto pitch = fields.number("pitch");
        const auto alpha = fields.number("advance_per_rad");
        if (alone && pitch) { g.alpha = alpha_of_pitch(pitch->value); }
        if (alone && alpha) { g.alpha = alpha->value; }
    }

    /// Start values of the artificial coordinate.
    void read_theta() {
        if (const auto theta = fields.angle("theta")) { g.theta_start = theta->value; }
        g.theta_dot_start = read_angular_rate(fields, "theta_dot", &Fields::number);
    }

    /// Start rates of the freedoms that the joint has.
    void read_start_rates() {
        if (type.has_angle()) { g.angle_dot_start = read_angular_rate(fields, "angle_dot", &Fields::number); }
        if (!type.has_displacement()) { return; }
        if (const auto rate = fields.number("displacement_dot")) { g.displacement_dot_start = rate->value; }
    }

    /// The advance of a screw or a rack, once alpha is known.
    void read_advance() {
        // the start pose satisfies the equation unless the author gives another d_0 and theta_0
        const double d = start_displacement(pair, g);
        const double theta = start_theta(pair, type, g);
        const auto d_0 = fields.number("d_0");
        const auto theta_0 = fields.angle("theta_0");
        g.d_0 = d;
        g.theta_0 = theta;
        if (theta_0) {
            g.theta_0 = theta_0->value;
            g.d_0 = d - g.alpha * (theta - g.theta_0);
        }
        if (d_0) {
            g.d_0 = d_0->value;
            if (!theta_0 && g.alpha != 0.0) { g.theta_0 = theta - (d - g.d_0) / g.alpha; }
        }
    }

    void read_screw() {
        read_pitch();
        g.screw_angle_form = fields.word("angle_row", kAngleRows).value_or(g.screw_angle_form);
        read_theta();
        read_advance();
    }

    /// A number that must not be 0.
    std::optional<double> read_nonzero(const char* key, const char* expected) {
        fields.require(key, expected);
        const auto number = fields.number(key);
        if (!number) { return std::nullopt; }
        if (number->value != 0.0) { return number->value; }
        fields.report(
            Code::out_of_range, number->span, in_quotes(key) + std::string(" is 0; expected ") + expected);
        return std::nullopt;
    }

    void read_rack() {
        const auto radius = read_nonzero(
            "radius",
            "the radius of the wheel in m, negative if it moves along 'axis' when it turns left-handed");
        g.alpha = radius.value_or(1.0);
        read_theta();
        read_advance();
    }

    void read_radii() {
        const auto radii = fields.numbers("radii", 2, 2, "two radii in m");
        if (!radii) { return; }
        if (!(radii->value[0] > 0.0) || radii->value[1] == 0.0) {
            fields.report(
                Code::out_of_range, radii->span,
                "'radii' must be a positive number and one that is not 0, which is negative for the inner "
                "side of a ring or a crossed belt");
            return;
        }
        g.radii = {radii->value[0], radii->value[1]};
        g.ratio = (type.glyph == JointGlyph::belt ? 1.0 : -1.0) * g.radii[0] / g.radii[1];
    }

    void read_gear() {
        const char* const expected =
            "turns of the second wheel in one turn of the first, negative if they turn against each other, "
            "or 'radii'";
        g.ratio = 1.0;
        if (!fields.at_most_one({"ratio", "radii"})) { return; }
        if (fields.has("radii")) {
            read_radii();
        } else {
            g.ratio = read_nonzero("ratio", expected).value_or(1.0);
        }
        read_theta();
    }

    void read_curve() {
        fields.require("curve", "a table such as { points = [...] } or { cos = [...], sin = [...] }");
        const int errors = fields.problems().errors_count();
        auto curve = fields.table("curve");
        if (!curve) { return; }
        curve->call("the curve of " + fields.what());
        bool alone = true;
        for (const char* key : {"constant", "linear", "cos", "sin"}) {
            alone = alone && curve->at_most_one({"points", key});
        }
        if (const auto points = curve->vectors("points")) { g.curve = Curve::through(points->value); }
        const Curve given = harmonics_in(*curve);
        if (!curve->has("points")) { g.curve = given; }
        curve->finish();
        if (fields.problems().errors_count() > errors || !alone) { return; }
        // where the derivative of a curve is zero, it has no direction
        const double size = g.curve.at(0.0).c_u.norm() + g.curve.at(0.5 * std::numbers::pi).c_u.norm();
        constexpr int looked_at = 512;
        for (int k = 0; k < looked_at; ++k) {
            if (g.curve.at(2.0 * std::numbers::pi * k / looked_at).c_u.norm() > 1e-9 * size) { continue; }
            fields.report(
                Code::zero_direction, curve->span(),
                "the curve stands still at theta = " + short_number(360.0 * k / looked_at) +
                    " deg; expected points or harmonics that move on");
            return;
        }
        read_theta();
    }

    bool any(std::initializer_list<const char*> keys) const {
        return std::ranges::any_of(keys, [&](const char* key) { return fields.has(key); });
    }

    /// Vectors of a formula: those that are given; the others are the origins, z axes and x axes of the
    /// bodies.
    void read_formula_joint() {
        if (any({"at", "to", "point_i", "point_j"})) { read_points(); }
        const bool has_axis = any({"axis", "axis_i", "axis_j"});
        const bool axes_known = !has_axis || read_axes();
        if (has_axis || any({"side", "side_i", "side_j"})) { read_sides(axes_known); }
        fields.require("formula", "an equation of s_i, s_j, u_i, u_j, d, r_i, r_j, A_i and A_j");
        const auto formula = read_formula(
            fields, "formula", formula::constraint_formula,
            "s_i, s_j, u_i, u_j, d, r_i, r_j, A_i, A_j and numbers");
        if (formula) { g.formula = *formula; }
    }

    void read_length(bool points_known) {
        const auto length = fields.positive("length");
        if (length) { g.length = length->value; }
        if (fields.has("length") || !points_known || !pair.sound) { return; }
        g.length = pair.d(g.P_i_local, g.P_j_local).norm();
        if (g.length < kSmallestLength) {
            fields.report(
                Code::points_coincide, fields.span(),
                fields.what() + ": the two points coincide; expected a distance above 0",
                "for a spherical joint use type = \"spherical\"");
        }
    }

    /// Points, axes and sides.
    void read_vectors() {
        const int errors = fields.problems().errors_count();
        if (needs.points) { read_points(); }
        if (type.uses(Role::length)) { read_length(fields.problems().errors_count() == errors); }
        const bool axes_known = needs.axis && read_axes();
        if (needs.sides) { read_sides(axes_known); }
    }

    void read() {
        if (type.has_formula()) { return read_formula_joint(); }
        read_vectors();
        if (type.uses(Role::screw_advance)) { read_screw(); }
        if (type.uses(Role::rack_advance)) { read_rack(); }
        if (type.has_curve()) { read_curve(); }
        if (type.uses(Role::wheel_i) || type.uses(Role::bevel_i)) { read_gear(); }
        read_start_rates();
    }
};

}  // namespace

void read_geometry(Fields& fields, const BodyPair& pair, Joint& joint) {
    GeometryReader{fields, pair, *joint.type, joint.geometry}.read();
}

void read_axes_and_point(Fields& fields, const BodyPair& pair, JointGeometry& g) {
    // any type with one point, an axis and sides
    const auto has_frame = [](const JointType& type) {
        return type.uses(Role::same_point) && type.has_angle();
    };
    GeometryReader reader{fields, pair, *std::ranges::find_if(kJointTypes, has_frame), g};
    if (reader.any({"axis", "axis_i", "axis_j", "side", "side_i", "side_j"})) {
        return reader.read_vectors();
    }
    reader.read_points();
    g.s_i_local = pair.vector_i(Vec3::UnitZ());
    g.s_j_local = pair.vector_j(Vec3::UnitZ());
    set_sides(pair, reader.type, Vec3::UnitX(), g);
}

}  // namespace jw::reading
