#include <cmath>
#include <tuple>

#include <catch2/catch.hpp>

#include "core/kinematics/proof/step_proof.hpp"
#include "core/poses/position.hpp"
#include "tests/support/moved_positions.hpp"
#include "tests/support/scene_builder.hpp"

/// Equations that an author writes: those of other joints spelled out, functions of them, and formulas
/// without bounds.
namespace jw::test::of_formula_joints {

using namespace authored;
using enum FormulaVector;
using reference::Real;

namespace {

struct Numbers {
    VectorX phi;
    MatrixX jacobian;
    VectorX gamma;
};

template <class C>
Numbers numbers_of(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    Assembler<C> assembler(system);
    assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
    assembler.assemble_gamma(start_state(mechanism), start_motion(mechanism), 0.0);
    return {assembler.phi(), assembler.jacobian(), assembler.gamma()};
}

/// The first joint as joints of one equation each, with its own vectors.
Mechanism spelled_out(Mechanism mechanism, const std::vector<Part>& rows, double right) {
    Joint joint = mechanism.joints[0];
    joint.type = find_joint_type("formula");
    mechanism.joints.clear();
    for (const Part& row : rows) {
        joint.geometry.formula = equation(row, right);
        mechanism.joints.push_back(joint);
    }
    return mechanism;
}

std::vector<Part> cross(FormulaVector a, FormulaVector b) {
    std::vector<Part> rows;
    for (int k = 0; k < 3; ++k) {
        const int y = (k + 1) % 3;
        const int z = (k + 2) % 3;
        rows.push_back(component(a, y) * component(b, z) - component(a, z) * component(b, y));
    }
    return rows;
}

std::vector<Part> from_one_point_to_the_other() {
    std::vector<Part> rows;
    for (int k = 0; k < 3; ++k) { rows.push_back(component(r_i_P, k) - component(r_j_P, k)); }
    return rows;
}

/// Formulas that are smooth at all poses, of vectors up to 2 long.
std::vector<Part> smooth_formulas() {
    return {
        sine(dot(s_i, s_j)) - cosine(number(0.5) * component(d, 2)),
        square_root(number(20.0) + dot(d, d)),
        dot(s_i, d) / (number(5.0) + power(dot(u_i, u_j), 2.0)),
        power(number(6.0) + dot(s_j, u_i), -1.5) * power(number(0.1) * dot(r_i, r_j_P), 3.0),
        sine(square_root(number(20.0) + dot(d, d)) / (number(6.0) - dot(A_i_x, A_j_y))),
        of_all_vectors(0.7)};
}

/// A crank whose angle a formula of x = s_iᵀ s_j holds at one radian, where x is its cosine.
Mechanism held_crank(const Part& left, double right) {
    SceneBuilder scene;
    const int crank = scene.add_body("crank", Vec3(0.3, 0.1, 0.0));
    scene.add_joint("revolute", 0, crank, Vec3::Zero(), Vec3::UnitZ());
    JointGeometry& g = scene.add_joint("formula", 0, crank, Vec3::Zero(), Vec3::UnitZ()).geometry;
    g.s_i_local = scene.local(0, Vec3::UnitX());
    g.s_j_local = scene.local(crank, Vec3(std::cos(1.0), std::sin(1.0), 0.0));
    g.formula = equation(left, right);
    return scene.mechanism;
}

struct Verdict {
    bool decided = false;
    bool holds = false;
    double margin = 0.0;
};
/// Whether the crank is proved to stay where it is for 10 ms.
Verdict verdict_on(const Mechanism& mechanism) {
    System system(mechanism, everything(mechanism));
    const State state = start_state(mechanism);
    const Motion still = zero_motion(mechanism);
    system.choose_rows(state);
    StepProof proof(system);
    Verdict verdict;
    verdict.decided = proof.decides_at({0.0, &state, &still});
    verdict.margin = proof.margin();
    verdict.holds = proof.holds({0.0, &state, &still}, {0.01, &state, &still});
    return verdict;
}

}  // namespace

TEMPLATE_TEST_CASE(
    "A formula that spells the equations of another joint out has their value, Jacobian and gamma",
    "[core][formula_joint]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Random random(seed);
        const auto check = [&](const char* type, const std::vector<Part>& rows, double right = 0.0) {
            CAPTURE(type, seed);
            Mechanism joint = random_joint(
                random, *find_joint_type(type), ParallelForm::all_three, ScrewAngleForm::rotation);
            joint.joints[0].geometry.length = std::sqrt(right);
            const Numbers expected = numbers_of<TestType>(joint);
            const Numbers found = numbers_of<TestType>(spelled_out(joint, rows, right));
            REQUIRE(found.phi.size() == expected.phi.size());
            // sums of some ten products of size 100 at most, each rounded by 1e-16 of itself
            constexpr double rounding = 1e-12;
            CHECK((found.phi - expected.phi).norm() < rounding);
            CHECK((found.jacobian - expected.jacobian).norm() < rounding);
            CHECK((found.gamma - expected.gamma).norm() < rounding);
        };
        check("n1", {dot(s_i, s_j)});
        check("n2", {dot(s_i, d)});
        check("distance", {dot(d, d)}, 2.25);
        check("s", from_one_point_to_the_other());
        check("p1", cross(s_i, s_j));
        check("p2", cross(s_i, d));
    }
}

TEMPLATE_TEST_CASE(
    "Jacobian and gamma of functions of vectors are differences of their value along a motion",
    "[core][formula_joint]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    using C = TestType;
    for (const Part& left : smooth_formulas()) {
        for (unsigned seed = 1; seed <= 3; ++seed) {
            CAPTURE(left.text, seed);
            Random random(seed);
            Mechanism mechanism = random_joint(
                random, *find_joint_type("formula"), ParallelForm::rule, ScrewAngleForm::rotation);
            mechanism.joints[0].geometry.formula = equation(left, 0.3);
            const System system(mechanism, everything(mechanism));
            const State state = start_state(mechanism);
            const Numbers found = numbers_of<C>(mechanism);
            const VectorX v = Assembler<C>(system).layout().columns_of(state, start_motion(mechanism));
            VectorX a(v.size());
            for (double& entry : a) { entry = random.number(); }
            const VectorX none = VectorX::Zero(v.size());
            constexpr bool homogeneous = C::kChoice != CoordinateChoice::true_euler_parameters;
            const auto phi = [&](const VectorX& velocity, const VectorX& acceleration, Real t) {
                return reference::phi(
                    system, moved<C>(system, state, velocity, acceleration, t), 0, homogeneous, false);
            };
            // of order 4 in long double: truncation and rounding leave 1e-10 of derivatives of size 1 to 100
            const auto close = [](double ours, Real theirs) {
                const auto expected = static_cast<double>(theirs);
                return std::abs(ours - expected) <= 1e-9 * std::max(1.0, std::abs(expected));
            };
            CHECK(close(found.phi(0), phi(none, none, 0)(0)));
            for (Eigen::Index k = 0; k < v.size(); ++k) {
                CAPTURE(k);
                const auto along = [&](Real t) { return phi(VectorX::Unit(v.size(), k), none, t); };
                CHECK(close(found.jacobian(0, k), first_difference_of(along, 1e-4L)(0)));
            }
            const auto moving = [&](Real t) { return phi(v, a, t)(0); };
            const Real h = 5e-4L;
            const Real second =
                (16 * (moving(h) + moving(-h)) - (moving(2 * h) + moving(-2 * h)) - 30 * moving(0)) /
                (12 * h * h);
            CHECK(close(found.jacobian.row(0).dot(a) - found.gamma(0), second));
        }
    }
}

TEST_CASE("A pose that a formula with bounds determines is proved", "[core][formula_joint]") {
    const double x = std::cos(1.0);
    const Part cosine_of_angle = dot(s_i, s_j);
    for (const auto& [left, right] : std::vector<std::pair<Part, double>>{
             {cosine_of_angle, x},
             {sine(cosine_of_angle), std::sin(x)},
             {number(3.0) * square_root(number(2.0) + cosine_of_angle), 3.0 * std::sqrt(2.0 + x)},
             {number(1.0) / (number(2.0) + cosine_of_angle), 1.0 / (2.0 + x)},
             {power(cosine_of_angle, 3.0), x * x * x}}) {
        CAPTURE(left.text);
        const Verdict verdict = verdict_on(held_crank(left, right));
        CHECK(verdict.decided);
        CHECK(verdict.holds);
        CHECK(verdict.margin > 0.0);
    }
}

/// Formulas that have a pole, or the end of a root, at this distance from the pose of held_crank.
std::vector<std::pair<Part, double>> formulas_beside_a_pole(double gap) {
    const Part beside = dot(s_i, s_j) - number(std::cos(1.0) - gap);
    return {
        {square_root(beside), std::sqrt(gap)},
        {number(2.0) * square_root(beside), 2.0 * std::sqrt(gap)},
        {sine(square_root(beside)), std::sin(std::sqrt(gap))},
        {number(gap) / beside, 1.0},
        {square_root(number(gap) / beside) + dot(s_i, s_j), 1.0 + std::cos(1.0)},
        {power(beside, -1.5), std::pow(gap, -1.5)},
        {number(0.0) * square_root(beside) + dot(s_i, s_j), std::cos(1.0)}};
}

TEST_CASE(
    "Near a pole of a formula, and where it is steep, a small region is proved", "[core][formula_joint]") {
    auto formulas = formulas_beside_a_pole(1e-3);
    formulas.emplace_back(power(number(1.0 / std::cos(1.0)) * dot(s_i, s_j), 200.0), 1.0);
    for (const auto& [left, right] : formulas) {
        CAPTURE(left.text);
        const Verdict verdict = verdict_on(held_crank(left, right));
        CHECK(verdict.decided);
        CHECK(verdict.holds);
    }
}

TEST_CASE(
    "Where a formula has no bounds nothing is proved, and nothing is undefined", "[core][formula_joint]") {
    // regular at the pose, but with a pole or the end of a root so near that every region contains it
    const double gap = GENERATE(1e-6, 1e-9);
    for (const auto& [left, right] : formulas_beside_a_pole(gap)) {
        CAPTURE(left.text, gap);
        const Verdict verdict = verdict_on(held_crank(left, right));
        CHECK_FALSE(verdict.decided);
        CHECK_FALSE(verdict.holds);
        CHECK(std::isfinite(verdict.margin));
    }
}

struct Closed {
    PositionOutcome outcome;
    double d_x = 0.0;
};

/// A free body with the one equation `left` = `right`, from d_x = `x` on.
Closed closed_from(double x, const Part& left, double right) {
    SceneBuilder scene;
    const int body = scene.add_body("body", scene.mechanism.bodies[0].r + Vec3(x, 0.2, 0.0));
    scene.add_joint("formula", 0, body, Vec3::Zero(), Vec3::UnitZ());
    JointGeometry& g = scene.mechanism.joints[0].geometry;
    g.P_i_local = g.P_j_local = Vec3::Zero();
    g.formula = equation(left, right);
    const System system(scene.mechanism, everything(scene.mechanism));
    State state = start_state(scene.mechanism);
    Closed out{solve_position<OmegaLocal>(system, state, 0.0)};
    out.d_x = state.r[static_cast<std::size_t>(body)].x() - state.r[0].x();
    return out;
}

TEST_CASE("A formula far steeper at the start is closed as exactly as others", "[core][formula_joint]") {
    // Newton's tolerance, 1e-10 of the slope at the solution
    for (const double power_of_x : {-12.0, -6.0, 4.0, 50.0}) {
        CAPTURE(power_of_x);
        const Closed found =
            closed_from(power_of_x < 0.0 ? 0.1 : 0.7, power(component(d, 0), power_of_x), 1.0);
        REQUIRE(found.outcome.ok());
        CHECK(std::abs(found.d_x - 1.0) < 1e-9);
    }
}

TEST_CASE("A formula without value or derivative at the start pose is named", "[core][formula_joint]") {
    const Part x = component(d, 0);
    for (const auto& [left, right, start] : std::vector<std::tuple<Part, double, double>>{
             {square_root(x), 0.3, -0.01},
             {square_root(x), 0.3, 0.0},  // a value, but no derivative
             {number(1.0) / x, 2.0, 0.0}}) {
        CAPTURE(left.text, start);
        const Closed found = closed_from(start, left, right);
        REQUIRE_FALSE(found.outcome.ok());
        CHECK(found.outcome.failure->cause == FailureCause::no_value);
        CHECK(found.outcome.failure->row == 0);
    }
    CHECK(closed_from(0.01, square_root(x), 0.3).outcome.ok());
}

}  // namespace jw::test::of_formula_joints
