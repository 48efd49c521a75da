#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "core/motion/loads.hpp"
#include "tests/support/vector_formulas.hpp"

/// Seeded random scenes for property tests.
namespace jw::test {

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double number(double low = -1.0, double high = 1.0) { return low + (high - low) * unit_(engine_); }
    Vec3 vector(double size = 1.0) { return size * Vec3(number(), number(), number()); }
    Vec3 direction() {
        Vec3 v = vector();
        while (v.norm() < 0.2) { v = vector(); }
        return v.normalized();
    }
    Vec4 unit_p() {
        Vec4 p(number(), number(), number(), number());
        while (p.norm() < 0.2) { p = Vec4(number(), number(), number(), number()); }
        return p.normalized();
    }

private:
    std::mt19937 engine_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

inline Body random_body(Random& random, const std::string& name) {
    Body body;
    body.name = name;
    body.r = random.vector(2.0);
    body.p = random.unit_p();
    body.r_dot = random.vector();
    body.omega_local = random.vector(2.0);
    return body;
}

/// Vectors of any length and direction; only what must be unit or perpendicular is.
inline JointGeometry random_geometry(Random& random) {
    JointGeometry g;
    g.P_i_local = random.vector();
    g.P_j_local = random.vector();
    g.s_i_local = random.number(0.5, 2.0) * random.direction();
    g.s_j_local = random.number(0.5, 2.0) * random.direction();
    g.h_i_local = random.vector() + Vec3(0.3, 0.0, 0.0);
    g.h_j_local = random.vector() + Vec3(0.0, 0.3, 0.0);
    g.u_i_local = perpendicular_to(g.s_i_local);
    g.u_j_local = random.direction();
    g.length = random.number(0.5, 2.0);
    g.alpha = random.number(-0.5, 0.5);
    g.d_0 = random.number();
    g.theta_0 = random.number();
    g.ratio = 0.3 + g.d_0;
    g.curve.constant = g.h_i_local;
    g.curve.linear = 0.2 * g.h_j_local;
    g.curve.harmonics = {{g.P_i_local, g.P_j_local}, {0.2 * g.s_i_local, 0.2 * g.s_j_local}};
    g.formula = authored::equation(authored::of_all_vectors(g.length), g.theta_0);
    return g;
}

/// Two moving bodies and one joint between them.
inline Mechanism random_joint(
    Random& random, const JointType& type, ParallelForm form, ScrewAngleForm screw) {
    Mechanism m;
    m.bodies = {random_body(random, "i"), random_body(random, "j")};
    Joint joint;
    joint.name = "joint";
    joint.type = &type;
    joint.body_i = 0;
    joint.body_j = 1;
    joint.geometry = random_geometry(random);
    joint.geometry.screw_angle_form = screw;
    joint.parallel_form = form;
    m.joints.push_back(joint);
    return m;
}

/// A sin(B t + C) exp(-t / 4), with numbers that can be written with six digits.
inline TimeFormula dying_swing(double a, double b, double c) {
    using Kind = FormulaStep::Kind;
    const auto typed = [](double x) { return std::max(1.0, std::round(64.0 * std::abs(x))) / 64.0; };
    const auto text = [](double x) {
        char digits[16];
        std::snprintf(digits, sizeof digits, "%.6f", x);
        return std::string(digits);
    };
    const double A = typed(a);
    const double B = typed(b);
    const double C = typed(c);
    return {
        {text(A) + " \\sin(" + text(B) + " t + " + text(C) + ") \\exp(-\\frac{t}{4})",
         {{Kind::number, A},
          {Kind::number, B},
          {Kind::variable},
          {Kind::product},
          {Kind::number, C},
          {Kind::sum},
          {Kind::sine},
          {Kind::product},
          {Kind::variable},
          {Kind::number, 4.0},
          {Kind::quotient},
          {Kind::negative},
          {Kind::exponential},
          {Kind::product}}},
        1.0};
}

/// k \sin(d) + c \dot{d}^3: bounded in d; the letter is that of a displacement or an angle.
inline ScalarFormula sine_law(double k, double c, const std::string& letter) {
    using Kind = FormulaStep::Kind;
    const auto text = [](double x) {
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.17f", x);
        return std::string(digits);
    };
    return {
        text(k) + " \\sin(" + letter + ") + " + text(c) + " \\dot{" + letter + "}^3",
        {{Kind::number, k},
         {Kind::variable, 0.0},
         {Kind::sine},
         {Kind::product},
         {Kind::number, c},
         {Kind::variable, 1.0},
         {Kind::power, 3.0},
         {Kind::product},
         {Kind::sum}}};
}

inline TimeFunction random_function(Random& random) {
    TimeFunction f;
    f.polynomial = {random.number(0.5, 1.0), random.number(), random.number(), random.number()};
    f.harmonics = {{random.number(), random.number(0.5, 3.0), random.number()}};
    f.steps = {{random.number(), random.number(), -0.5, 1.5}};
    // of numbers that are drawn already, so that others stay what they were
    f.formula = dying_swing(f.steps[0].from, 2.0 + f.steps[0].to, f.harmonics[0].phase);
    return f;
}

/// A table of values at times from -3 to 3.
inline TimeTable random_table(
    Random& random, TimeTable::Interpolation interpolation = TimeTable::Interpolation::smooth) {
    std::vector<double> values;
    for (int k = 0; k < 5; ++k) { values.push_back(random.number()); }
    return table_through({-3.0, -1.1, 0.35, 1.7, 3.0}, values, interpolation);
}

/// Two moving bodies and one driver of every measure.
inline Mechanism random_drivers(Random& random) {
    Mechanism m;
    m.bodies = {random_body(random, "i"), random_body(random, "j")};
    Joint screw;
    screw.name = "screw";
    screw.type = find_joint_type("screw");
    screw.body_i = 0;
    screw.body_j = 1;
    screw.geometry = random_geometry(random);
    m.joints.push_back(screw);
    const auto add = [&](const Measure& measure, int joint) {
        m.drivers.push_back({"driver", joint, 0, 1, measure, random_function(random)});
    };
    add(
        AngleMeasure{
            screw.geometry.s_i_local.normalized(), screw.geometry.u_i_local, screw.geometry.u_j_local},
        -1);
    add(DisplacementMeasure{random.direction(), random.vector(), random.vector()}, -1);
    add(SquaredDistanceMeasure{random.vector(), random.vector()}, -1);
    for (int k = 0; k < 7; ++k) { add(CoordinateMeasure{k}, -1); }
    add(ThetaMeasure{}, 0);
    // with numbers of their own, so that those of the caller stay what they were
    Random of_tables(static_cast<unsigned>(m.drivers.size()));
    for (Driver& driver : m.drivers) { driver.function.table = random_table(of_tables); }
    return m;
}

/// A bushing without damping, anywhere in its bodies.
inline Bushing random_bushing(Random& random, int body_i, int body_j) {
    Bushing out;
    out.body_i = body_i;
    out.body_j = body_j;
    out.P_i_local = random.vector();
    out.P_j_local = random.vector();
    out.axes_i_local = rotation_matrix(random.unit_p());
    out.axes_j_local = rotation_matrix(random.unit_p());
    out.stiffness = Vec3(random.number(1.0, 20.0), random.number(1.0, 20.0), random.number(1.0, 20.0));
    out.rotational_stiffness =
        Vec3(random.number(1.0, 5.0), random.number(1.0, 5.0), random.number(1.0, 5.0));
    return out;
}

}  // namespace jw::test
