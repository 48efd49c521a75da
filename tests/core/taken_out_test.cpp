#include <catch2/catch.hpp>

#include <limits>

#include "core/poses/position.hpp"
#include "tests/core/rows.hpp"
#include "tests/support/scenes.hpp"

/// Single equations taken out by hand (Joint::without).
using namespace jw;
using test::kPi;
using test::without_row;

namespace {

constexpr std::array kForms{ParallelForm::rule,   ParallelForm::drop_x,    ParallelForm::drop_y,
                            ParallelForm::drop_z, ParallelForm::all_three, ParallelForm::pair};

Mechanism without(Mechanism mechanism, int joint, EquationOut out) {
    mechanism.joints[static_cast<std::size_t>(joint)].without.push_back(out);
    return mechanism;
}

struct Numbers {
    VectorX phi;
    MatrixX jacobian;
    VectorX gamma;
};
template <class C>
Numbers numbers_of(const System& system) {
    Assembler<C> assembler(system);
    const State state = start_state(system.mechanism());
    assembler.assemble_phi_and_jacobian(state, 0.0);
    assembler.assemble_gamma(state, start_motion(system.mechanism()), 0.0);
    return {assembler.phi(), assembler.jacobian(), assembler.gamma()};
}

/// Row of an equation, -1 if it has none.
int row_of(const System& system, int joint, EquationOut equation) {
    for (int row = 0; row < system.rows(); ++row) {
        const RowOrigin origin = system.origin(row);
        if (origin.kind != RowOrigin::Kind::constraint) { continue; }
        const Constraint& c = system.constraints()[static_cast<std::size_t>(origin.index)];
        if (c.joint == joint && c.role == equation.role && origin.component == equation.component) {
            return row;
        }
    }
    return -1;
}

/// Rank of a matrix by its singular values, far from both 1e-9 and the rank's own code path.
int rank_by_values(const MatrixX& matrix) {
    const VectorX sigma = singular_values_of(matrix);
    return static_cast<int>((sigma.array() > 1e-6).count());
}

}  // namespace

TEMPLATE_TEST_CASE(
    "An equation taken out takes its own row away and leaves every other as it is", "[core][taken_out]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const JointType& type : kJointTypes) {
        for (const ParallelForm form : kForms) {
            test::Random random(11);
            const Mechanism whole = test::random_joint(random, type, form, ScrewAngleForm::rotation);
            const System system(whole, everything(whole));
            const Numbers all = numbers_of<TestType>(system);
            for (const Constraint& c : system.constraints()) {
                for (int component = 0; component < c.equations; ++component) {
                    CAPTURE(type.name, static_cast<int>(form), static_cast<int>(c.role), component);
                    const EquationOut out{c.role, component};
                    const Mechanism mechanism = without(whole, 0, out);
                    const System less(mechanism, everything(mechanism));
                    const int row = row_of(system, 0, out);
                    CHECK(row_of(less, 0, out) == -1);
                    CHECK(less.rows() == system.rows() - (row >= 0 ? 1 : 0));
                    if (row < 0) { continue; }
                    const Numbers rest = numbers_of<TestType>(less);
                    CHECK(rest.jacobian == without_row(all.jacobian, row));
                    CHECK(rest.phi == without_row(all.phi, row));
                    CHECK(rest.gamma == without_row(all.gamma, row));
                }
            }
        }
    }
}

TEST_CASE(
    "A needed equation leaves one freedom when it goes, a redundant one leaves none", "[core][taken_out]") {
    int needed = 0;
    int redundant = 0;
    for (const Mechanism& mechanism :
         {test::four_bar_at(0.7), test::bennett(1.1), test::rssr(0.7), test::cardan(0.5, 0.3)}) {
        const System system(mechanism, everything(mechanism));
        const RankReport whole = test::rank_of(mechanism);
        const MatrixX jacobian = test::jacobian_of<OmegaLocal>(mechanism);
        for (int row = 0; row < system.rows(); ++row) {
            const Constraint& c = system.constraints()[static_cast<std::size_t>(system.origin(row).index)];
            const RankReport less =
                test::rank_of(without(mechanism, c.joint, {c.role, system.origin(row).component}));
            CAPTURE(mechanism.joints.size(), row);
            CHECK(less.rows == whole.rows - 1);
            CHECK(less.rank == rank_by_values(without_row(jacobian, row)));
            CHECK(less.dof + less.rank == whole.columns);
            CHECK(less.mobility_by_counting == whole.mobility_by_counting + 1);
            (less.dof == whole.dof ? redundant : needed) += 1;
        }
    }
    // both kinds did occur
    CHECK(needed > 20);
    CHECK(redundant > 20);
}

TEST_CASE(
    "One of three p1 rows costs no freedom, one of the two that the rule keeps does", "[core][taken_out]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3(0.1, 0.2, 0.3));
    Joint& joint = scene.add_joint("revolute", 0, body, Vec3::Zero(), Vec3(1.0, 2.0, -3.0));
    for (int component = 0; component < 3; ++component) {
        CAPTURE(component);
        joint.without = {{Role::axes_parallel, component}};
        joint.parallel_form = ParallelForm::all_three;
        CHECK(test::rank_of(scene.mechanism).dof == 1);
        CHECK(test::rank_of(scene.mechanism).rows == 5);
        joint.parallel_form = ParallelForm::pair;
        CHECK(test::rank_of(scene.mechanism).dof == (component < 2 ? 2 : 1));  // a pair has no third
        joint.parallel_form = ParallelForm::rule;
        // z is the largest component of the axis: the rule drops it, taken out or not
        CHECK(test::rank_of(scene.mechanism).dof == (component == 2 ? 1 : 2));
        CHECK(test::rank_of(scene.mechanism).rows == (component == 2 ? 5 : 4));
    }
}

TEST_CASE("With an equation taken out the number of rows never changes", "[core][taken_out]") {
    for (int component = 0; component < 3; ++component) {
        test::SceneBuilder scene;
        const int body = scene.add_body("body", Vec3::Zero());
        scene.mechanism.bodies[0].p = Vec4::Unit(0);
        Joint& joint = scene.add_joint("revolute", 0, body, Vec3::Zero(), Vec3(0.1, 0.2, 1.0));
        joint.without = {{Role::axes_parallel, component}};
        System system(scene.mechanism, everything(scene.mechanism));
        const Constraint p1 = system.constraints()[1];
        CHECK(p1.dropped == 2);
        State state = start_state(scene.mechanism);
        state.p[0] = euler_parameters_of(Vec3::UnitY(), 0.5 * kPi);  // the axis near x now
        CHECK_FALSE(system.choose_rows(state));
        CHECK(system.constraints()[1].dropped == 2);

        // the row that the rule dropped before an equation was taken out is still left out afterwards
        Mechanism whole = scene.mechanism;
        whole.joints[0].without.clear();
        System before(whole, everything(whole));
        CHECK(before.choose_rows(state));
        CHECK(before.constraints()[1].dropped == 0);
        system.inherit_rows(before);
        CHECK(system.constraints()[1].dropped == 0);
        CHECK(system.rows() == (component == 0 ? 5 : 4));
        before.inherit_rows(system);
        CHECK(before.rows() == 5);
    }
}

TEST_CASE("Rows chosen by the rule are not pressed on other forms", "[core][taken_out]") {
    Mechanism mechanism = test::four_bar_at(0.7);
    const System by_rule(mechanism, everything(mechanism));
    Mechanism other = mechanism;
    for (const ParallelForm form : {ParallelForm::all_three, ParallelForm::drop_x, ParallelForm::pair}) {
        for (Joint& joint : other.joints) { joint.parallel_form = form; }
        System system(other, everything(other));
        const int rows = system.rows();
        system.inherit_rows(by_rule);
        CHECK(system.rows() == rows);
        System again(mechanism, everything(mechanism));
        again.inherit_rows(system);
        CHECK(again.rows() == by_rule.rows());
    }
}

TEST_CASE("A joint without any of its equations is as no joint", "[core][taken_out]") {
    Mechanism mechanism = test::four_bar_at(0.7);
    Selection others = everything(mechanism);
    others.joints.erase(others.joints.begin() + 2);
    const System expected(mechanism, others);
    const MatrixX jacobian = numbers_of<OmegaLocal>(expected).jacobian;
    for (int component = 0; component < 3; ++component) {
        mechanism.joints[2].without.push_back({Role::same_point, component});
        mechanism.joints[2].without.push_back({Role::axes_parallel, component});
    }
    const System system(mechanism, everything(mechanism));
    CHECK(system.rows() == expected.rows());
    CHECK(numbers_of<OmegaLocal>(system).jacobian == jacobian);
    CHECK_FALSE(find_wrong_branch(system, start_state(mechanism), intended_sides(system)).has_value());

    for (Joint& joint : mechanism.joints) { joint.without = mechanism.joints[2].without; }
    const RankReport none = test::rank_of(mechanism);
    CHECK(none.rows == 0);
    CHECK(none.dof == 18);
    State state = start_state(mechanism);
    CHECK(solve_position<TrueEulerParameters>(System(mechanism, everything(mechanism)), state, 0.0).ok());
}

TEMPLATE_TEST_CASE(
    "Newton closes what is left when an equation is taken out", "[core][taken_out]", TrueEulerParameters,
    ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const Mechanism& whole : {test::four_bar_at(0.7), test::bennett(1.1), test::cardan(0.5, 0.3)}) {
        const System all(whole, everything(whole));
        for (int row = 0; row < all.rows(); ++row) {
            const Constraint& c = all.constraints()[static_cast<std::size_t>(all.origin(row).index)];
            const Mechanism mechanism = without(whole, c.joint, {c.role, all.origin(row).component});
            const System system(mechanism, everything(mechanism));
            test::Random random(static_cast<unsigned>(row) + 1);
            State state = test::disturbed(mechanism, start_state(mechanism), random, 0.1, 0.1);
            CAPTURE(whole.joints.size(), row);
            REQUIRE(solve_position<TestType>(system, state, 0.0).ok());
            Assembler<OmegaLocal> assembler(system);
            assembler.assemble_phi_and_jacobian(state, 0.0);
            // ten times Newton's tolerance, since p is made unit after it
            CHECK(assembler.phi().cwiseAbs().maxCoeff() < 1e-12);
        }
    }
}

TEST_CASE("An axis that may part is on no wrong branch, one that is held still is", "[core][taken_out]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    scene.mechanism.bodies[0].p = Vec4::Unit(0);
    const Vec3 axis = Vec3(1.0, 2.0, 3.0).normalized();
    Joint& joint = scene.add_joint("fixed", 0, body, Vec3::Zero(), axis);
    State over = start_state(scene.mechanism);
    over.p[1] = turned_global(over.p[1], kPi * perpendicular_to(axis));
    State around = start_state(scene.mechanism);
    around.p[1] = turned_global(around.p[1], kPi * axis);
    const auto branch = [&](const State& state) {
        const System system(scene.mechanism, everything(scene.mechanism));
        return find_wrong_branch(system, state, intended_sides(system));
    };
    REQUIRE(branch(over).has_value());
    CHECK(branch(over)->kind == WrongBranch::Kind::anti_parallel);
    REQUIRE(branch(around).has_value());
    CHECK(branch(around)->kind == WrongBranch::Kind::half_turn);

    // one p1 row: the body can be turned from one pose into the other without leaving the equations
    joint.without = {{Role::axes_parallel, 0}};
    CHECK_FALSE(branch(over).has_value());
    CHECK_FALSE(branch(around).has_value());

    // two of three rows still constrain the axis
    joint.parallel_form = ParallelForm::all_three;
    REQUIRE(branch(over).has_value());
    CHECK(branch(over)->kind == WrongBranch::Kind::anti_parallel);
    CHECK(branch(around).has_value());

    // unless the axis lies in their plane: for s_i along x the rows x and y require only that s_j has no z,
    // and hold although the axes are 120 deg apart
    joint.geometry.s_i_local = Vec3::UnitX();
    joint.geometry.s_j_local = Vec3(-0.5, std::sqrt(0.75), 0.0);
    joint.without = {{Role::axes_parallel, 2}};
    State apart = start_state(scene.mechanism);
    apart.p[1] = Vec4::Unit(0);
    CHECK_FALSE(branch(apart).has_value());

    // without its n1 a weld may turn about the axis
    joint.geometry.s_i_local = scene.local(0, axis);
    joint.geometry.s_j_local = scene.local(1, axis);
    joint.without = {{Role::sides_perpendicular, 0}};
    CHECK_FALSE(branch(around).has_value());
}

TEST_CASE("The reason for a choice is told of the rows that are left", "[core][taken_out]") {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    Joint& joint = scene.add_joint("p1", 0, body, Vec3::Zero(), Vec3(2.0, 1.0, 3.0));
    const auto choice = [&](ParallelForm form, std::vector<EquationOut> out) {
        joint.parallel_form = form;
        joint.without = std::move(out);
        const System system(scene.mechanism, everything(scene.mechanism));
        return explain_choice(system, 0, start_state(scene.mechanism), -1);
    };
    const EquationOut x{Role::axes_parallel, 0};
    const EquationOut y{Role::axes_parallel, 1};
    const RowChoice whole = choice(ParallelForm::rule, {});
    CHECK(whole.taken_out == 0U);
    CHECK(whole.form_condition == whole.pair_condition[2]);
    const RowChoice one = choice(ParallelForm::rule, {x});
    CHECK(one.taken_out == 1U);
    CHECK(one.pair_condition == whole.pair_condition);
    // the condition of a single row is 1
    CHECK(one.form_condition == Approx(1.0).epsilon(1e-15));
    CHECK(choice(ParallelForm::rule, {x, y}).form_condition == kInfinite);
    CHECK(choice(ParallelForm::all_three, {x}).form_condition == whole.pair_condition[0]);
    CHECK(choice(ParallelForm::pair, {x}).form_condition == Approx(1.0).epsilon(1e-15));
}
