#include "tests/reference/scenes.hpp"

#include "tests/reference/scene_parts.hpp"

namespace jw::reference {

namespace {

const Vec3 kDownY(0.0L, -9.81L, 0.0L);
const Vec3 kDownZ(0.0L, 0.0L, -9.81L);

/// 1 m, 1 kg, section 0.1 m x 0.1 m.
Body square_rod(const Vec3& a, const Vec3& b) { return rod(a, b, 1.0L, 1.0L / 600, 1.01L / 12); }

}  // namespace

Scene simple_pendulum() {
    Scene s = scene_named("simple-pendulum", "A01, J = 1e-3 kg m2 about the centre", kDownY, 10.0L);
    Body mass;
    mass.mass = 1.0L;
    mass.J = Vec3::Constant(1e-3L);
    mass.r = Vec3(-1.0L, 0.0L, 0.0L);
    s.body = add(s, mass);
    s.point = mass.r;
    hinge(s, JointKind::revolute, 0, s.body, Vec3::Zero());
    return s;
}

Scene four_bars(int windows) {
    Scene s = scene_named("", "A02, on the branch of parallelograms", kDownY, 10.0L);
    s.name = "four-bar-" + std::to_string(windows);
    s.passes_singular = true;
    const Vec3 clockwise(0.0L, 0.0L, -1.0L);
    const auto foot = [](int k) { return Vec3(static_cast<Real>(k), 0.0L, 0.0L); };
    const auto tip = [](int k) { return Vec3(static_cast<Real>(k), 1.0L, 0.0L); };
    // on that branch all rods have one angle and the couplers do not turn: a tree with one coordinate
    for (int k = 0; k <= windows; ++k) {
        Body upright = rod(foot(k), tip(k), 1.0L, 1e-3L, 1.0L / 12);
        spin(upright, clockwise, foot(k));
        hinge(s, JointKind::revolute, 0, add(s, upright), foot(k));
        if (k > 0) { s.joints.back().same_as = 0; }
    }
    for (int k = 0; k < windows; ++k) {
        Body coupler = rod(tip(k), tip(k + 1), 1.0L, 1e-3L, 1.0L / 12);
        coupler.v = clockwise.cross(Vec3::UnitY());
        hinge(s, JointKind::revolute, 1 + k, add(s, coupler), tip(k));
        s.joints.back().same_as = 0;
        s.joints.back().sense = -1.0L;
    }
    s.point = tip(0);
    return s;
}

Scene bricard_falling() {
    Scene s = scene_named("bricard-falling", "A04", kDownY, 10.0L);
    const Vec3 P[6] = {{0.0L, 0.0L, 0.0L},  {1.0L, 0.0L, 0.0L},  {1.0L, -1.0L, 0.0L},
                       {1.0L, -1.0L, 1.0L}, {0.0L, -1.0L, 1.0L}, {0.0L, 0.0L, 1.0L}};
    for (int k = 0; k < 5; ++k) {
        const int b = add(s, square_rod(P[k], P[k + 1]));
        hinge(s, JointKind::revolute, b - 1, b, P[k], Vec3::Unit((k + 1) % 3));
    }
    close(s, 0, 5, P[5], Vec3::UnitX());
    s.body = 3;
    s.point = P[3];
    return s;
}

Scene governor() {
    Scene s = scene_named("governor", "A05", kDownZ, 10.0L);
    // forces of springs this stiff have errors of rounding that smaller steps do not reduce
    s.finest = 1e-15L;
    const Vec3 omega(0.0L, 0.0L, 2.0L * kPi);
    Body shaft = rod(Vec3::Zero(), Vec3::UnitZ(), 0.3L, 0.3L * 2e-4L / 12, 0.3L * 1.0001L / 12);
    spin(shaft, omega, Vec3::Zero());
    const int shaft_index = add(s, shaft);
    hinge(s, JointKind::revolute, 0, shaft_index, Vec3::Zero());

    Body slider;
    slider.mass = 3.0L;
    slider.J = Vec3::Constant(3.0L * 0.01L / 6);
    slider.r = Vec3(0.0L, 0.0L, 0.5L);
    spin(slider, omega, Vec3::Zero());
    s.body = add(s, slider);
    s.point = Vec3(0.05L, 0.0L, 0.5L);
    hinge(s, JointKind::prismatic, shaft_index, s.body, slider.r);

    for (const Real side : {1.0L, -1.0L}) {
        const Vec3 pin(side * 0.05L, 0.0L, 1.0L);
        const Vec3 along(side * std::sqrt(0.75L), 0.0L, -0.5L);
        // 0.3 kg rod and a 5 kg point at its end
        const Real centre = (0.3L * 0.5L + 5.0L) / 5.3L;
        const Real across = 0.3L * 1.0001L / 12 + 0.3L * (centre - 0.5L) * (centre - 0.5L) +
                            5.0L * (1.0L - centre) * (1.0L - centre);
        Body arm = rod(pin, pin + 2.0L * centre * along, 5.3L, 0.3L * 2e-4L / 12, across);
        spin(arm, omega, Vec3::Zero());
        const int b = add(s, arm);
        hinge(s, JointKind::revolute, shaft_index, b, pin, Vec3::UnitY());
        s.springs.push_back(
            {s.body, b, Vec3(side * 0.05L, 0.0L, 0.5L), pin + 0.5L * along, 8e5L, 4e4L, 0.5L});
    }
    return s;
}

Scene chain(int rods, JointKind joints) {
    const bool balls = joints == JointKind::spherical;
    Scene s = scene_named("", balls ? "CHS" : "CHR", kDownY, 2.0L);
    s.name = (balls ? "chain-spherical-" : "chain-revolute-") + std::to_string(rods);
    Vec3 end_velocity = Vec3::Zero();
    for (int k = 1; k <= rods; ++k) {
        const Vec3 a(static_cast<Real>(k - 1), 0.0L, 0.0L);
        Body link = square_rod(a, a + Vec3::UnitX());
        const bool turns = balls || k % 4 == 2 || k % 4 == 3;
        if (turns) { link.omega = Vec3::UnitY(); }
        link.v = end_velocity + link.omega.cross(link.r - a);
        end_velocity += link.omega.cross(Vec3::UnitX());
        const int b = add(s, link);
        hinge(s, joints, b - 1, b, a, k % 2 == 1 ? Vec3::UnitZ() : Vec3::UnitY());
        s.body = b;
        s.point = a + Vec3::UnitX();
    }
    return s;
}

Scene spatial_slider_crank_falling() {
    Scene s = scene_named("spatial-slider-crank-falling", "wheel, rod and slide, from rest", kDownZ, 5.0L);
    const Vec3 shaft(0.0L, 0.3L, 0.6L);
    const Vec3 pin(0.0L, 0.6L, 0.6L);
    const Vec3 slide_at(std::sqrt(1.2L * 1.2L - 0.6L * 0.6L - 0.45L * 0.45L), 0.0L, 0.15L);
    Body wheel;
    wheel.mass = 2.0L;
    wheel.J = Vec3(0.1296L, 0.06490416666666667L, 0.06490416666666667L);
    wheel.r = shaft;
    const int wheel_index = add(s, wheel);
    Body slide;
    slide.mass = 1.0L;
    slide.J = Vec3(0.00173333333333333L, 0.00266666666666667L, 0.00333333333333333L);
    slide.r = slide_at;
    const int slide_index = add(s, slide);
    const int coupler = add(s, rod(slide_at, pin, 1.0L, 0.0002L, 0.1201L));
    hinge(s, JointKind::revolute, 0, wheel_index, shaft, Vec3::UnitX());
    hinge(s, JointKind::prismatic, 0, slide_index, slide_at, Vec3::UnitX());
    hinge(s, JointKind::spherical, wheel_index, coupler, pin);
    const Vec3 arm = (pin - slide_at).cross(Vec3::UnitY());
    s.joints.push_back({JointKind::universal, slide_index, coupler, slide_at, Vec3::UnitY(), arm, true});
    s.body = wheel_index;
    s.point = pin;
    return s;
}

Scene spinning_top() {
    Scene s = scene_named("spinning-top", "heavy symmetric top, released with spin only", kDownZ, 4.0L);
    const Vec3 axis(0.5L, 0.0L, std::sqrt(0.75L));
    Body top;
    top.mass = 0.5L;
    top.J = Vec3(0.0008L, 0.0008L, 0.0012L);
    top.r = 0.1L * axis;
    top.p = turn(Vec3::UnitY(), kPi / 6.0L);
    top.omega = 150.0L * axis;
    s.body = add(s, top);
    s.point = 0.16L * axis;
    hinge(s, JointKind::spherical, 0, s.body, Vec3::Zero());
    return s;
}

Scene free_asymmetric_body() {
    Scene s =
        scene_named("free-asymmetric-body", "torque-free, close to the middle axis", Vec3::Zero(), 20.0L);
    Body box;
    box.mass = 1.0L;
    box.J = Vec3(0.00363333333333333L, 0.0078L, 0.0108333333333333L);
    box.omega = Vec3(0.02L, 6.0L, 0.02L);
    s.body = add(s, box);
    s.point = Vec3(0.0L, 0.17L, 0.0L);
    // a ball at its centre of mass leaves it free to turn
    hinge(s, JointKind::spherical, 0, s.body, Vec3::Zero());
    return s;
}

std::vector<Scene> all_scenes() {
    return {
        simple_pendulum(),
        four_bars(1),
        four_bars(4),
        four_bars(16),
        four_bars(40),
        andrews(),
        bricard_falling(),
        governor(),
        chain(4, JointKind::revolute),
        chain(16, JointKind::revolute),
        chain(4, JointKind::spherical),
        chain(16, JointKind::spherical),
        spatial_slider_crank_falling(),
        spinning_top(),
        free_asymmetric_body()};
}

}  // namespace jw::reference
