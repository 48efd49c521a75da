#include <array>
#include <cmath>
#include <numbers>

#include "core/jets/euler_parameters.hpp"
#include "tests/support/dynamic_scene.hpp"
#include "tests/support/dynamics_scenes.hpp"

namespace jw::test {

namespace {

const std::string kLibrary = "slides 24-25; IFToMM library of computational benchmark problems, ";
constexpr double kSection = 0.1;

/// Rods of 1 m and 1 kg of square section along one axis of their frame.
MassProperties rod_mass(const Vec3& along) {
    return box_mass(1.0, Vec3::Constant(kSection) + (1.0 - kSection) * along.cwiseAbs());
}

CameraWish y_is_up(const Vec3& from) {
    CameraWish camera;
    camera.from = from.normalized();
    camera.up = kY;
    return camera;
}

MassProperties disc_mass(double mass, double radius, double thickness, const Vec3& axis) {
    const double across = mass * (3.0 * radius * radius + thickness * thickness) / 12.0;
    const double along = 0.5 * mass * radius * radius;
    return {mass, Vec3::Zero(), (across * Vec3::Ones() + (along - across) * axis).asDiagonal()};
}

}  // namespace

Lesson falling_bricard() {
    DynamicScene scene(
        "Bricard's linkage falls", kLibrary + "A04; Bricard 1897",
        R"(Five rods of 1 kg and the ground, edges of a cube: six hinges, thirty equations for thirty freedoms, and yet it
falls. One equation is redundant, but no particular one: a method that leaves one out for good may divide by zero
later.)");
    const std::array<Vec3, 6> points{Vec3(0, 0, 0),  Vec3(1, 0, 0),  Vec3(1, -1, 0),
                                     Vec3(1, -1, 1), Vec3(0, -1, 1), Vec3(0, 0, 1)};
    const std::array<Vec3, 6> axes{kY, kZ, kX, kY, kZ, kX};
    const std::array<const char*, 5> colours{"vermilion", "blue", "green", "purple", "orange"};
    constexpr double kRadius = 0.04;
    int before = 0;
    Vec3 end_before = points[0];
    for (std::size_t k = 0; k < 5; ++k) {
        const Vec3 half = 0.5 * (points[k + 1] - points[k]);
        const int rod = scene.add(
            {.name = "rod " + std::to_string(k + 1),
             .r = points[k] + half,
             .mass = rod_mass(2.0 * half),
             .colour = colours[k],
             .shapes = link_shapes(-half, half, kRadius, axes[k + 1])});
        scene.hinge(std::string(1, static_cast<char>('A' + k)), {before, end_before}, {rod, -half}, axes[k]);
        before = rod;
        end_before = half;
    }
    scene.hinge("F", {before, end_before}, {0, points[5]}, axes[5]);
    scene.say(
        "The ring closes. Counting says that nothing can move; the rank says that one freedom is left.");
    scene.lesson.step_texts.bodies = "Five rods, each with its frame at its centre. The ground is the sixth.";
    scene.look_of_ground(link_shapes(points[5], points[0], kRadius, axes[0]));
    scene.lesson.camera = y_is_up(Vec3(0.9, 0.5, 1.0));
    scene.plan().loads.gravity = -kGravity * kY;
    scene.plan().duration = 10.0;
    scene.plan().point = BodyPoint{3, 0.5 * kZ};
    scene.plan().point_at_end = Vec3(0.999999963806, -1.000269012697, 0.999730951120);
    scene.claim(30, 29, 1, "One equation follows from the others.");
    scene.prove(
        10.0, "energy.sum", -29.43, 1e-4,
        "At rest at the start, with centres at heights of 0, -0.5, -1, -1 and -0.5 m: -3 m g.");
    return scene.lesson;
}

Lesson flyball_governor() {
    DynamicScene scene(
        "A stiff flyball governor", kLibrary + "A05",
        R"(The balls pull outwards, the springs hold them: 800 000 N/m and 40 000 N s/m. What one sees is a slow motion of
the slider; the equations also contain motions that decay in a tenth of a millisecond. Explicit methods must
resolve these at any tolerance. Implicit ones step over them.)");
    const double turn = 2.0 * std::numbers::pi;
    constexpr double kSlope = 30.0 * std::numbers::pi / 180.0;
    const int shaft = scene.add(
        {.name = "shaft",
         .r = Vec3(0, 0, 0.5),
         .mass = box_mass(0.3, Vec3(0.01, 0.01, 1.0)),
         .omega_local = turn * kZ,
         .colour = "steel",
         .shapes = {Rod{-0.5 * kZ, 0.5 * kZ, 0.015}, Rod{Vec3(-0.05, 0, 0.5), Vec3(0.05, 0, 0.5), 0.015}}});
    const int slider = scene.add(
        {.name = "slider",
         .r = Vec3(0, 0, 0.5),
         .mass = box_mass(3.0, Vec3::Constant(0.1)),
         .omega_local = turn * kZ,
         .colour = "blue",
         .shapes = {Box{Vec3::Constant(0.1)}}});
    scene.hinge("bearing", {0, Vec3::Zero()}, {shaft, -0.5 * kZ}, kZ);
    scene.slide("guide", {shaft, Vec3::Zero()}, {slider, Vec3::Zero()}, kZ);
    scene.say("The slider turns with the shaft and slides freely along it; only the springs carry it.");
    // frames of the rods stand at their pins, x along the rod: the centre of mass is near the ball
    const MassProperties bar = [] {
        MassProperties mass = box_mass(0.3, Vec3(1.0, 0.01, 0.01));
        mass.centre_local = 0.5 * kX;
        return mass;
    }();
    const MassProperties point_mass{5.0, kX, Mat3::Zero()};
    for (const double side : {1.0, -1.0}) {
        const Vec3 pin(side * 0.05, 0, 1.0);
        // x of the rod leads outwards and down
        const double about_y = side > 0.0 ? kSlope : std::numbers::pi - kSlope;
        const Vec4 p = euler_parameters_of(kY, about_y);
        const std::string name = side > 0.0 ? "right" : "left";
        const int rod = scene.add(
            {.name = name + " rod",
             .r = pin,
             .p = p,
             .mass = together(bar, point_mass),
             .r_dot = turn * kZ.cross(pin),
             // 2π about z: sin 30 deg and cos 30 deg of it
             .omega_local = std::numbers::pi * Vec3(-1.0, 0.0, side * std::numbers::sqrt3),
             .colour = side > 0.0 ? "vermilion" : "orange",
             .shapes = {Rod{Vec3::Zero(), kX, 0.012}, Sphere{kX, 0.08}}});
        scene.hinge(name + " pin", {shaft, pin - 0.5 * kZ}, {rod, Vec3::Zero()}, kY);
        const Vec3 on_slider(side * 0.05, 0, 0);
        scene.plan().loads.springs.push_back({slider, rod, on_slider, 0.5 * kX, 8e5, 0.5, 4e4});
    }
    scene.lesson.step_texts.bodies =
        "Shaft, slider and two rods with a ball of 5 kg at the end, all turning once per second.";
    scene.look_of_ground({Cylinder{Vec3(0, 0, -0.06), Vec3(0, 0, -0.01), 0.2}});
    CameraWish& camera = scene.lesson.camera;
    camera.from = Vec3(0.35, -1.0, 0.3).normalized();
    scene.plan().loads.gravity = -kGravity * kZ;
    scene.plan().duration = 10.0;
    scene.plan().settings.method = Method::implicit_5;
    scene.plan().point = BodyPoint{slider, 0.05 * kX};
    scene.plan().point_at_end = Vec3(0.0408888676, -0.0287767355, 0.619622917061);
    scene.claim(20, 20, 4, "The shaft turns, the slider slides, each rod swings.");
    scene.prove(
        0.0, "slider.r_ddot.z", -9.81, 1e-6,
        "The springs have their free length: the slider starts in free fall.");
    const std::string swing =
        "Lagrange's equation about the pin: (m c g cos θ - ω² (0.05 m c sin θ + I sin θ cos θ)) / I.";
    scene.prove(0.0, "right pin.angle_ddot", -9.512279275630721, 1e-6, swing);
    scene.prove(0.0, "left pin.angle_ddot", 9.512279275630721, 1e-6, swing);
    scene.prove(0.0, "energy.sum_dot", 0.0, 1e-6, "The dampers do not move yet, and nothing drives.");
    scene.prove(10.0, "bearing.torque.z", 0.0, 1e-6, "The bearing turns freely: no torque about its axis.");
    return scene.lesson;
}

Lesson chain(ChainJoint joint, int n) {
    const bool hinges = joint == ChainJoint::revolute;
    const std::string count = std::to_string(n);
    DynamicScene scene(
        "A chain of " + count + (hinges ? " hinged links" : " links with ball joints"),
        "slides 24-25; open chains for scaling",
        count + " rods of 1 m and 1 kg in a row, from the origin along x. " +
            (hinges ? R"(The hinge axes alternate,
z, y, z, y; every other pair of rods starts with 1 rad/s about y.)"
                    : R"(The whole chain starts
with 1 rad/s about y.)") +
            " A tree without loops: the cost\nof a step must grow no faster than the number of rods.");
    const std::array<const char*, 4> colours{"vermilion", "orange", "blue", "green"};
    int before = 0;
    // velocity of the joint that comes next
    Vec3 r_dot = Vec3::Zero();
    for (int k = 1; k <= n; ++k) {
        const bool turns = !hinges || k % 4 == 2 || k % 4 == 3;
        const Vec3 omega = turns ? kY : Vec3(Vec3::Zero());
        const Vec3 half = 0.5 * kX;
        const int rod = scene.add(
            {.name = "rod " + std::to_string(k),
             .r = Vec3(k - 0.5, 0, 0),
             .mass = rod_mass(kX),
             .r_dot = r_dot + omega.cross(half),
             .omega_local = omega,
             .colour = colours[static_cast<std::size_t>(k - 1) % 4],
             .shapes = {Rod{-half, half, 0.05}}});
        const std::string name = (hinges ? "hinge " : "ball ") + std::to_string(k);
        const BodyPoint end{before, before == 0 ? Vec3(Vec3::Zero()) : half};
        if (hinges) {
            scene.hinge(name, end, {rod, -half}, k % 2 == 1 ? kZ : kY);
        } else {
            scene.ball(name, end, {rod, -half});
        }
        r_dot += omega.cross(kX);
        before = rod;
    }
    scene.lesson.camera = y_is_up(Vec3(0.4, 0.35, 1.0));
    scene.plan().loads.gravity = -kGravity * kY;
    scene.plan().duration = 2.0;
    scene.plan().point = BodyPoint{before, 0.5 * kX};
    const auto end_at = [&](double x, double y, double z) { scene.plan().point_at_end = Vec3(x, y, z); };
    if (hinges && n == 4) { end_at(-2.874729783464, 0.805742245130, 1.181061769846); }
    if (hinges && n == 16) { end_at(-6.200367620996, -13.780780273368, -1.828194771765); }
    if (!hinges && n == 4) { end_at(-1.517379684648, 0.453886859532, 3.260786311263); }
    if (!hinges && n == 16) { end_at(-11.109223802811, -11.234590750691, -1.251050701962); }
    const int rows = (hinges ? 5 : 3) * n;
    scene.claim(rows, rows, 6 * n - rows, "A tree has no redundant equations.");
    if (n > 4) { return scene.lesson; }  // the scenes of the benchmarks are compared by their ends
    // of the middles, and of J about y: 1.01 / 12 kg m²
    double pull = 0.0;
    double kinetic = 0.0;
    double speed = 0.0;
    double inwards = 0.0;
    for (int k = 1; k <= n; ++k) {
        const double omega = !hinges || k % 4 == 2 || k % 4 == 3 ? 1.0 : 0.0;
        const double of_middle = speed + 0.5 * omega;
        kinetic += 0.5 * (of_middle * of_middle + 1.01 / 12.0 * omega * omega);
        pull += inwards + 0.5 * omega * omega;
        speed += omega;
        inwards += omega * omega;
    }
    scene.prove(
        0.0, (hinges ? "hinge 1" : "ball 1") + std::string(".force.x"), -pull, 1e-9,
        "The row is normal to gravity: along it there is only ω² times the distance, summed over the rods.");
    scene.prove(
        2.0, "energy.sum", kinetic, 1e-5,
        "At the start all rods are level with the first joint: kinetic energy only, m v² / 2 + J ω² / 2.");
    return scene.lesson;
}

Lesson falling_slider_crank() {
    DynamicScene scene(
        "The spatial slider-crank, let go", "slides 6-8, 10, 24-25; book ch. 7",
        R"(The spatial slider-crank without its motor: it is released with the pin level with the shaft, and the weight of
the rod turns the wheel back and forth. All four joint types differ, nothing is redundant, no energy is lost.)");
    const Vec3 centre(0, 0.3, 0.6);
    const Vec3 pin = 0.3 * kY;
    const Vec3 from_rail = centre + pin - 0.15 * kZ;
    const double reach = std::sqrt(1.2 * 1.2 - from_rail.squaredNorm());
    Mat3 axes;
    axes.col(0) = (from_rail - reach * kX) / 1.2;
    axes.col(2) = axes.col(0).cross(kY).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    const int wheel = scene.add(
        {.name = "wheel",
         .r = centre,
         .mass = disc_mass(2.0, 0.36, 0.025, kX),
         .colour = "vermilion",
         .shapes = {
             Cylinder{Vec3(-0.04, 0, 0), Vec3(-0.015, 0, 0), 0.36},
             Cylinder{Vec3(-0.14, 0, 0), Vec3(0.01, 0, 0), 0.05}, Rod{pin - 0.03 * kX, pin, 0.03}}});
    MassProperties rod_of_wood = disc_mass(1.0, 0.02, 1.2, kX);
    rod_of_wood.centre_local = 0.6 * kX;
    const int rod = scene.add(
        {.name = "rod",
         .r = Vec3(reach, 0, 0.15),
         .p = euler_parameters_of(axes),
         .mass = rod_of_wood,
         .colour = "blue",
         .shapes = {
             Rod{0.05 * kX, 1.2 * kX, 0.02}, Sphere{1.2 * kX, 0.045}, Rod{-0.07 * kZ, 0.07 * kZ, 0.014},
             Rod{Vec3(0.05, 0, -0.07), Vec3(0.05, 0, 0.07), 0.014},
             Rod{-0.07 * kZ, Vec3(0.05, 0, -0.07), 0.014}, Rod{0.07 * kZ, Vec3(0.05, 0, 0.07), 0.014}}});
    const int slide = scene.add(
        {.name = "slide",
         .r = Vec3(reach, 0, 0.15),
         .mass = box_mass(1.0, Vec3(0.16, 0.12, 0.08)),
         .colour = "green",
         .shapes = {Box{Vec3(0.16, 0.12, 0.08)}, Rod{-0.09 * kY, 0.09 * kY, 0.014}}});
    scene.hinge("shaft", {0, centre}, {wheel, Vec3::Zero()}, kX);
    scene.ball("ball", {wheel, pin}, {rod, 1.2 * kX});
    scene.slide("rail", {0, 0.15 * kZ}, {slide, Vec3::Zero()}, kX);
    scene.cross("cross", {slide, Vec3::Zero()}, {rod, Vec3::Zero()}, kY, kZ);
    scene.say("Seventeen equations, one freedom. The constraint forces follow from λ.");
    scene.look_of_ground(
        {Box{Vec3(1.7, 0.9, 0.04), Vec3(0.6, 0.1, -0.04)}, Box{Vec3(0.95, 0.05, 0.05), Vec3(0.95, 0, 0.15)},
         Box{Vec3(0.04, 0.04, 0.17), Vec3(1.4, 0, 0.06)}, Box{Vec3(0.04, 0.04, 0.17), Vec3(0.5, 0, 0.06)},
         Box{Vec3(0.05, 0.12, 0.66), Vec3(-0.12, 0.3, 0.28)}});
    scene.lesson.camera.from = Vec3(0.5, -1.0, 0.5).normalized();
    scene.plan().loads.gravity = -kGravity * kZ;
    scene.plan().duration = 5.0;
    scene.plan().point = BodyPoint{wheel, pin};
    scene.claim(17, 17, 1);
    scene.prove(
        5.0, "energy.sum", 16.92225, 1e-5,
        "At rest at the start: 9.81 (2 0.6 + 1 (0.6 + 0.15) / 2 + 1 0.15) J for wheel, rod and slide.");
    scene.prove(2.0, "rail.force.x", 0.0, 1e-9, "A rail without friction exerts no force along itself.");
    scene.prove(
        2.0, "shaft.torque.x", 0.0, 1e-9, "A shaft without friction exerts no torque about its axis.");
    return scene.lesson;
}

Lesson spinning_top() {
    DynamicScene scene(
        "A heavy top on its tip", "slides 18-19, 24-25; book ch. 11",
        R"(A top of 0.5 kg spins at 150 rad/s, inclined by 30 deg. It does not fall: it nutates, and precesses once in
a little more than two seconds. Energy and two components of angular momentum stay constant, and elliptic functions
give its motion.)");
    const Vec4 p = euler_parameters_of(kY, 30.0 * std::numbers::pi / 180.0);
    constexpr double kHeight = 0.1;
    const int top = scene.add(
        {.name = "top",
         .r = rotation_matrix(p) * (kHeight * kZ),
         .p = p,
         .mass = {0.5, Vec3::Zero(), Vec3(8e-4, 8e-4, 1.2e-3).asDiagonal()},
         .omega_local = 150.0 * kZ,
         .colour = "vermilion",
         .shapes = {
             Rod{-kHeight * kZ, 0.06 * kZ, 0.006}, Cylinder{-0.012 * kZ, 0.012 * kZ, 0.07},
             Cylinder{-0.03 * kZ, -0.012 * kZ, 0.04}, Sphere{Vec3(0.06, 0, 0.012), 0.009}}});
    scene.ball("tip", {0, Vec3::Zero()}, {top, -kHeight * kZ});
    scene.say("The tip stays where it is. Three freedoms: spin, nutation, precession.");
    scene.lesson.step_texts.bodies = "The top, with a mark on its rim that shows how it spins.";
    scene.look_of_ground({Cylinder{Vec3(0, 0, -0.05), Vec3(0, 0, -0.006), 0.03}});
    scene.lesson.camera.from = Vec3(0.4, -1.0, 0.45).normalized();
    scene.plan().loads.gravity = -kGravity * kZ;
    scene.plan().duration = 4.0;
    scene.plan().point = BodyPoint{top, 0.06 * kZ};
    scene.claim(3, 3, 3);
    const std::string nod =
        "cos θ oscillates between cos 30 deg and the other root of its cubic as an elliptic function; here "
        "half a nutation is over.";
    scene.prove(0.11995278905529522, "top.z", 0.08039054178981717, 1e-7, nod);
    scene.prove(
        0.23990557811059043, "top.z", 0.08660254037844388, 1e-7,
        "A whole nutation: as high as at the start.");
    scene.prove(
        4.0, "top.omega_local.z", 150.0, 1e-4,
        "Symmetric, and no torque about its axis: the spin stays constant.");
    scene.prove(
        4.0, "energy.sum", 13.924785460556267, 1e-5,
        "The initial value: 0.0012 150² / 2 + 0.5 9.81 0.1 cos 30 deg.");
    return scene.lesson;
}

Lesson free_asymmetric_body() {
    DynamicScene scene(
        "The box that turns over", "slides 18-19; book ch. 11; Poinsot 1834",
        R"(A box floats and turns almost about its intermediate principal axis. No force, no joint, and yet it turns over
again and again: rotation about that axis is unstable. Energy and angular momentum stay constant.)");
    const Vec3 edges(0.3, 0.2, 0.06);
    const int box = scene.add(
        {.name = "box",
         .mass = box_mass(1.0, edges),
         .omega_local = Vec3(0.02, 6.0, 0.02),
         .colour = "blue",
         .shapes = {
             Box{edges}, Sphere{Vec3(0, 0.1, 0), 0.03}, Rod{Vec3(0, 0.1, 0), Vec3(0, 0.17, 0), 0.008}}});
    scene.lesson.step_texts.bodies =
        "One free body, no joint, no weight. The knob shows the axis it turns about.";
    scene.lesson.camera = y_is_up(Vec3(0.5, 0.4, 1.0));
    scene.plan().duration = 20.0;
    scene.plan().point = BodyPoint{box, Vec3(0, 0.17, 0)};
    scene.claim(0, 0, 6);
    // that of Euler's equations for L² > 2 T J2: ω' = (a cn, b sn, c dn)
    const std::string half = "Half of the period 4 K(k) / λ of Euler's equations: it has turned over.";
    const std::string whole = "A whole period: it turns as at the start.";
    scene.prove(4.094782471218922, "box.omega_local.x", -0.02, 1e-4, half);
    scene.prove(4.094782471218922, "box.omega_local.y", -6.0, 1e-4, half);
    scene.prove(4.094782471218922, "box.omega_local.z", 0.02, 1e-4, half);
    scene.prove(8.189564942437844, "box.omega_local.y", 6.0, 1e-4, whole);
    scene.prove(
        20.0, "energy.kinetic", 0.14040289333333333, 1e-7, "No force: the initial value, ω'ᵀ J' ω' / 2.");
    return scene.lesson;
}

}  // namespace jw::test
