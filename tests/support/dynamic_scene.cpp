#include "tests/support/dynamic_scene.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "core/quantity/names.hpp"
#include "lessons/typed/typed.hpp"

namespace jw::test {

namespace {

Colour colour_named(std::string_view name) {
    const auto found = std::ranges::find(kNamedColours, name, &NamedColour::name);
    if (found == kNamedColours.end()) { throw std::invalid_argument("no colour " + std::string(name)); }
    const auto part = [&](unsigned shift) {
        return static_cast<double>(found->rgb >> shift & 0xFFU) / 255.0;
    };
    return {part(16U), part(8U), part(0U)};
}

/// Inertia rounded to 15 digits: 0.1 · 0.1 = 0.01, as anybody would type it. Far below what any reference is
/// known to.
Mat3 typed(const Mat3& J) {
    return J.unaryExpr([](double x) {
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "%.15g", x);
        return std::strtod(text.data(), nullptr);
    });
}

/// J' about the point that `arm` leads to from the centre of mass (Steiner).
Mat3 moved_tensor(const MassProperties& mass, const Vec3& arm) {
    return mass.J_local + mass.mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
}

}  // namespace

MassProperties box_mass(double mass, const Vec3& edges) {
    const Vec3 squares = edges.cwiseProduct(edges);
    const Vec3 others(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
    return {mass, Vec3::Zero(), typed((mass / 12.0 * others).asDiagonal())};
}

MassProperties together(const MassProperties& a, const MassProperties& b) {
    const double mass = a.mass + b.mass;
    const Vec3 centre = (a.mass * a.centre_local + b.mass * b.centre_local) / mass;
    const Mat3 J = moved_tensor(a, centre - a.centre_local) + moved_tensor(b, centre - b.centre_local);
    return {mass, centre, typed(J)};
}

std::vector<Shape> link_shapes(const Vec3& from, const Vec3& to, double radius, const Vec3& hub_axis) {
    const Vec3 half = 1.7 * radius * hub_axis;
    return {Rod{from, to, radius}, Cylinder{to - half, to + half, 1.5 * radius}};
}

DynamicScene::DynamicScene(const std::string& title, const std::string& source, const std::string& text) {
    lesson.title = title;
    lesson.chapter = "dynamics";
    lesson.source = source;
    lesson.text = text;
    Body ground;
    ground.name = "ground";
    ground.fixed = true;
    lesson.mechanism.bodies.push_back(ground);
    lesson.looks.emplace_back();
    lesson.dynamics.emplace().loads.masses.emplace_back();
}

int DynamicScene::add(const Part& part) {
    lesson.mechanism.bodies.push_back({part.name, false, part.r, part.p, part.r_dot, part.omega_local});
    Look look{part.shapes, {}};
    if (!part.colour.empty()) { look.colour = colour_named(part.colour); }
    lesson.looks.push_back(look);
    plan().loads.masses.emplace_back(part.mass);
    return static_cast<int>(lesson.mechanism.bodies.size()) - 1;
}

void DynamicScene::look_of_ground(const std::vector<Shape>& shapes) {
    lesson.looks[0] = {shapes, colour_named("steel")};
}

Joint& DynamicScene::add_joint(
    std::string_view type, const std::string& name, const BodyPoint& i, const BodyPoint& j) {
    Joint joint;
    joint.name = name;
    joint.type = find_joint_type(type);
    joint.body_i = i.body;
    joint.body_j = j.body;
    joint.geometry.P_i_local = i.point_local;
    joint.geometry.P_j_local = j.point_local;
    lesson.order.push_back({Addition::Kind::joint, static_cast<int>(lesson.mechanism.joints.size())});
    lesson.step_texts.joints.emplace_back();
    lesson.mechanism.joints.push_back(joint);
    return lesson.mechanism.joints.back();
}

void DynamicScene::hinge(const std::string& name, const BodyPoint& i, const BodyPoint& j, const Vec3& axis) {
    JointGeometry& g = add_joint("revolute", name, i, j).geometry;
    g.s_i_local = g.s_j_local = axis;
    g.h_i_local = g.h_j_local = g.u_i_local = g.u_j_local = perpendicular_to(axis);
}

void DynamicScene::ball(const std::string& name, const BodyPoint& i, const BodyPoint& j) {
    add_joint("spherical", name, i, j);
}

void DynamicScene::slide(const std::string& name, const BodyPoint& i, const BodyPoint& j, const Vec3& axis) {
    JointGeometry& g = add_joint("prismatic", name, i, j).geometry;
    g.s_i_local = g.s_j_local = axis;
    g.h_i_local = g.u_i_local = perpendicular_to(axis);
    g.h_j_local = g.u_j_local = axis.cross(perpendicular_to(axis));
}

void DynamicScene::cross(
    const std::string& name, const BodyPoint& i, const BodyPoint& j, const Vec3& arm_i, const Vec3& arm_j) {
    JointGeometry& g = add_joint("universal", name, i, j).geometry;
    g.s_i_local = arm_i;
    g.s_j_local = arm_j;
}

void DynamicScene::say(const std::string& text) { lesson.step_texts.joints.back() = text; }

void DynamicScene::claim(int rows, int rank, int dof, const std::string& why) {
    const AfterAddition everything{static_cast<int>(lesson.order.size())};
    const auto add = [&](const Fact& fact) { lesson.claims.push_back({everything, fact, {}, why}); };
    add(CountClaim{Count::rank, rank});
    add(CountClaim{Count::rows, rows});
    add(CountClaim{Count::dof, dof});
    add(CountClaim{Count::redundant, rows - rank});
    // assembled as it is typed: what rounding leaves
    lesson.claims.push_back({AsGiven{}, BoundClaim{Bound::residual_below, 1e-14}, {}, {}});
}

void DynamicScene::prove(
    double t, const std::string& name, double value, double tolerance, const std::string& why) {
    const std::optional<ReadName> read = read_name(name, lesson.mechanism);
    if (!read) { throw std::invalid_argument("no quantity " + name); }
    const NamedQuantity& named = read->named;
    lesson.claims.push_back(
        {AtTime{t, true},
         QuantityClaim{named.quantity, name, named.derivative, named.derivative, false, value, tolerance},
         {},
         why});
}

}  // namespace jw::test
