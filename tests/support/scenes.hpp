#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/scene_builder.hpp"

/// The mechanisms of the lecture, assembled from closed forms. Ground is body 0 and fixed.
namespace jw::test {

inline constexpr double kPi = std::numbers::pi;
inline double radians(double degrees) { return degrees * kPi / 180.0; }

/// Point where the circles about `a` and `b` in the plane z = 0 meet, left of a -> b for side = +1.
inline Vec3 circles_meet(const Vec3& a, double radius_a, const Vec3& b, double radius_b, double side) {
    const double distance = (b - a).norm();
    const Vec3 along = (b - a) / distance;
    const double x = (distance * distance + radius_a * radius_a - radius_b * radius_b) / (2.0 * distance);
    return a + x * along + side * std::sqrt(radius_a * radius_a - x * x) * Vec3::UnitZ().cross(along);
}

/// O - A - B - D in the plane z = 0: crank O A, coupler A B, rocker B D; joint 0 at O, measured from x to O
/// A.
using JointNames = std::array<std::string_view, 4>;
inline constexpr JointNames kFourRevolutes{"revolute", "revolute", "revolute", "revolute"};
inline Mechanism four_bar(
    const Vec3& A, const Vec3& B, const Vec3& D, const JointNames& types = kFourRevolutes) {
    SceneBuilder scene;
    // body origins at the joints nearest to O: the singular values quoted for these loops depend on that
    const int crank = scene.add_body("crank", Vec3::Zero());
    const int coupler = scene.add_body("coupler", A);
    const int rocker = scene.add_body("rocker", D);
    const Vec3 z = Vec3::UnitZ();
    scene.measure_angle(scene.add_joint(types[0], 0, crank, Vec3::Zero(), z), Vec3::UnitX(), A);
    scene.add_joint(types[1], crank, coupler, A, z);
    scene.add_joint(types[2], coupler, rocker, B, z);
    scene.measure_angle(scene.add_joint(types[3], 0, rocker, D, z), Vec3::UnitX(), B - D);
    return scene.mechanism;
}

struct FourBarLengths {
    double crank = 1.0;
    double coupler = 2.5;
    double rocker = 2.0;
    double ground = 3.0;
};
inline Mechanism four_bar_at(
    double phi, const FourBarLengths& l = {}, const JointNames& types = kFourRevolutes) {
    const Vec3 A = l.crank * Vec3(std::cos(phi), std::sin(phi), 0.0);
    const Vec3 D = l.ground * Vec3::UnitX();
    return four_bar(A, circles_meet(A, l.coupler, D, l.rocker, 1.0), D, types);
}

/// Cranks 1, bars 2.
inline Mechanism parallelogram(double phi) {
    const Vec3 A(std::cos(phi), std::sin(phi), 0.0);
    return four_bar(A, A + 2.0 * Vec3::UnitX(), 2.0 * Vec3::UnitX());
}

/// Crank `r`, rod `l`, slider along x through the crank's bearing: three revolutes and a prismatic joint.
inline Mechanism slider_crank(double r, double l, double phi) {
    const Vec3 A(r * std::cos(phi), r * std::sin(phi), 0.0);
    const Vec3 B(A.x() + std::sqrt(l * l - A.y() * A.y()), 0.0, 0.0);
    SceneBuilder scene;
    const int crank = scene.add_body("crank", 0.5 * A);
    const int rod = scene.add_body("rod", 0.5 * (A + B));
    const int slider = scene.add_body("slider", B);
    const Vec3 z = Vec3::UnitZ();
    scene.measure_angle(scene.add_joint("revolute", 0, crank, Vec3::Zero(), z), Vec3::UnitX(), A);
    scene.add_joint("revolute", crank, rod, A, z);
    scene.add_joint("revolute", rod, slider, B, z);
    scene.add_joint("prismatic", 0, slider, B, Vec3::UnitX());
    return scene.mechanism;
}

/// Two shafts on bearings, joined by a universal joint at the origin; the second is bent by `bend` in the xz
/// plane, the arm of the first stands at `phi` from that plane. Joints: bearing, bearing, universal.
inline Mechanism cardan(double bend, double phi) {
    const Vec3 in = Vec3::UnitZ();
    const Vec3 out(std::sin(bend), 0.0, std::cos(bend));
    const Vec3 arm_i(std::cos(phi), std::sin(phi), 0.0);
    // perpendicular to both: the cross of the joint
    const Vec3 arm_j = std::abs(arm_i.dot(out)) < 1.0 - 1e-12 ? Vec3(out.cross(arm_i)) : in;
    SceneBuilder scene;
    const int shaft_in = scene.add_body("shaft in", -in);
    const int shaft_out = scene.add_body("shaft out", out);
    scene.measure_angle(scene.add_joint("revolute", 0, shaft_in, -1.5 * in, in), Vec3::UnitX(), arm_i);
    scene.add_joint("revolute", 0, shaft_out, 1.5 * out, out);
    scene.add_universal(shaft_in, shaft_out, Vec3::Zero(), arm_i, arm_j);
    return scene.mechanism;
}

/// Two universal joints, the middle shaft bent by `bend`, the outer shafts parallel; joints: bearing,
/// universal, universal, cylindrical. Both arms of the middle shaft lie in one plane.
inline Mechanism double_cardan(double bend, double phi) {
    const Vec3 z = Vec3::UnitZ();
    const Vec3 middle(std::sin(bend), 0.0, std::cos(bend));
    const Vec3 arm_in(std::cos(phi), std::sin(phi), 0.0);
    const Vec3 arm_middle = middle.cross(arm_in).normalized();
    SceneBuilder scene;
    const int in = scene.add_body("in", -z);
    const int shaft = scene.add_body("middle", middle);
    const int out = scene.add_body("out", 2.0 * middle + z);
    scene.add_joint("revolute", 0, in, -1.5 * z, z);
    scene.add_universal(in, shaft, Vec3::Zero(), arm_in, arm_middle);
    scene.add_universal(shaft, out, 2.0 * middle, arm_middle, arm_in);
    scene.add_joint("cylindrical", 0, out, 2.0 * middle + 1.5 * z, z);
    return scene.mechanism;
}

/// Crank on z at the origin, rocker on y at (2, 0, 0.5), a rod between two spherical joints.
struct Rssr {
    double crank = 0.6;
    double rod = 2.3;
    double rocker = 1.4;
    Vec3 D = Vec3(2.0, 0.0, 0.5);

    Vec3 crank_end(double phi) const { return crank * Vec3(std::cos(phi), std::sin(phi), 0.0); }
    /// psi is right-handed about y, from z.
    Vec3 rocker_end(double psi) const { return D + rocker * Vec3(std::sin(psi), 0.0, std::cos(psi)); }
    /// |rocker_end - crank_end| = rod solved for psi: a sinψ + b cosψ = c.
    double psi(double phi) const {
        const Vec3 w = D - crank_end(phi);
        const double a = 2.0 * rocker * w.x();
        const double b = 2.0 * rocker * w.z();
        const double c = rod * rod - rocker * rocker - w.squaredNorm();
        return std::atan2(a, b) - std::acos(c / std::hypot(a, b));
    }
};
inline Mechanism rssr(double phi, const Rssr& l = {}) {
    const Vec3 A = l.crank_end(phi);
    const Vec3 B = l.rocker_end(l.psi(phi));
    SceneBuilder scene;
    const int crank = scene.add_body("crank", 0.5 * A);
    const int rod = scene.add_body("rod", 0.5 * (A + B));
    const int rocker = scene.add_body("rocker", 0.5 * (B + l.D));
    scene.measure_angle(scene.add_joint("revolute", 0, crank, Vec3::Zero(), Vec3::UnitZ()), Vec3::UnitX(), A);
    scene.add_joint("spherical", crank, rod, A, Vec3::UnitZ());
    scene.add_joint("spherical", rod, rocker, B, Vec3::UnitZ());
    scene.measure_angle(scene.add_joint("revolute", 0, rocker, l.D, Vec3::UnitY()), Vec3::UnitZ(), B - l.D);
    return scene.mechanism;
}

/// A link of a closed chain of revolutes: turn θ about z, then along x by a and about x by α.
struct ChainLink {
    double theta;
    double a;
    double alpha;
};

/// Closed chain; the last link is ground. Joint k has the angle θ_k, measured between the x axes.
inline Mechanism revolute_chain(const std::vector<ChainLink>& links) {
    SceneBuilder scene;
    Mat3 frame = Mat3::Identity();
    Vec3 origin = Vec3::Zero();
    int before = 0;
    for (std::size_t k = 0; k < links.size(); ++k) {
        const ChainLink& link = links[k];
        const Mat3 turned = frame * Eigen::AngleAxisd(link.theta, Vec3::UnitZ());
        const Vec3 end = origin + link.a * turned.col(0);
        const bool last = k + 1 == links.size();
        const int body = last ? 0 : scene.add_body("link " + std::to_string(k + 1), 0.5 * (origin + end));
        scene.measure_angle(
            scene.add_joint("revolute", before, body, origin, frame.col(2)), frame.col(0), turned.col(0));
        frame = turned * Eigen::AngleAxisd(link.alpha, Vec3::UnitX());
        origin = end;
        before = body;
    }
    return scene.mechanism;
}

/// sin α / a = sin β / b; tan(θ1/2) tan(θ2/2) is the same all over the turn.
struct Bennett {
    double a = 1.0;
    double alpha = radians(40.0);
    double beta = radians(70.0);

    double b() const { return a * std::sin(beta) / std::sin(alpha); }
    double half_tangents() const { return std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha)); }
};
inline Mechanism bennett(double theta_1, const Bennett& l = {}) {
    const double theta_2 = 2.0 * std::atan(l.half_tangents() / std::tan(0.5 * theta_1));
    return revolute_chain(
        {{theta_1, l.a, l.alpha},
         {theta_2, l.b(), l.beta},
         {-theta_1, l.a, l.alpha},
         {-theta_2, l.b(), l.beta}});
}

/// Threefold-symmetric Bricard linkage with twists of ±90 deg: cosθ + cosφ + cosθ cosφ = 0.
inline Mechanism bricard(double theta) {
    const double phi = std::acos(-std::cos(theta) / (1.0 + std::cos(theta)));
    std::vector<ChainLink> links;
    for (int k = 0; k < 3; ++k) {
        links.push_back({theta, 1.0, 0.5 * kPi});
        links.push_back({phi, 1.0, -0.5 * kPi});
    }
    return revolute_chain(links);
}

/// Sun (1) and carrier (2) on the ground, a planet (3) on the carrier that meshes with the sun by `outer`
/// (turns of the planet for one of the sun) and with a ring on the ground by `inner` (of the ring for one of
/// the planet), both on the carrier.
inline Mechanism planetary_gear(double outer, double inner, const Vec3& axis = Vec3(2.0, -1.0, 2.0)) {
    SceneBuilder scene;
    const Vec3 arm = 1.05 * perpendicular_to(axis);
    const int sun = scene.add_body("sun", Vec3(0.1, 0.0, 0.2));
    const int carrier = scene.add_body("carrier", 0.5 * arm);
    const int planet = scene.add_body("planet", arm + Vec3(0.0, 0.1, 0.0));
    scene.add_joint("revolute", 0, sun, Vec3::Zero(), axis);
    scene.add_joint("revolute", 0, carrier, Vec3::Zero(), axis);
    scene.add_joint("revolute", carrier, planet, arm, axis);
    scene.add_wheels("gear", sun, planet, Vec3::Zero(), arm, axis, axis, outer);
    scene.add_wheels("gear", planet, 0, arm, Vec3::Zero(), axis, axis, inner);
    return scene.mechanism;
}

/// Left (1) and right (2) wheel and case (3) about one axis, a planet (4) on the case that meshes with both.
inline Mechanism differential() {
    SceneBuilder scene;
    const Vec3 x = Vec3(1.0, 2.0, -2.0) / 3.0;
    const Vec3 z = perpendicular_to(x);
    const int left = scene.add_body("left", -2.0 * x);
    const int right = scene.add_body("right", 2.0 * x);
    const int box = scene.add_body("case", 0.5 * z);
    const int planet = scene.add_body("planet", 0.5 * z);
    scene.add_joint("revolute", 0, left, -1.5 * x, x);
    scene.add_joint("revolute", 0, right, 1.5 * x, x);
    scene.add_joint("revolute", 0, box, Vec3::Zero(), x);
    scene.add_joint("revolute", box, planet, 1.0 * z, z);
    scene.add_wheels("bevel-gear", left, planet, -0.5 * x, 0.5 * z, x, z, 1.0);
    scene.add_wheels("bevel-gear", right, planet, 0.5 * x, 0.5 * z, x, z, -1.0);
    return scene.mechanism;
}

/// A pinion (1) of radius r on the ground, and a rack (2) that slides across its axis.
inline Mechanism rack_and_pinion(double r) {
    SceneBuilder scene;
    const Vec3 axis = Vec3(2.0, 2.0, 1.0) / 3.0;
    const Vec3 along = perpendicular_to(axis);
    const Vec3 below = r * axis.cross(along);
    const int pinion = scene.add_body("pinion", Vec3(0.02, 0.0, 0.0));
    const int rack = scene.add_body("rack", below);
    scene.add_joint("revolute", 0, pinion, Vec3::Zero(), axis);
    scene.add_joint("prismatic", 0, rack, below, along);
    scene.add_wheels("rack", rack, pinion, below, Vec3::Zero(), along, axis, r);
    return scene.mechanism;
}

/// Nut on a fixed spindle along `axis` through the origin, at angle θ and advance α θ.
inline Mechanism screw(
    double theta, double alpha, ScrewAngleForm form, const Vec3& axis = Vec3(1.0, 2.0, 2.0)) {
    SceneBuilder scene;
    const int nut = scene.add_body("nut", alpha * theta * axis.normalized());
    Joint& joint = scene.add_joint("screw", 0, nut, Vec3::Zero(), axis);
    const Vec3 u_i = perpendicular_to(axis);
    scene.measure_angle(joint, u_i, Eigen::AngleAxisd(theta, axis.normalized()) * u_i);
    joint.geometry.P_j_local = Vec3::Zero();
    joint.geometry.alpha = alpha;
    joint.geometry.screw_angle_form = form;
    return scene.mechanism;
}

}  // namespace jw::test
