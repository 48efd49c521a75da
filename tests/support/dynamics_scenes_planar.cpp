#include <cmath>

#include "core/jets/euler_parameters.hpp"
#include "tests/support/dynamic_scene.hpp"
#include "tests/support/dynamics_scenes.hpp"

namespace jw::test {

namespace {

const std::string kLibrary = "slides 24-25; IFToMM library of computational benchmark problems, ";
constexpr double kLinkRadius = 0.035;

/// Seen along z, a little from above, y up.
CameraWish from_the_front() {
    CameraWish camera;
    camera.from = Vec3(0.25, 0.3, 1.0).normalized();
    camera.up = kY;
    return camera;
}

MassProperties planar(double mass, double J_z) {
    // only Jzz matters; the others are those of a flat disc
    return {mass, Vec3::Zero(), Vec3(0.5 * J_z, 0.5 * J_z, J_z).asDiagonal()};
}

/// Position of the tip of rod 0 of the n four-bar after 10 s: in units of the rod, of one freedom, φ̈ = -g
/// cos φ ((n+1)/2 + n) / ((n+1)/3 + n), integrated with 25 digits.
std::optional<Vec3> end_of_four_bar(int n) {
    switch (n) {
        case 1: return Vec3(0.478385057760971, 0.878150177791209, 0.0);
        case 4: return Vec3(0.251385506951622, 0.967887042425239, 0.0);
        case 16: return Vec3(0.192465372486931, 0.981303765606485, 0.0);
        case 40: return Vec3(0.180512226686729, 0.983572740582312, 0.0);
        default: return std::nullopt;
    }
}

std::string numbered(const char* word, int k, int n) {
    return n == 1 && word == std::string("coupler") ? word : word + (' ' + std::to_string(k));
}

}  // namespace

Lesson simple_pendulum() {
    DynamicScene scene(
        "The simple pendulum", kLibrary + "A01",
        R"(A ball of 1 kg on a light rod of 1 m, released level with its pin. Its path is known to any number of digits,
and its energy must stay constant: the first test of every integrator.)");
    const int ball = scene.add(
        {.name = "ball",
         .r = Vec3(-1, 0, 0),
         .mass = {1.0, Vec3::Zero(), 1e-3 * Mat3::Identity()},
         .colour = "vermilion",
         .shapes = {Rod{Vec3::Zero(), kX, 0.02}, Sphere{Vec3::Zero(), 0.09}}});
    scene.hinge("pin", {0, Vec3::Zero()}, {ball, kX}, kZ);
    scene.say("Five equations, one freedom. The pin can only carry the ball, not drive it.");
    scene.lesson.step_texts.bodies = "The ball at the start. Its frame is at the centre of mass.";
    scene.look_of_ground({Cylinder{Vec3(0, 0, -0.12), Vec3(0, 0, 0.12), 0.03}});
    scene.lesson.camera = from_the_front();
    scene.plan().loads.gravity = -kGravity * kY;
    scene.plan().duration = 10.0;
    scene.plan().point = BodyPoint{ball, Vec3::Zero()};
    scene.plan().point_at_end = Vec3(-0.295850422283221, -0.955234278925772, 0.0);
    scene.claim(5, 5, 1);
    scene.prove(
        0.0, "pin.force.y", 0.009800199800199803, 1e-9,
        "Level and at rest, acceleration g m l² / (m l² + J): the pin carries m g J / (m l² + J).");
    scene.prove(
        0.5922563931794198, "ball.y", -1.0, 1e-9,
        "A quarter of the period, K(sin 45 deg) sqrt((m l² + J) / (m g l)): the ball is lowest.");
    scene.prove(
        0.5922563931794198, "pin.force.y", 29.410399600399604, 1e-6,
        "At the lowest point ω² = 2 m g l / (m l² + J), and the pin carries m g + m l ω².");
    scene.prove(
        1.1845127863588396, "ball.x", 1.0, 1e-9, "Half a period: at the same height on the other side.");
    scene.prove(2.369025572717679, "ball.x", -1.0, 1e-9, "A whole period: back at the start.");
    scene.prove(10.0, "energy.sum", 0.0, 1e-5, "It started at rest, level with its pin.");
    return scene.lesson;
}

Lesson n_four_bar(int n) {
    const std::string windows = n == 1 ? "One window" : std::to_string(n) + " windows";
    DynamicScene scene(
        n == 1 ? "A four-bar falls through its line" : std::to_string(n) + " four-bars fall through one line",
        kLibrary + "A02",
        windows +
            R"( of rods of 1 m and 1 kg, starting at 1 rad/s. Twice in every turn all rods lie in one line:
there the mechanism could continue as a parallelogram or fold, and its equations lose rank. A parallelogram moves like
one pendulum, so the exact motion is known.)");
    const MassProperties along_y{1.0, Vec3::Zero(), Vec3(1.0 / 12.0, 1e-3, 1.0 / 12.0).asDiagonal()};
    const MassProperties along_x{1.0, Vec3::Zero(), Vec3(1e-3, 1.0 / 12.0, 1.0 / 12.0).asDiagonal()};
    const Vec3 up = 0.5 * kY;
    const Vec3 right = 0.5 * kX;
    const auto add_rod = [&](int k) {
        const int rod = scene.add(
            {.name = "rod " + std::to_string(k),
             .r = Vec3(k, 0.5, 0.0),
             .mass = along_y,
             .r_dot = Vec3(0.5, 0.0, 0.0),
             .omega_local = -kZ,
             .colour = k == 0 ? "vermilion" : "orange",
             .shapes = link_shapes(up, -up, kLinkRadius, kZ)});
        scene.hinge("pin " + std::to_string(k), {0, Vec3(k, 0.0, 0.0)}, {rod, -up}, kZ);
        return rod;
    };
    int before = add_rod(0);
    const int first = before;
    for (int k = 1; k <= n; ++k) {
        const int coupler = scene.add(
            {.name = numbered("coupler", k, n),
             .r = Vec3(k - 0.5, 1.0, 0.0),
             .mass = along_x,
             .r_dot = kX,
             .colour = "blue",
             .shapes = link_shapes(-right, right, kLinkRadius, kZ)});
        scene.hinge("left " + std::to_string(k), {before, up}, {coupler, -right}, kZ);
        const int rod = add_rod(k);
        scene.hinge("right " + std::to_string(k), {coupler, right}, {rod, up}, kZ);
        if (k == 1) {
            scene.say(
                "A window closes: three of the five equations are redundant, since the axes are parallel.");
        }
        before = rod;
    }
    scene.lesson.step_texts.bodies = "Upright rods, level couplers; all rods turn to the right at 1 rad/s.";
    scene.lesson.camera = from_the_front();
    scene.plan().loads.gravity = -kGravity * kY;
    scene.plan().duration = 10.0;
    scene.plan().point = BodyPoint{first, up};
    scene.plan().point_at_end = end_of_four_bar(n);
    const int columns = 6 * (2 * n + 1);
    scene.claim(5 * (3 * n + 1), columns - 1, 1, "Three equations of every window are redundant.");
    if (n > 4) { return scene.lesson; }  // the scenes of the benchmarks are compared by their ends
    scene.prove(
        0.0, "rod 0.r_ddot.y", -0.5, 1e-9,
        "Upright, there is no angular acceleration: the rod's centre accelerates down at ω² l / 2.");
    scene.prove(
        0.0, "pin 0.force.y", 13.715, 1e-9,
        "Half a coupler, (9.81 - 1) / 2 N, and a rod whose centre falls at 0.5 m/s², 9.81 - 0.5 N.");
    const double energy = 0.5 * ((n + 1.0) / 3.0 + n) + kGravity * (0.5 * (n + 1.0) + n);
    scene.prove(
        10.0, "energy.sum", energy, 1e-5,
        "The initial value: (rods / 3 + couplers) m l² ω² / 2 + (rods / 2 + couplers) m g l.");
    return scene.lesson;
}

namespace {

/// Data of Andrews' mechanism as in the test set for initial value problems [m, kg, rad].
struct Andrews {
    Vec3 A{-0.06934, -0.00227, 0.0};
    Vec3 B{-0.03635, 0.03273, 0.0};
    Vec3 C{0.014, 0.072, 0.0};
    double d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092;
    double ss = 0.035, sa = 0.01874, sb = 0.01043, sc = 0.018, sd = 0.02;
    double ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228, ub = 0.00449;
    double zf = 0.02, zt = 0.04, fa = 0.01421;
    double beta = -0.0617138900142764496, theta = 0.0, gamma = 0.455279819163070380;
    double phi = 0.222668390165885885, delta = 0.487364979543842550;
    double omega = -0.222668390165885885, epsilon = 1.23054744454982119;
};

/// A body of the mechanism: turned by `angle`, its point `on_body` lying on `there`.
struct Placed {
    Vec3 r;
    Vec4 p;
    Placed(double angle, const Vec3& on_body, const Vec3& there) : p(euler_parameters_of(kZ, angle)) {
        r = there - rotation_matrix(p) * on_body;
    }
    Vec3 at(const Vec3& on_body) const { return r + rotation_matrix(p) * on_body; }
};

}  // namespace

Lesson andrews_mechanism() {
    DynamicScene scene(
        "Andrews' squeezing mechanism", kLibrary + "A03; test set for initial value problems",
        R"(Seven bodies of 4 to 71 g in the plane, a spring of 4530 N/m, and a motor of 0.033 N m that turns the crank two
and a half times in 30 ms. Three loops meet at one point, E. The step size must follow the error, and many
digits are known.)");
    const Andrews a;
    const auto plane = [](double x, double y) { return Vec3(x, y, 0.0); };
    // points of the bodies in their frames, which stand at the centres of mass
    const Vec3 O1 = plane(-a.ra, 0), F1 = plane(a.rr - a.ra, 0);
    const Vec3 F2 = plane(a.da, 0), E2 = plane(a.da - a.d, 0);
    const Vec3 B3 = plane(-a.sb, a.sa), E3 = plane(-a.sb, a.sa - a.ss), D3 = plane(a.sd - a.sb, a.sa - a.sc);
    const Vec3 G4 = plane(0, a.e - a.ea), E4 = plane(0, -a.ea);
    const Vec3 A5 = plane(-a.ta, a.tb), G5 = plane(a.zt - a.ta, a.tb);
    const Vec3 H6 = plane(a.fa - a.zf, 0), E6 = plane(a.fa, 0);
    const Vec3 A7 = plane(-a.ub, a.ua), H7 = plane(-a.ub, a.ua - a.u);

    const Placed K1(a.beta, O1, Vec3::Zero());
    const Placed K2(a.beta + a.theta, F2, K1.at(F1));
    const Placed K3(a.gamma, B3, a.B);
    const Placed K5(a.delta, A5, a.A);
    const Placed K4(a.phi + a.delta, G4, K5.at(G5));
    const Placed K7(a.epsilon, A7, a.A);
    const Placed K6(a.omega + a.epsilon, H6, K7.at(H7));
    constexpr double kRadius = 0.0011;
    const auto add = [&](const char* name, const Placed& at, double mass, double J, const char* colour,
                         const std::vector<std::pair<Vec3, Vec3>>& bars) {
        std::vector<Shape> shapes;
        for (const auto& [from, to] : bars) {
            for (const Shape& shape : link_shapes(from, to, kRadius, kZ)) { shapes.push_back(shape); }
        }
        return scene.add(
            {.name = name,
             .r = at.r,
             .p = at.p,
             .mass = planar(mass, J),
             .colour = colour,
             .shapes = shapes});
    };
    const int k1 = add("K1", K1, 0.04325, 2.194e-6, "vermilion", {{O1, F1}});
    const int k2 = add("K2", K2, 0.00365, 4.410e-7, "orange", {{F2, E2}});
    const int k3 = add("K3", K3, 0.02373, 5.255e-6, "blue", {{E3, B3}, {D3, B3}, {E3, D3}});
    const int k4 = add("K4", K4, 0.00706, 5.667e-7, "green", {{E4, G4}});
    const int k5 = add("K5", K5, 0.07050, 1.169e-5, "purple", {{G5, A5}});
    const int k6 = add("K6", K6, 0.00706, 5.667e-7, "sky", {{E6, H6}});
    const int k7 = add("K7", K7, 0.05498, 1.912e-5, "yellow", {{H7, A7}});

    scene.hinge("O", {0, Vec3::Zero()}, {k1, O1}, kZ);
    scene.say("The crank, with its motor.");
    scene.hinge("F", {k1, F1}, {k2, F2}, kZ);
    scene.hinge("B", {0, a.B}, {k3, B3}, kZ);
    scene.hinge("E3", {k2, E2}, {k3, E3}, kZ);
    scene.say("The first loop: crank, coupler and a rocker that the spring pulls.");
    scene.hinge("A5", {0, a.A}, {k5, A5}, kZ);
    scene.hinge("G", {k5, G5}, {k4, G4}, kZ);
    scene.hinge("E4", {k2, E2}, {k4, E4}, kZ);
    scene.say("The second loop.");
    scene.hinge("A7", {0, a.A}, {k7, A7}, kZ);
    scene.hinge("H", {k7, H7}, {k6, H6}, kZ);
    scene.hinge("E6", {k2, E2}, {k6, E6}, kZ);
    scene.say("The third loop: four bodies meet at E, and one freedom is left.");
    scene.lesson.camera = from_the_front();
    scene.look_of_ground(
        {Cylinder{a.A - 0.003 * kZ, a.A + 0.003 * kZ, 0.0012},
         Cylinder{a.B - 0.003 * kZ, a.B + 0.003 * kZ, 0.0012},
         Cylinder{a.C - 0.003 * kZ, a.C + 0.003 * kZ, 0.0012}, Cylinder{-0.003 * kZ, 0.003 * kZ, 0.0012}});

    Loads& loads = scene.plan().loads;
    loads.torques.push_back({k1, Vec3(0, 0, 0.033), Frame::global, {.polynomial = {1.0}}});
    Spring spring;
    spring.body_j = k3;
    spring.P_i_local = a.C;
    spring.P_j_local = D3;
    spring.stiffness = 4530.0;
    spring.free_length = 0.07785;
    loads.springs.push_back(spring);
    scene.plan().duration = 0.05;
    scene.plan().settings.step = 1e-5;
    scene.plan().point = BodyPoint{k1, F1};
    scene.plan().point_at_end = Vec3(-0.005208504722, 0.004676695260, 0.0);
    scene.claim(
        50, 41, 1,
        "In the plane 20 equations for 21 freedoms; out of it 30 equations, 21 of them independent.");
    const std::string test_set = "The reference of the test set, to 16 digits.";
    scene.prove(0.03, "O.angle", 15.81077119629904, 1e-7, test_set);
    scene.prove(0.03, "B.angle", 0.04082224013073101, 1e-7, test_set);
    scene.prove(0.03, "A5.angle", 0.5244099658805304, 1e-7, test_set);
    scene.prove(0.03, "A7.angle", 1.048080741042263, 1e-7, test_set);
    scene.prove(
        0.0, "energy.potential", 1.4357963991616702, 1e-9,
        "The spring alone: 4530 N/m (52.6725 - 77.85)² mm² / 2, from the coordinates of its ends.");
    scene.prove(
        0.03, "energy.sum", 1.9595884070100098, 1e-7,
        "Plus 0.033 N m times the turn of the crank, in the reference from -0.0617139 to 15.8107712 rad.");
    return scene.lesson;
}

}  // namespace jw::test
