#include <cmath>

#include "core/jets/euler_parameters.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/typed/typed.hpp"

namespace jw::reading {

namespace {

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
    fields.problems().add(
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
        reading.problems->add(
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
        reading.problems->add(
            Code::nothing_moves, tables.front().span(),
            "no body moves; expected at least one [[body]] that is not fixed");
    }
}

}  // namespace jw::reading
