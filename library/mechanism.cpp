#include "jointwise/mechanism.hpp"

#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/model/placement.hpp"
#include "library/inside.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

void expect(bool holds, const std::string& what) {
    if (!holds) { throw std::invalid_argument("jointwise: " + what); }
}

/// @param things  bodies, joints or drivers
template <class T>
void expect_new_name(const std::string& name, const std::vector<T>& things) {
    expect(!name.empty(), "a name is empty; expected one to call it by in messages");
    for (const T& thing : things) {
        expect(thing.name != name, "the name '" + name + "' is taken; expected another");
    }
}

void expect_index(int index, std::size_t count, const std::string& what) {
    expect(
        index >= 0 && static_cast<std::size_t>(index) < count,
        "there is no " + what + " " + std::to_string(index) + "; the last is " +
            std::to_string(static_cast<int>(count) - 1));
}

template <class V>
void expect_finite(const V& v, const std::string& what) {
    expect(v.allFinite(), what + " is not finite");
}

Vector3 unit(const Vector3& v, const std::string& what) {
    expect(v.allFinite() && v.norm() > 0.0, what + " is zero or not finite; expected a direction");
    return v.normalized();
}

double nonzero(const std::optional<double>& number, const std::string& what) {
    expect(number.has_value() && std::isfinite(*number) && *number != 0.0, what);
    return *number;
}

jw::JointGeometry geometry_of(const jw::JointType& type, const jw::BodyPair& pair, const Place& place) {
    const jw::JointNeeds needs(type);
    const Vector3 to = place.to.value_or(place.at);
    expect_finite(place.at, "at");
    expect_finite(to, "to");
    jw::JointGeometry g;
    g.P_i_local = pair.point_i(place.at);
    g.P_j_local = pair.point_j(to);
    if (needs.axis) {
        const Vector3 axis = unit(place.axis, "axis");
        expect(!needs.arms || place.axis2, "axis2 is absent; expected the axis of the second body");
        const Vector3 axis2 = needs.arms ? unit(*place.axis2, "axis2") : axis;
        expect(
            !needs.right_angle || jw::is_perpendicular(axis, axis2), "axis and axis2 are not perpendicular");
        g.s_i_local = pair.vector_i(axis);
        g.s_j_local = pair.vector_j(axis2);
    }
    if (needs.sides && type.has_own_coordinate()) {
        const auto line = jw::wheel_line(pair, type, g);
        expect(line.has_value(), "the wheels have no line between them; expected other axes or points");
        jw::set_marks(pair, *line, g);
    } else if (needs.sides) {
        const Vector3 axis = unit(place.axis, "axis");
        const Vector3 side = place.side ? unit(*place.side, "side") : Vector3(jw::perpendicular_to(axis));
        expect(jw::is_perpendicular(axis, side), "side is not perpendicular to the axis");
        jw::set_sides(pair, type, side, g);
    }
    if (type.uses(jw::Role::length)) {
        g.length = (to - place.at).norm();
        expect(g.length > 0.0, "at and to coincide; expected two points with a distance");
    }
    if (type.uses(jw::Role::screw_advance)) {
        expect(
            place.pitch.has_value(),
            "pitch is absent; expected the advance in one turn [m], negative for a left-hand thread");
        expect(std::isfinite(*place.pitch), "pitch is not finite");
        g.alpha = *place.pitch / (2.0 * std::numbers::pi);
        g.d_0 = (to - place.at).dot(unit(place.axis, "axis"));
    }
    if (type.has_curve()) {
        expect(
            place.curve.size() >= 3, "curve has fewer than three points; expected those of a closed curve");
        g.curve = jw::Curve::through(place.curve);
    } else if (type.uses(jw::Role::rack_advance)) {
        g.alpha = nonzero(place.radius, "radius is absent or 0; expected that of the wheel on the rack [m]");
        g.d_0 = (to - place.at).dot(unit(place.axis, "axis"));
    } else if (type.has_own_coordinate()) {
        g.ratio = nonzero(
            place.ratio, "ratio is absent or 0; expected the turns of the second wheel in one of the first");
    }
    return g;
}

template <class T>
std::vector<std::string> names_of(const std::vector<T>& things) {
    std::vector<std::string> names;
    for (const T& thing : things) { names.push_back(thing.name); }
    return names;
}

}  // namespace

Mechanism::Mechanism() : inside_(std::make_shared<Inside>()) {
    jw::Body ground;
    ground.name = "ground";
    ground.fixed = true;
    inside_->mechanism.bodies.push_back(ground);
    inside_->loads.masses.emplace_back();
}
Mechanism::Mechanism(const Inside& inside) : inside_(std::make_shared<Inside>(inside)) {
    inside_->loads.masses.resize(inside_->mechanism.bodies.size());
}

/// The data for a change; data that other mechanisms share are copied first.
Mechanism::Inside& Mechanism::own() {
    if (inside_.use_count() > 1) { inside_ = std::make_shared<Inside>(*inside_); }
    // another thread may have read the copy that was given up last: that reading must come first
    std::atomic_thread_fence(std::memory_order_acquire);
    return *inside_;
}

int Mechanism::add_body(const std::string& name, const Argument<3>& r, const Argument<4>& p) {
    expect_new_name(name, inside_->mechanism.bodies);
    expect_finite(r, "r of body '" + name + "'");
    expect(p.allFinite() && p.norm() > 0.0, "p of body '" + name + "' is zero or not finite");
    jw::Body body;
    body.name = name;
    body.r = r;
    body.p = p.normalized();
    Inside& mine = own();
    mine.mechanism.bodies.push_back(body);
    mine.loads.masses.emplace_back();
    return static_cast<int>(mine.mechanism.bodies.size()) - 1;
}

int Mechanism::add_joint(
    const std::string& name, const std::string& type, int body_i, int body_j, const Place& place) {
    const std::vector<jw::Body>& bodies = inside_->mechanism.bodies;
    expect_new_name(name, inside_->mechanism.joints);
    expect_new_name(name, inside_->mechanism.drivers);
    expect_index(body_i, bodies.size(), "body");
    expect_index(body_j, bodies.size(), "body");
    expect(body_i != body_j, "joint '" + name + "' connects a body with itself; expected two bodies");
    jw::Joint joint;
    joint.name = name;
    joint.type = jw::find_joint_type(type);
    expect(joint.type != nullptr, "there is no joint type '" + type + "'; joint_types() lists them");
    expect(
        !joint.type->has_formula(), "the equation of a joint of type '" + type +
                                        "' is text, which only lessons contain; expected another type, or "
                                        "read_lesson_text() of a lesson with this joint");
    joint.body_i = body_i;
    joint.body_j = body_j;
    const jw::BodyPair pair{
        &bodies[static_cast<std::size_t>(body_i)], &bodies[static_cast<std::size_t>(body_j)]};
    joint.geometry = geometry_of(*joint.type, pair, place);
    own().mechanism.joints.push_back(joint);
    return static_cast<int>(inside_->mechanism.joints.size()) - 1;
}

int Mechanism::add_driver(const std::string& name, int joint, const Polynomial& value) {
    const std::vector<jw::Joint>& joints = inside_->mechanism.joints;
    expect_new_name(name, joints);
    expect_new_name(name, inside_->mechanism.drivers);
    expect_index(joint, joints.size(), "joint");
    for (const double c : value) { expect(std::isfinite(c), "the function of '" + name + "' is not finite"); }
    const jw::Joint& along = joints[static_cast<std::size_t>(joint)];
    const jw::JointType& type = *along.type;
    expect(
        type.has_angle() || type.has_displacement(),
        "joint '" + along.name + "' has no angle and no displacement that could be driven");
    jw::Driver driver;
    driver.name = name;
    driver.joint = joint;
    driver.body_i = along.body_i;
    driver.body_j = along.body_j;
    driver.measure = type.artificial > 0 ? jw::Measure(jw::ThetaMeasure{})
                     : type.has_angle()  ? jw::Measure(jw::angle_of(along))
                                         : jw::Measure(jw::displacement_of(along));
    driver.function.polynomial = value;
    own().mechanism.drivers.push_back(driver);
    return static_cast<int>(inside_->mechanism.drivers.size()) - 1;
}

void Mechanism::set_velocity(int body, const Argument<3>& r_dot, const Argument<3>& omega_local) {
    expect_index(body, inside_->mechanism.bodies.size(), "body");
    expect_finite(r_dot, "r_dot");
    expect_finite(omega_local, "omega_local");
    jw::Body& mine = own().mechanism.bodies[static_cast<std::size_t>(body)];
    mine.r_dot = r_dot;
    mine.omega_local = omega_local;
}

void Mechanism::set_mass(
    int body, double mass, const Argument<3, 3>& J_local, const Argument<3>& centre_local) {
    expect_index(body, inside_->loads.masses.size(), "body");
    expect(std::isfinite(mass) && mass > 0.0, "a mass is not positive");
    expect_finite(J_local, "J_local");
    expect_finite(centre_local, "centre_local");
    own().loads.masses[static_cast<std::size_t>(body)] = jw::MassProperties{mass, centre_local, J_local};
}

void Mechanism::set_gravity(const Argument<3>& g) {
    expect_finite(g, "gravity");
    own().loads.gravity = g;
}

void Mechanism::add_spring(
    int body_i, const Argument<3>& P_i_local, int body_j, const Argument<3>& P_j_local, double k,
    double free_length, double c) {
    const std::size_t bodies = inside_->mechanism.bodies.size();
    expect_index(body_i, bodies, "body");
    expect_index(body_j, bodies, "body");
    expect(body_i != body_j, "a spring connects a body with itself; expected two bodies");
    expect_finite(P_i_local, "P_i_local");
    expect_finite(P_j_local, "P_j_local");
    expect_finite(Vector3(k, free_length, c), "a spring");
    own().loads.springs.push_back({body_i, body_j, P_i_local, P_j_local, k, free_length, c});
}

std::vector<std::string> Mechanism::body_names() const { return names_of(inside_->mechanism.bodies); }
std::vector<std::string> Mechanism::joint_names() const { return names_of(inside_->mechanism.joints); }
std::vector<std::string> Mechanism::driver_names() const { return names_of(inside_->mechanism.drivers); }

std::vector<std::string> joint_types() {
    std::vector<std::string> names;
    for (const jw::JointType& type : jw::kJointTypes) {
        if (!type.has_formula()) { names.emplace_back(type.name); }
    }
    return names;
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
