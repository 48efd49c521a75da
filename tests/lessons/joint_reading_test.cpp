#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <set>

#include "core/model/placement.hpp"
#include "lessons/lesson/things.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/formula_value.hpp"
#include "tests/support/vector_formulas.hpp"

using namespace jw;
using test::is_near;
using test::kRounding;
using test::lesson_of;
using test::with_two_bodies;

namespace {

namespace authored = test::authored;

/// A joint between `base` (global frame) and `arm` (at (1, 2, 3), its x axis along global y).
Joint joint_with(const std::string& keys) {
    const Lesson lesson =
        lesson_of(with_two_bodies("[[joint]]\nname = \"j\"\nbodies = [\"base\", \"arm\"]\n" + keys + "\n"));
    REQUIRE(lesson.mechanism.joints.size() == 1);
    return lesson.mechanism.joints[0];
}

}  // namespace

TEST_CASE("Global points and axes become local ones", "[lessons][reading]") {
    const JointGeometry g =
        joint_with("type = \"revolute\"\nat = [4, 6, 3]\naxis = [0, 3, 4]\nside = [2, 0, 0]").geometry;
    CHECK(is_near(g.P_i_local, Vec3(4, 6, 3)));
    CHECK(is_near(g.P_j_local, Vec3(4, -3, 0)));
    CHECK(is_near(g.s_i_local, Vec3(0, 0.6, 0.8)));
    CHECK(is_near(g.s_j_local, Vec3(0.6, 0, 0.8)));
    // u_i = u_j = side
    CHECK(is_near(g.u_i_local, Vec3(1, 0, 0)));
    CHECK(is_near(g.u_j_local, Vec3(0, -1, 0)));
    // h_i = side, h_j = axis × side
    const JointGeometry slide =
        joint_with("type = \"prismatic\"\nat = [4, 6, 3]\naxis = [0, 3, 4]\nside = [2, 0, 0]").geometry;
    CHECK(is_near(slide.h_i_local, Vec3(1, 0, 0)));
    CHECK(is_near(slide.h_j_local, Vec3(0.8, 0, -0.6)));
}

TEST_CASE("Local points and vectors are used exactly as typed", "[lessons][reading]") {
    const JointGeometry g =
        joint_with(
            "type = \"prismatic\"\npoint_i = [0.1, 0.2, 0.3]\npoint_j = [-0.7, 0, 11]\naxis_i = [0, 0, 7]\n"
            "axis_j = [0, 0.3, 0]\nside_i = [2, 0, 0]\nside_j = [0, 0, 0.1]")
            .geometry;
    CHECK(g.P_i_local == Vec3(0.1, 0.2, 0.3));
    CHECK(g.P_j_local == Vec3(-0.7, 0, 11));
    CHECK(g.s_i_local == Vec3(0, 0, 7));
    CHECK(g.s_j_local == Vec3(0, 0.3, 0));
    CHECK(g.h_i_local == Vec3(2, 0, 0));
    CHECK(g.h_j_local == Vec3(0, 0, 0.1));
    CHECK(is_near(g.u_j_local, Vec3(0, 0, 1)));
}

TEST_CASE("A global point goes with local axes", "[lessons][reading]") {
    const JointGeometry g =
        joint_with("type = \"revolute\"\nat = [1, 2, 3]\naxis_i = [0, 0, 2]\naxis_j = [0, 0, 5]").geometry;
    CHECK(is_near(g.P_i_local, Vec3(1, 2, 3)));
    CHECK(is_near(g.P_j_local, Vec3::Zero()));
    CHECK(g.s_j_local == Vec3(0, 0, 5));
}

TEST_CASE("Without a side the start pose has angle 0 and perpendicular h", "[lessons][reading]") {
    const auto axes = GENERATE(
        "axis = [1, 2, -2]", "axis = [0, 0, -1]", "axis_i = [0, 0, 1]\naxis_j = [0, 0, 3]",
        // anti-parallel and oblique starts: after the shortest turn onto each other
        "axis_i = [1, 0, 0]\naxis_j = [0, 1, 0]");
    CAPTURE(axes);
    const std::string both = "\"\nbodies = [\"base\", \"arm\"]\nat = [0, 0, 0]\n" + std::string(axes) + "\n";
    const std::string joints = "[[joint]]\nname = \"turns\"\ntype = \"cylindrical" + both +
                               "[[joint]]\nname = \"slides\"\ntype = \"prismatic" + both;
    const Lesson lesson = lesson_of(with_two_bodies(joints));
    const Joint& turns = lesson.mechanism.joints[0];
    CHECK(std::abs(relative_angle(turns, start_state(lesson.mechanism))) < kRounding);
    CHECK(std::abs(turns.geometry.u_i_local.dot(turns.geometry.s_i_local)) < kRounding);
    const JointGeometry& slides = lesson.mechanism.joints[1].geometry;
    CHECK(std::abs(slides.h_j_local.dot(turns.geometry.u_j_local)) < kRounding);
    CHECK(std::abs(slides.h_j_local.dot(slides.s_j_local)) < kRounding);
}

TEST_CASE("A universal joint takes its two arms globally or locally", "[lessons][reading]") {
    const JointGeometry global =
        joint_with("type = \"universal\"\nat = [0, 0, 0]\naxis = [3, 0, 0]\naxis2 = [0, 2, 0]").geometry;
    CHECK(is_near(global.s_i_local, Vec3(1, 0, 0)));
    CHECK(is_near(global.s_j_local, Vec3(1, 0, 0)));
    const JointGeometry local =
        joint_with("type = \"universal\"\nat = [0, 0, 0]\naxis_i = [3, 0, 0]\naxis_j = [0, 2, 1]").geometry;
    CHECK(local.s_i_local == Vec3(3, 0, 0));
    CHECK(local.s_j_local == Vec3(0, 2, 1));
}

TEST_CASE("A screw starts on its thread unless the lesson says otherwise", "[lessons][reading]") {
    const std::string nut =
        "type = \"screw\"\nat = [0, 0, 0]\nto = [0, 0, 0.5]\naxis = [0, 0, 1]\npitch = -0.01\n";
    const JointGeometry g = joint_with(nut).geometry;
    CHECK(g.alpha == Approx(-0.01 / (2.0 * std::numbers::pi)).margin(1e-17));
    CHECK(g.d_0 == Approx(0.5).margin(kRounding));
    CHECK(std::abs(g.theta_0) < kRounding);
    CHECK(g.screw_angle_form == ScrewAngleForm::rotation);

    const JointGeometry told =
        joint_with(nut + "d_0 = 0.25\ntheta_0_deg = 30\nangle_row = \"cosine\"").geometry;
    CHECK(told.d_0 == 0.25);
    CHECK(told.theta_0 == Approx(std::numbers::pi / 6).margin(kRounding));
    CHECK(told.screw_angle_form == ScrewAngleForm::cosine);
    CHECK(joint_with(nut + "theta_0_rad = 7").geometry.theta_0 == 7.0);
    CHECK(joint_with(nut + "angle_row = \"sine\"").geometry.screw_angle_form == ScrewAngleForm::sine);
    CHECK_FALSE(told.theta_start.has_value());
    // one of the two alone: the start pose still lies on the thread, turns included
    const JointGeometry turned = joint_with(nut + "theta_deg = 720\nd_0 = 0.51").geometry;
    CHECK(
        (0.5 - turned.d_0) - turned.alpha * (4.0 * std::numbers::pi - turned.theta_0) ==
        Approx(0.0).margin(1e-15));
    const JointGeometry raised = joint_with(nut + "theta_0_deg = 90").geometry;
    CHECK((0.5 - raised.d_0) - raised.alpha * (0.0 - raised.theta_0) == Approx(0.0).margin(1e-15));
    const JointGeometry started = joint_with(nut + "theta_deg = 450\ntheta_dot_rad_per_s = -2").geometry;
    CHECK(started.theta_start.value() == Approx(2.5 * std::numbers::pi).margin(kRounding));
    CHECK(started.theta_dot_start.value() == -2.0);
    // sides a quarter turn apart: that is θ0
    const JointGeometry quarter =
        joint_with(
            "type = \"screw\"\nat = [0, 0, 0]\naxis_i = [0, 0, 1]\naxis_j = [0, 0, 1]\nside_i = [1, 0, 0]\n"
            "side_j = [1, 0, 0]\npitch = 1")
            .geometry;
    CHECK(quarter.theta_0 == Approx(std::numbers::pi / 2).margin(kRounding));
}

TEST_CASE("A distance is given or measured at the start pose", "[lessons][reading]") {
    CHECK(joint_with("type = \"distance\"\nat = [0, 0, 0]\nto = [3, 0, 4]").geometry.length == 5.0);
    CHECK(
        joint_with("type = \"distance\"\nat = [0, 0, 0]\nto = [3, 0, 4]\nlength = 2").geometry.length == 2.0);
    const JointGeometry local =
        joint_with("type = \"distance\"\npoint_i = [1, 2, 0]\npoint_j = [0, 0, 1]").geometry;
    CHECK(local.length == Approx(4.0).margin(kRounding));
}

TEST_CASE("n2 and p2 join two points and need the first body's axis only", "[lessons][reading]") {
    const auto type = GENERATE("n2", "p2");
    const JointGeometry g =
        joint_with("type = \"" + std::string(type) + "\"\nat = [0, 0, 0]\nto = [1, 2, 4]\naxis_i = [0, 0, 2]")
            .geometry;
    CHECK(is_near(g.P_i_local, Vec3::Zero()));
    CHECK(is_near(g.P_j_local, Vec3(0, 0, 1)));
    CHECK(g.s_i_local == Vec3(0, 0, 2));
}

TEST_CASE("A formula joint has the vectors that are given, and those of the frames", "[lessons][reading]") {
    const std::string equation = "type = \"formula\"\nformula = '\\mathbf{d}^T \\mathbf{d} = 4'\n";
    const JointGeometry bare = joint_with(equation).geometry;
    CHECK(bare.formula == authored::equation(authored::dot(FormulaVector::d, FormulaVector::d), 4.0));
    CHECK((bare.P_i_local == Vec3::Zero() && bare.P_j_local == Vec3::Zero()));
    CHECK((bare.s_i_local == Vec3::UnitZ() && bare.s_j_local == Vec3::UnitZ()));
    CHECK((bare.u_i_local == Vec3::UnitX() && bare.u_j_local == Vec3::UnitX()));
    const JointGeometry placed =
        joint_with(equation + "at = [4, 6, 3]\nto = [1, 2, 4]\naxis = [0, 3, 4]\nside = [2, 0, 0]").geometry;
    CHECK(is_near(placed.P_i_local, Vec3(4, 6, 3)));
    CHECK(is_near(placed.P_j_local, Vec3(0, 0, 1)));
    CHECK(is_near(placed.s_i_local, Vec3(0, 0.6, 0.8)));
    CHECK(is_near(placed.s_j_local, Vec3(0.6, 0, 0.8)));
    CHECK(is_near(placed.u_i_local, Vec3(1, 0, 0)));
    const JointGeometry local =
        joint_with(
            equation + "point_i = [1, 2, 0]\npoint_j = [0, 0, 1]\nside_i = [0, 3, 0]\nside_j = [1, 1, 0]")
            .geometry;
    CHECK((local.P_i_local == Vec3(1, 2, 0) && local.P_j_local == Vec3(0, 0, 1)));
    CHECK((local.s_i_local == Vec3::UnitZ() && local.u_i_local == Vec3::UnitY()));
    CHECK(is_near(local.u_j_local, Vec3(1, 1, 0).normalized()));
}

TEST_CASE("A formula joint is computed as its text says, step by step", "[lessons][reading]") {
    using namespace authored;
    using enum FormulaVector;
    const auto steps_of = [](const std::string& text) {
        return joint_with("type = \"formula\"\nformula = '" + text + "'").geometry.formula.steps;
    };
    for (const ScalarFormula& formula :
         {equation(of_all_vectors(-0.7), 1e-7), equation(dot(s_i, A_j_z), -0.25),
          equation(dot(r_i_P, u_j), 0.0),
          equation(square_root(dot(d, d)) - number(0.3) * sine(dot(u_i, u_j)), 123456.75),
          equation(component(r_i_P, 0) - component(r_j_P, 0) * component(s_j, 2), 0.5),
          equation(
              power(number(3.0) - component(d, 1), -2.0) / (number(2.0) + cosine(dot(r_i, r_j))), 1.0)}) {
        CAPTURE(formula.source);
        CHECK(steps_of(formula.source) == formula.steps);
    }
    // products with entries 0 and 1 of a matrix are not computed
    const std::string column = "\\begin{bmatrix} 0 \\\\ 1 \\\\ 0 \\end{bmatrix}";
    CHECK(steps_of("u_j^T \\mathbf{A}_i " + column + " = 0.5") == equation(dot(u_j, A_i_y), 0.5).steps);
    CHECK(steps_of("\\mathbf{s}_i \\cdot \\mathbf{d}") == equation(dot(s_i, d), 0.0).steps);
    CHECK(steps_of("s_i^T d = 2 s_{(x)j}") == (dot(s_i, d) - number(2.0) * component(s_j, 0)).steps);
    CHECK(steps_of("|d| = 0.5") == equation(square_root(dot(d, d)), 0.5).steps);
    CHECK(steps_of("s_{zi}^P = 0") == (component(r_i_P, 2) - component(r_i, 2)).steps);
}

TEST_CASE("Vectors and matrices in the formula of a joint are multiplied as on paper", "[lessons][reading]") {
    // as s_i, s_j and d, and any other numbers
    std::vector<double> variables(3 * kFormulaVectors);
    for (std::size_t k = 0; k < variables.size(); ++k) {
        variables[k] = std::sin(3.0 * static_cast<double>(k));
    }
    const auto vector = [&](FormulaVector v) {
        return Vec3(Eigen::Map<const Vec3>(&variables[static_cast<std::size_t>(variable_of(v, 0))]));
    };
    const Vec3 a = vector(FormulaVector::s_i);
    const Vec3 b = vector(FormulaVector::s_j);
    const Vec3 c = vector(FormulaVector::d);
    Mat3 A;
    A << vector(FormulaVector::A_i_x), vector(FormulaVector::A_i_y), vector(FormulaVector::A_i_z);
    const auto value_of = [&](const std::string& text) {
        const Joint joint = joint_with("type = \"formula\"\nformula = '" + text + "'");
        const std::vector<long double> numbers(variables.begin(), variables.end());
        return static_cast<double>(test::formula_value(joint.geometry.formula.steps, numbers));
    };
    const auto near = [](double x) { return Approx(x).epsilon(1e-14).margin(1e-14); };
    CHECK(value_of("s_i^T (s_j \\times d)") == near(a.dot(b.cross(c))));
    CHECK(value_of("(\\tilde{s}_i s_j)^T d") == near(a.cross(b).dot(c)));
    CHECK(value_of("s_i^T A_i d - \\frac{s_j^T d}{2}") == near(a.dot(A * c) - 0.5 * b.dot(c)));
    CHECK(value_of("s_i^T A_i^T d") == near(a.dot(A.transpose() * c)));
    CHECK(value_of("(2 s_i - s_j)^T d") == near((2.0 * a - b).dot(c)));
    CHECK(value_of("|s_i - d|^3") == near(std::pow((a - c).norm(), 3.0)));
    CHECK(
        value_of("s_i^T \\begin{bmatrix} 1 & 2 & 0 \\\\ 0 & 0 & d_x \\\\ 0 & 1 & 0 \\end{bmatrix} s_j") ==
        near(a.x() * (b.x() + 2.0 * b.y()) + a.y() * c.x() * b.z() + a.z() * b.y()));
}

TEST_CASE("Every joint type can be read, with its number of equations", "[lessons][reading]") {
    for (const JointType& type : kJointTypes) {
        CAPTURE(type.name);
        std::string keys = "type = \"" + std::string(type.name) + "\"\n";
        const bool arms = JointNeeds(type).arms;
        if (type.uses(kAxisI)) { keys += "axis = [0, 0, 1]\n"; }
        if (arms) { keys += "axis2 = [1, 0, 0]\n"; }
        if (JointNeeds(type).points) { keys += "at = [0, 0, 0]\n"; }
        if (type.uses(Role::length)) { keys += "to = [0, 0, 1]\n"; }
        if (type.uses(Role::wheel_i)) { keys += "to = [0, 1, 0]\n"; }
        if (type.uses(Role::screw_advance)) { keys += "pitch = 1\n"; }
        if (type.uses(Role::rack_advance)) { keys += "radius = 1\n"; }
        if (type.uses(Role::curve_x)) { keys += "curve = { cos = [[1, 0, 0]], sin = [[0, 1, 0]] }\n"; }
        if (type.uses(Role::wheel_i) || type.uses(Role::bevel_i)) { keys += "ratio = -2\n"; }
        if (type.has_formula()) { keys += "formula = 's_i^T s_j = 0.5'\n"; }
        CHECK(joint_with(keys).type == &type);
    }
}

TEST_CASE("The form of parallel equations is read by name", "[lessons][reading]") {
    const std::string hinge = "type = \"revolute\"\nat = [0, 0, 0]\naxis = [0, 0, 1]\nparallel = ";
    CHECK(joint_with(hinge + "\"rule\"").parallel_form == ParallelForm::rule);
    CHECK(joint_with(hinge + "\"drop x\"").parallel_form == ParallelForm::drop_x);
    CHECK(joint_with(hinge + "\"drop y\"").parallel_form == ParallelForm::drop_y);
    CHECK(joint_with(hinge + "\"drop z\"").parallel_form == ParallelForm::drop_z);
    CHECK(joint_with(hinge + "\"all three\"").parallel_form == ParallelForm::all_three);
    CHECK(joint_with(hinge + "\"pair\"").parallel_form == ParallelForm::pair);
}

TEST_CASE("Equations are taken out by the names beside their rows", "[lessons][reading]") {
    const Joint revolute =
        joint_with("type = \"revolute\"\nat = [0, 0, 0]\naxis = [0, 0, 1]\nwithout = [\"p1 y\", \"s x\"]");
    CHECK(revolute.without == std::vector<EquationOut>{{Role::axes_parallel, 1}, {Role::same_point, 0}});
    const Joint screw = joint_with(
        "type = \"screw\"\nat = [0, 0, 0]\naxis = [0, 0, 1]\npitch = 1\nparallel = \"pair\"\n"
        "without = [\"n2 pair b\", \"r\", \"theta\"]");
    CHECK(
        screw.without == std::vector<EquationOut>{
                             {Role::distance_parallel, 1}, {Role::screw_advance, 0}, {Role::screw_angle, 0}});
    CHECK(joint_with("type = \"s\"\nat = [0, 0, 0]\nwithout = []").without.empty());
}

TEST_CASE("No two equations of a joint have the same name", "[lessons][reading]") {
    for (const JointType& type : kJointTypes) {
        for (int form = 0; form < 6; ++form) {
            std::set<std::string> labels;
            const auto all = equations_of(type, static_cast<ParallelForm>(form));
            for (const LabelledEquation& one : all) { labels.insert(one.label); }
            CHECK(labels.size() == all.size());
        }
    }
}
