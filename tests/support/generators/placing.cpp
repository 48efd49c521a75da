#include "tests/support/generators/placing.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/formula_value.hpp"
#include "tests/support/vector_formulas.hpp"

namespace jw::test {

namespace {

// axes of the same direction, or through the same point, whatever else the joint is
constexpr std::array kPlanarTypes{"revolute", "prismatic", "cylindrical", "planar", "spherical", "distance"};
constexpr std::array kConcurrentTypes{"revolute", "spherical", "universal"};

const Body& at(const Mechanism& mechanism, int body) {
    return mechanism.bodies[static_cast<std::size_t>(body)];
}
Vec3 local(const Body& body, const Vec3& v) { return rotation_matrix(body.p).transpose() * v; }
Vec3 local_point(const Body& body, const Vec3& point) { return local(body, point - body.r); }

/// Sets the sides that a lesson gives for this type of joint; they are unit and perpendicular to the axes.
void set_sides(Joint& joint, const Body& i, const Body& j, const Vec3& side_i, const Vec3& side_j) {
    JointGeometry& g = joint.geometry;
    g.h_i_local = g.u_i_local = local(i, side_i);
    g.h_j_local = g.u_j_local = local(j, side_j);
}

/// θ of the pose with some whole turns, and the d_0 that goes with it.
void set_thread(Joint& joint, const Body& i, const Body& j, Random& random, double length) {
    JointGeometry& g = joint.geometry;
    g.alpha = length * random.number(0.05, 0.5) * (random.number() < 0.0 ? -1.0 : 1.0);
    const Mat3 A_i = rotation_matrix(i.p);
    const Mat3 A_j = rotation_matrix(j.p);
    const Vec3 s = A_i * g.s_i_local.normalized();
    const Vec3 u_i = A_i * g.u_i_local;
    const Vec3 u_j = A_j * g.u_j_local;
    const double turns = std::floor(random.number(-2.0, 3.0));
    const double theta = std::atan2(u_i.cross(u_j).dot(s), u_i.dot(u_j)) + 2.0 * std::numbers::pi * turns;
    const Vec3 d = j.r + A_j * g.P_j_local - i.r - A_i * g.P_i_local;
    g.theta_0 = random.number();
    g.d_0 = s.dot(d) - g.alpha * (theta - g.theta_0);
    g.theta_start = theta;
}

/// Wheels that mesh in this pose: some numbers of teeth, some turns of the first wheel, and a second u that
/// fits.
void set_wheels(Joint& joint, const Body& i, const Body& j, Random& random, double length) {
    JointGeometry& g = joint.geometry;
    const Mat3 A_i = rotation_matrix(i.p);
    const Mat3 A_j = rotation_matrix(j.p);
    const Vec3 s_i = A_i * g.s_i_local.normalized();
    const Vec3 s_j = A_j * g.s_j_local.normalized();
    const Vec3 d = j.r + A_j * g.P_j_local - i.r - A_i * g.P_i_local;
    const auto angle = [](const Vec3& e, const Vec3& u, const Vec3& s) {
        return std::atan2(e.cross(u).dot(s), e.dot(u));
    };
    const double turns = std::floor(random.number(-2.0, 3.0));
    if (joint.type->name == "rack") {
        g.alpha = length * random.number(0.1, 0.5) * (random.number() < 0.0 ? -1.0 : 1.0);
        g.u_j_local = (random.number() * Vec3(A_j.transpose() * s_i) +
                       random.number() * Vec3(A_j.transpose() * s_j.cross(s_i)))
                          .normalized();
        const double theta = angle(s_i, A_j * g.u_j_local, s_j) + 2.0 * std::numbers::pi * turns;
        g.theta_0 = random.number();
        g.d_0 = s_i.dot(d) - g.alpha * (theta - g.theta_0);
        g.theta_start = theta;
        return;
    }
    const auto teeth = [&] { return std::floor(random.number(8.0, 30.0)); };
    g.ratio = teeth() / teeth() * (random.number() < 0.0 ? -1.0 : 1.0);
    const Vec3 e = joint.type->name == "bevel-gear" ? s_i.cross(s_j) : d;
    const double theta = angle(e, A_i * g.u_i_local, s_i) + 2.0 * std::numbers::pi * turns;
    g.theta_start = theta;
    const Vec3 along = (e - e.dot(s_j) * s_j).normalized();
    const double other = g.ratio * theta;
    g.u_j_local = A_j.transpose() * (std::cos(other) * along + std::sin(other) * s_j.cross(along));
}

/// An equation of an author that holds in this pose. It knows no global direction, and it is regular as long
/// as the points are apart and s_i and s_j are not parallel.
void set_formula(Joint& joint, const Body& i, const Body& j, Random& random, double length) {
    using namespace authored;
    using enum FormulaVector;
    JointGeometry& g = joint.geometry;
    const std::array left{
        dot(s_i, s_j),
        dot(s_i, d),
        dot(d, d),
        square_root(dot(d, d)) - number(0.3 * length) * dot(u_i, u_j),
        dot(u_i, d) + number(length) * sine(dot(s_i, s_j)),
        dot(s_j, d) / (number(2.0) + power(dot(u_i, u_j), 2.0))};
    const Part& one = left[static_cast<std::size_t>(random.number(0.0, 0.999) * left.size())];
    const auto A = [](const Body& body) { return rotation_matrix(body.p).cast<long double>().eval(); };
    const std::vector<long double> variables =
        formula_variables(g, i.r.cast<long double>(), A(i), j.r.cast<long double>(), A(j));
    g.formula = equation(one, static_cast<double>(formula_value(one.steps, variables)));
}

}  // namespace

Placing::Placing(const Recipe& recipe)
    : family_(recipe.family),
      length_(std::pow(10.0, recipe.length_decade)),
      beside_(recipe.near > 0 ? std::pow(10.0, -recipe.near) : 1.0) {
    Random random(static_cast<unsigned>(recipe.seed) * 7919U + 17U);
    origin_ = random.vector(length_);
    normal_ = random.direction();
    along_ = perpendicular_to(normal_);
}

Body Placing::ground() const {
    Body body;
    body.name = "ground";
    body.fixed = true;
    return body;
}

Body Placing::body(const std::string& name, int seed) const {
    Random random(static_cast<unsigned>(seed) * 104729U + 1U);
    Body body;
    body.name = name;
    body.p = random.unit_p();
    body.r = point(random) + random.vector(0.3 * length_);
    body.r_dot = random.vector(length_);
    body.omega_local = random.vector(2.0);
    return body;
}

/// Point near the line of the scene, or anywhere about it; in the plane if the scene is planar.
Vec3 Placing::point(Random& random) const {
    const double reach = random.number(-1.0, 1.0);
    Vec3 off = random.vector(beside_);
    if (family_ == Family::planar) { off -= off.dot(normal_) * normal_; }
    return origin_ + length_ * (reach * along_ + off);
}

Vec3 Placing::axis(Random& random, const Vec3& through, const JointType& type) const {
    const Vec3 any = random.direction();
    switch (family_) {
        case Family::general: return beside_ == 1.0 ? any : (normal_ + beside_ * any).normalized();
        case Family::planar: {
            if (type.name != "prismatic") { return normal_; }
            return normal_.cross(any).norm() > 0.1 ? normal_.cross(any).normalized() : along_;
        }
        case Family::concurrent: break;
    }
    const Vec3 out = through - origin_;
    return out.norm() > 0.05 * length_ ? out.normalized() : any;
}

const JointType& Placing::type_of(int number) const {
    const auto pick = [&](const auto& names) -> const JointType& {
        return *find_joint_type(names[static_cast<std::size_t>(number) % names.size()]);
    };
    if (family_ == Family::planar) { return pick(kPlanarTypes); }
    if (family_ == Family::concurrent) { return pick(kConcurrentTypes); }
    return kJointTypes[static_cast<std::size_t>(number) % kJointTypes.size()];
}

Joint Placing::joint(
    const Mechanism& mechanism, const JointType& type, int i, int j, int form, int seed) const {
    Random random(static_cast<unsigned>(seed) * 15485863U + 3U);
    const Body& body_i = at(mechanism, i);
    const Body& body_j = at(mechanism, j);
    Joint joint;
    joint.name = "joint " + std::to_string(mechanism.joints.size() + 1);
    joint.type = &type;
    joint.body_i = i;
    joint.body_j = j;
    const bool parallel = std::ranges::any_of(type.roles, is_parallel);
    if (parallel) { joint.parallel_form = static_cast<ParallelForm>(form % 6); }
    JointGeometry& g = joint.geometry;

    // global, at the pose of the bodies; balls of concurrent axes sit where these meet
    Vec3 P_i = point(random);
    const bool in_the_middle = family_ == Family::concurrent && type.name != "revolute";
    if (in_the_middle) { P_i = origin_; }
    const Vec3 s_i = axis(random, P_i, type);
    Vec3 P_j = P_i;
    const Vec3 across = perpendicular_to(s_i);
    const double turn = random.number(-3.0, 3.0);
    const Vec3 side = std::cos(turn) * across + std::sin(turn) * s_i.cross(across);
    Vec3 s_j = s_i;
    if (type.uses(Role::axes_perpendicular)) { s_j = side; }
    if (type.uses(Role::distance_parallel)) { P_j += length_ * random.number(-1.0, 1.0) * s_i; }
    if (type.uses(Role::distance_perpendicular)) { P_j += length_ * random.number(0.2, 1.0) * side; }
    const auto part = [&] {
        P_j = point(random);
        if ((P_j - P_i).norm() < 0.2 * length_) { P_j += length_ * along_; }
    };
    if (type.uses(Role::length)) {
        if (!type.uses(Role::distance_perpendicular)) { part(); }
        g.length = (P_j - P_i).norm();
    }
    if (type.has_formula()) {
        part();
        s_j = (side + random.number(-1.0, 1.0) * s_i).normalized();
    }
    if (type.name == "gear" || type.name == "belt") { P_j += length_ * random.number(0.2, 1.0) * side; }
    if (type.name == "rack") {
        s_j = side;
        P_j = point(random);
    }
    if (type.name == "bevel-gear") { s_j = (side + random.number(-1.0, 1.0) * s_i).normalized(); }
    // perpendicular to the link, too
    if (type.uses(Role::distance_perpendicular_j)) { s_j = s_i.cross(side); }
    g.P_i_local = local_point(body_i, P_i);
    g.P_j_local = local_point(body_j, P_j);
    // lengths of axes scale equations and change nothing else
    g.s_i_local = random.number(0.5, 2.0) * local(body_i, s_i);
    g.s_j_local = random.number(0.5, 2.0) * local(body_j, s_j);
    Vec3 side_j = side;
    if (type.uses(Role::sides_perpendicular)) { side_j = s_i.cross(across); }
    if (type.has_formula()) { side_j = s_i.cross(side); }
    set_sides(joint, body_i, body_j, across, side_j);
    if (type.has_formula()) { set_formula(joint, body_i, body_j, random, length_); }
    if (type.uses(Role::screw_advance)) { set_thread(joint, body_i, body_j, random, length_); }
    if (type.name == "curve") {
        const double theta = random.number(-3.0, 3.0);
        const auto arm = [&] { return random.vector(0.5 * length_); };
        g.curve.harmonics = {{arm(), arm()}, {0.2 * arm(), 0.2 * arm()}};
        if (random.number() < 0.0) { g.curve.linear = arm(); }
        g.P_j_local = local_point(body_j, point(random));
        const Vec3 P = body_j.r + rotation_matrix(body_j.p) * g.P_j_local;
        g.curve.constant = local_point(body_i, P) - g.P_i_local - g.curve.at(theta).c;
        g.theta_start = theta;
    } else if (type.has_own_coordinate()) {
        set_wheels(joint, body_i, body_j, random, length_);
    }
    return joint;
}

}  // namespace jw::test
