#include <random>

#include <catch2/catch.hpp>

#include "lessons/formula/block_formulas.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/moved_along.hpp"
#include "tests/support/vector_formulas.hpp"

namespace jw::formula::test {

namespace {

namespace authored = jw::test::authored;

/// One joint of every type between two moving bodies, with arbitrary vectors.
Mechanism of_type(const JointType& type, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> any;
    const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
    Mechanism mechanism;
    mechanism.bodies.resize(3);
    mechanism.bodies[0].fixed = true;
    Joint joint;
    joint.name = "x";
    joint.type = &type;
    joint.body_i = 1;
    joint.body_j = 2;
    JointGeometry& g = joint.geometry;
    g.P_i_local = vector();
    g.P_j_local = vector();
    g.s_i_local = vector();
    g.s_j_local = vector();
    g.h_i_local = vector();
    g.h_j_local = vector();
    g.length = 1.3;
    using enum FormulaVector;
    g.formula = authored::equation(
        sine(authored::number(0.25) * authored::dot(s_i, s_j)) * authored::dot(u_j, d) -
            authored::component(r_i_P, 1),
        0.5);
    if (type.artificial > 0) {
        // the rows of a screw are written for unit vectors
        g.s_i_local.normalize();
        g.u_i_local = perpendicular_to(g.s_i_local);
        g.u_j_local = perpendicular_to(g.s_j_local);
        g.alpha = 0.2;
    }
    mechanism.joints.push_back(joint);
    return mechanism;
}

/// Largest term and difference of an equation about the joint.
Outcome outcome_of(const char* equation, const Instant& instant, std::vector<std::string> where = {}) {
    Subject subject;
    subject.joint = 0;
    return evaluate_at({equation, std::move(where), subject}, instant);
}

double part_of(const Outcome& outcome) {
    return outcome.apart.difference / std::max(outcome.apart.scale, 1e-300);
}

/// Value of a symbol after the bodies have moved on for a time.
MatrixX value_after(const char* expression, const Instant& start, double t) {
    Instant later = start;
    later.state = jw::test::moved_along(start.state, start.velocity, *start.acceleration, t);
    Subject subject;
    subject.joint = 0;
    return evaluate_expression(math::own_math(expression), meanings_of(subject, later)).d[0];
}

const char* const kMoving[] = {
    "s_i",
    "s_j",
    "d",
    "r_i^P",
    "A_i",
    "G_j",
    "L_i",
    "e_j",
    "\\Phi",
    "\\tilde{s}_i s_j",
    "s_i^T d / |d|",
    "\\bar{s}_i p_j",
    "|s_i \\times d|^2",
    "(2 G_i L_i^T + I)^{-1}",
    "\\frac{1}{2 + \\sin(s_i^T s_j)}"};

struct Misfit {
    const char* equation;
    std::size_t at;
    const char* message;
};
const Misfit kMisfits[] = {
    {"s_i + p_i = 0", 0, "3 x 1 and 4 x 1 are added"},
    {"x = s_i A_j", 0, "'x' has no meaning"},
    {"0 = s_i A_j", 8, "3 x 1 is multiplied by 3 x 3"},
    {"s_i", 0, "no '='"},
    {"s_i = ", 0, "nothing here"},
    {"(s_i = 0", 0, "this is not closed"},
    {"s_k = 0", 0, "'s_k' has no meaning"},
    {"\\tilde{A}_i = 0", 0, "a tilde is taken of 3 x 3"},
    {"\\ddot{\\omega}_i = 0", 0, "a derivative is not known"},
    {"\\det(s_i) = 0", 0, "the determinant of 3 x 1"},
    {"s_i / d = 0", 4, "divided by 3 x 1"},
    {"\\text{foo} = 0", 0, "is not a quantity"},
    {"s_i^x = 0", 0, "'s_i^x' has no meaning"},
};

}  // namespace

TEST_CASE("a dot in a formula is the derivative along the motion, for every joint", "[lessons][formula]") {
    for (const JointType& type : kJointTypes) {
        const Mechanism mechanism = of_type(type, 3);
        const Instant instant =
            arbitrary_instant(std::make_shared<const System>(mechanism, everything(mechanism)), 5);
        for (const char* const expression : kMoving) {
            CAPTURE(type.name, expression);
            Subject subject;
            subject.joint = 0;
            const Value value =
                evaluate_expression(math::own_math(expression), meanings_of(subject, instant));
            const auto f = [&](double t) { return value_after(expression, instant, t); };
            const MatrixX rate = jw::test::rate_by_difference(f);
            const MatrixX acceleration = jw::test::acceleration_by_difference(f);
            // of the size of the terms; differences of sizes up to 30 lose so many digits
            CHECK((value.d[1] - rate).cwiseAbs().maxCoeff() < 1e-6 * std::max(1.0, value.scale[1]));
            CHECK((value.d[2] - acceleration).cwiseAbs().maxCoeff() < 1e-4 * std::max(1.0, value.scale[2]));
        }
    }
}

TEST_CASE("velocity and acceleration equations hold in any state, for every joint", "[lessons][formula]") {
    for (const JointType& type : kJointTypes) {
        // a screw has a third kind of column
        if (type.artificial > 0) { continue; }
        const Mechanism mechanism = of_type(type, 8);
        const auto system = std::make_shared<const System>(mechanism, everything(mechanism));
        for (unsigned seed = 0; seed < 20; ++seed) {
            const Instant instant = arbitrary_instant(system, seed);
            CAPTURE(type.name, seed);
            for (
                const char* const equation :
                {R"(\dot{\Phi} = \Phi_q \dot{q} = \Phi_q^{(m)} \dot{q})",
                 R"(\dot{\Phi} = \Phi_{r_i} \dot{r}_i + \Phi_{\omega'_i} \omega'_i + \Phi_{r_j} \dot{r}_j + \Phi_{\omega'_j} \omega'_j)",
                 R"(\dot{\Phi} = \Phi_{r_i} \dot{r}_i + \Phi_{\omega_i} \omega_i + \Phi_{r_j} \dot{r}_j + \Phi_{\omega_j} \omega_j)",
                 R"(\ddot{\Phi} = \Phi_q \ddot{q} - \gamma = \Phi_q^{(m)} \ddot{q} - \gamma^{(m)})",
                 R"(\ddot{\Phi} = \Phi_{r_i} \ddot{r}_i + \Phi_{\omega'_i} \dot{\omega}'_i + \Phi_{r_j} \ddot{r}_j + \Phi_{\omega'_j} \dot{\omega}'_j - \gamma^{\#})",
                 R"(\Phi_{\omega'_i} = \frac{1}{2} \Phi_{p_i} L_i^T = \frac{1}{2} \Phi_{p_i}^{(m)} L_i^T = \Phi_{\omega_i} A_i)"}) {
                const Outcome outcome = outcome_of(equation, instant);
                CAPTURE(equation);
                REQUIRE_FALSE(outcome.problem);
                CHECK(part_of(outcome) < 1e-12);
            }
        }
    }
}

TEST_CASE(
    "the formula of every block of the Jacobian is that block, in all coordinates", "[lessons][formula]") {
    int blocks = 0;
    for (const JointType& type : kJointTypes) {
        const Mechanism mechanism = of_type(type, 11);
        const Instant instant =
            arbitrary_instant(std::make_shared<const System>(mechanism, everything(mechanism)), 2);
        for (const Role role : type.roles) {
            for (const CoordinateChoice choice :
                 {CoordinateChoice::true_euler_parameters, CoordinateChoice::modified_euler_parameters,
                  CoordinateChoice::omega_local, CoordinateChoice::omega_global}) {
                for (const int k : {0, 1, 2, 3}) {
                    const Block block{role, choice, k < 2, k % 2 == 0};
                    const auto formula = block_formula(block);
                    if (!formula) { continue; }
                    Subject subject;
                    subject.joint = 0;
                    subject.role = role;
                    const std::string equation = block_name(block) + " = " + *formula;
                    const Outcome outcome = evaluate_at({equation, {}, subject}, instant);
                    CAPTURE(type.name, equation);
                    REQUIRE_FALSE(outcome.problem);
                    CHECK(part_of(outcome) < 1e-12);
                    ++blocks;
                }
            }
        }
    }
    CHECK(blocks > 400);
}

TEST_CASE("a wrong sign, dot, index or factor makes a formula fail", "[lessons][formula]") {
    const Mechanism mechanism = of_type(*find_joint_type("n1"), 4);
    const Instant instant =
        arbitrary_instant(std::make_shared<const System>(mechanism, everything(mechanism)), 1);
    const char* const right =
        R"(\gamma^{\#} = -2 \dot{s}_i^T \dot{s}_j + \dot{s}_i^T \tilde{\omega}_i s_j + \dot{s}_j^T \tilde{\omega}_j s_i)";
    CHECK(part_of(outcome_of(right, instant)) < 1e-12);
    for (
        const char* const wrong :
        {R"(\gamma^{\#} = 2 \dot{s}_i^T \dot{s}_j + \dot{s}_i^T \tilde{\omega}_i s_j + \dot{s}_j^T \tilde{\omega}_j s_i)",
         R"(\gamma^{\#} = -2 \dot{s}_j^T \dot{s}_j + \dot{s}_i^T \tilde{\omega}_i s_j + \dot{s}_j^T \tilde{\omega}_j s_i)",
         R"(\gamma^{\#} = -2 s_i^T \dot{s}_j + \dot{s}_i^T \tilde{\omega}_i s_j + \dot{s}_j^T \tilde{\omega}_j s_i)",
         R"(\gamma^{\#} = - \dot{s}_i^T \dot{s}_j + \dot{s}_i^T \tilde{\omega}_i s_j + \dot{s}_j^T \tilde{\omega}_j s_i)",
         R"(\gamma^{(m)} = -2 \dot{s}_i^T \dot{s}_j + \dot{s}_i^T \tilde{\omega}_i s_j + \dot{s}_j^T \tilde{\omega}_j s_i)"}) {
        CAPTURE(wrong);
        CHECK(part_of(outcome_of(wrong, instant)) > 1e-3);
    }
    const std::vector<std::string> where{
        R"(h_i = -2 \dot{G}_i \dot{L}_i^T s'_i)", R"(h_j = -2 \dot{G}_j \dot{L}_j^T s'_j)"};
    const char* const defined = R"(\gamma^{(m)} = s_i^T h_j + s_j^T h_i - 2 \dot{s}_i^T \dot{s}_j)";
    CHECK(part_of(outcome_of(defined, instant, where)) < 1e-12);
}

TEST_CASE("a formula that cannot be evaluated says where and why", "[lessons][formula]") {
    const Mechanism mechanism = of_type(*find_joint_type("cylindrical"), 4);
    const Instant instant =
        arbitrary_instant(std::make_shared<const System>(mechanism, everything(mechanism)), 1);
    for (const Misfit& misfit : kMisfits) {
        CAPTURE(misfit.equation);
        const Outcome outcome = outcome_of(misfit.equation, instant);
        REQUIRE(outcome.problem);
        CHECK(outcome.problem->at == misfit.at);
        CHECK_THAT(outcome.problem->message, Catch::Contains(misfit.message));
    }
    CHECK(outcome_of("s_i = 0", instant, {"h_k = s_i + 1"}).definition == 0);
}

TEST_CASE("The exponent of a quantity counts", "[formula]") {
    const Meanings meanings{
        [](const Symbol&) -> std::optional<Value> { return std::nullopt; },
        [](const std::string&) -> std::optional<Value> { return number(3.0); }};
    CHECK(evaluate_expression(math::own_math("\\text{b.x}^2"), meanings).d[0](0, 0) == 9.0);
    CHECK(evaluate_expression(math::own_math("2 \\text{b.x}^2 + 1"), meanings).d[0](0, 0) == 19.0);
}

TEST_CASE("components, lengths and quantities have their values", "[lessons][formula]") {
    const Mechanism mechanism = of_type(*find_joint_type("revolute"), 4);
    const Instant instant =
        arbitrary_instant(std::make_shared<const System>(mechanism, everything(mechanism)), 1);
    for (
        const char* const equation :
        {R"(s_i = \begin{bmatrix} s_{xi} \\ s_{(y)i} \\ s_{zi} \end{bmatrix})",
         R"(|s_i|^2 = s_i^T s_i = s_i \cdot s_i)", R"(p_i = \begin{bmatrix} e_{0i} \\ e_i \end{bmatrix})",
         R"(\begin{bmatrix} I & 0 \\ 0 & A_i \end{bmatrix} \begin{bmatrix} s_j \\ s'_i \end{bmatrix} = \begin{bmatrix} s_j \\ s_i \end{bmatrix})",
         R"(\Phi^{(p1,2)} = \tilde{s}_i s_j = s_i \times s_j)", R"(\operatorname{rank}(\tilde{s}_i) = 2)",
         R"(\det A_i = 1)", R"(\cos^2 \theta + \sin^2 \theta = 1)",
         R"(\tilde{\dot{s}}_i = \dot{\tilde{s}}_i)", R"(0 = A_i^T A_i - I)"}) {
        CAPTURE(equation);
        const Outcome outcome = outcome_of(equation, instant);
        REQUIRE_FALSE(outcome.problem);
        CHECK(part_of(outcome) < 1e-12);
    }
}

}  // namespace jw::formula::test
