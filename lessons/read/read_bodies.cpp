#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/jets/euler_parameters.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/typed/typed.hpp"

namespace jw::reading {

namespace {

// relative error of a tensor that is typed with four digits; a larger one is a mistake
constexpr double kTypedDigits = 1e-3;
// a moment that is smaller than this share of the largest is 0 up to rounding
constexpr double kNoMoment = 1e-13;

constexpr const char* kTensor = "[Jxx, Jyy, Jzz], [Jxx, Jyy, Jzz, Jxy, Jxz, Jyz] or three rows of three";

/// J' from three moments, six numbers or three rows.
IfGiven<Mat3> read_tensor(Fields& fields) {
    if (fields.is_nested("inertia")) { return fields.matrix("inertia"); }
    const auto list = fields.numbers("inertia", 0, 9, kTensor);
    if (!list) { return std::nullopt; }
    const std::vector<double>& n = list->value;
    Mat3 J = Mat3::Zero();
    if (n.size() == 3 || n.size() == 6) {
        J.diagonal() << n[0], n[1], n[2];
        if (n.size() == 6) {
            J(0, 1) = J(1, 0) = n[3];
            J(0, 2) = J(2, 0) = n[4];
            J(1, 2) = J(2, 1) = n[5];
        }
        return Located<Mat3>{J, list->span};
    }
    fields.report(
        Code::wrong_count, list->span,
        "'inertia' has " + std::to_string(n.size()) + (n.size() == 1 ? " entry" : " entries") +
            "; expected " + kTensor);
    return std::nullopt;
}

/// Reports moments of inertia that no body of positive mass has: 0 or less, or one larger than the other two
/// together.
/// @return true if `J` is possible; otherwise the reason has been reported
bool check_moments(Fields& fields, const Located<Mat3>& J) {
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(J.value, Eigen::EigenvaluesOnly).eigenvalues();
    const std::string text =
        short_number(moments(0)) + ", " + short_number(moments(1)) + ", " + short_number(moments(2));
    if (!(moments(0) > kNoMoment * moments(2)) || !(moments(2) > 0.0)) {
        fields.report(
            Code::impossible_inertia, J.span,
            "'inertia' has the principal moments " + text + "; expected all of them above 0",
            "no body has zero thickness: a rod of radius r has m r²/2 about its axis");
        return false;
    }
    if (moments(2) > (1.0 + kTypedDigits) * (moments(0) + moments(1))) {
        fields.report(
            Code::impossible_inertia, J.span,
            "'inertia' has the principal moments " + text +
                "; expected each at most as large as the other two together",
            "a box of edges a, b, c has m/12 [b² + c², a² + c², a² + b²]");
        return false;
    }
    return true;
}

std::optional<Mat3> read_inertia(Fields& fields) {
    auto J = read_tensor(fields);
    if (!J) { return std::nullopt; }
    const Mat3 skew = J->value - J->value.transpose();
    if (skew.cwiseAbs().maxCoeff() > kTypedDigits * J->value.cwiseAbs().maxCoeff()) {
        fields.report(
            Code::impossible_inertia, J->span,
            "'inertia' is not symmetric; expected Jxy = Jyx, Jxz = Jzx and Jyz = Jzy");
        return std::nullopt;
    }
    J->value = 0.5 * (J->value + J->value.transpose()).eval();
    if (!check_moments(fields, *J)) { return std::nullopt; }
    return J->value;
}

/// Keys `mass`, `inertia`, `centre`.
ReadMass read_mass(Fields& fields) {
    ReadMass out;
    for (const char* key : {"centre", "inertia", "mass"}) {
        if (!fields.has(key)) { continue; }
        out.span = fields.span(key);
        out.given = true;
    }
    if (!out.given) { return out; }
    const auto mass = fields.positive("mass");
    const auto J = read_inertia(fields);
    const auto centre = fields.vector("centre");
    fields.require("mass", "the mass in kg, beside 'inertia' and 'centre'");
    fields.require("inertia", "moments of inertia about the centre of mass [kg m²], beside 'mass'");
    if (mass && J) {
        out.properties = MassProperties{mass->value, centre ? centre->value : Vec3::Zero(), *J};
    }
    return out;
}

void read_p(Fields& fields, Body& body) {
    const auto list = fields.numbers("p", 4);
    if (!list) { return; }
    const Vec4 p = Eigen::Map<const Vec4>(list->value.data());
    const double length = p.norm();
    if (std::abs(length - 1.0) <= kUnitP) {
        body.p = p;
        return;
    }
    std::string hint = "no rotation is p = [1, 0, 0, 0]";
    if (length > kShortestDirection) {
        hint = "made unit: p = [";
        for (const double e : p) { hint += (hint.ends_with('[') ? "" : ", ") + short_number(e / length, 9); }
        hint += "]";
    }
    fields.report(
        Code::not_unit, list->span,
        "'p' has length " + short_number(length) + "; expected Euler parameters of length 1", hint);
}

void read_rotation(Fields& fields, Body& body) {
    auto rotation = fields.table("rotation");
    if (!rotation) { return; }
    const auto axis = rotation->direction("axis");
    const auto angle = rotation->angle("angle");
    rotation->require("axis", "the axis of rotation, three numbers");
    if (!rotation->has("angle_rad")) { rotation->require("angle_deg", "the angle of rotation"); }
    rotation->finish();
    if (axis && angle) { body.p = euler_parameters_of(axis->value, angle->value); }
}

void read_velocities(Fields& fields, Body& body) {
    if (const auto v = fields.vector("velocity")) { body.r_dot = v->value; }
    if (!fields.at_most_one(
            {"omega_local_rad_per_s", "omega_local_deg_per_s", "omega_global_rad_per_s",
             "omega_global_deg_per_s"})) {
        return;
    }
    const auto in_radians = [&](const std::string& key) {
        const auto rad = fields.vector(key + "_rad_per_s");
        const auto deg = fields.vector(key + "_deg_per_s");
        std::optional<Vec3> omega;
        if (rad) { omega = rad->value; }
        if (deg) { omega = deg->value.unaryExpr(&radians); }
        return omega;
    };
    if (const auto omega = in_radians("omega_local")) { body.omega_local = *omega; }
    if (const auto omega = in_radians("omega_global")) {
        body.omega_local = rotation_of(body).transpose() * *omega;
    }
}

void read_ground(Fields& fields, const Body& body, const Look& look, const ReadMass& mass, Reading& reading) {
    Body& ground = reading.lesson.mechanism.bodies[0];
    if (fields.has("fixed") && !body.fixed) {
        reading.report(
            Code::moving_ground, fields.span("fixed"), "the ground does not move; expected fixed = true");
    }
    ground = body;
    ground.fixed = true;
    reading.lesson.looks[0] = look;
    reading.masses[0] = mass;
}

void read_body(Fields& fields, Reading& reading) {
    const int errors = reading.problems->errors_count();
    std::vector<Body>& bodies = reading.lesson.mechanism.bodies;
    Body body;
    body.name = reading.declare(fields, Named::Kind::body, static_cast<int>(bodies.size()));
    if (const auto fixed = fields.flag("fixed")) { body.fixed = fixed->value; }
    if (const auto position = fields.vector("position")) { body.r = position->value; }
    if (fields.at_most_one({"p", "rotation", "axes"})) {
        read_p(fields, body);
        read_rotation(fields, body);
        if (const auto axes = read_frame(fields)) { body.p = euler_parameters_of(*axes); }
    }
    read_velocities(fields, body);
    const Look look{read_shapes(fields), read_colour(fields)};
    const ReadMass mass = read_mass(fields);
    fields.finish();
    if (reading.problems->errors_count() > errors) { reading.distrust(body.name); }
    if (body.name == "ground") {
        read_ground(fields, body, look, mass, reading);
        return;
    }
    if (fields.has("omega_global_rad_per_s") || fields.has("omega_global_deg_per_s")) {
        reading.omegas_global.push_back(static_cast<int>(bodies.size()));
    }
    bodies.push_back(body);
    reading.lesson.looks.push_back(look);
    reading.masses.push_back(mass);
}

}  // namespace

void read_bodies(Fields& root, Reading& reading) {
    Body ground;
    ground.name = "ground";
    ground.fixed = true;
    reading.lesson.mechanism.bodies.push_back(ground);
    reading.lesson.looks.emplace_back();
    reading.masses.emplace_back();
    std::vector<Fields> tables = root.tables("body", kMostBodies);
    for (Fields& fields : tables) { read_body(fields, reading); }
    // declared or not, the ground is body 0
    const auto [there, is_new] = reading.names.try_emplace("ground", Named{});
    there->second.index = 0;
    if (tables.empty() && !root.has("body")) {
        root.missing("body", "at least one [[body]] that moves");
    } else if (!tables.empty() && reading.lesson.mechanism.moving_bodies_count() == 0) {
        reading.report(
            Code::nothing_moves, tables.front().span(),
            "no body moves; expected at least one [[body]] that is not fixed");
    }
}

}  // namespace jw::reading
