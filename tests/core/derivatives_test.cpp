#include <catch2/catch.hpp>

#include "core/equations/assembler.hpp"
#include "core/jets/body_kinematics.hpp"
#include "tests/support/moved_positions.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;
using reference::Real;
using reference::VX;

namespace {

// Central differences of order 4 in long double: truncation h⁴ and rounding 1e-19/h (1e-19/h²) leave about
// 1e-14 for first and 1e-11 for second derivatives of functions of size 1 to 10.
constexpr Real kFirstStep = 1e-4L;
constexpr Real kSecondStep = 5e-4L;
constexpr double kDifferenceTolerance = 1e-9;

/// Rates of the rows of joints and drivers. Checks that the terms of a constraint alone equal its rows.
template <class C>
VectorX rates_of(const Assembler<C>& assembler, const State& state, const Motion& motion) {
    const System& system = assembler.system();
    VectorX rates(system.rows());
    for (const Constraint& c : system.constraints()) {
        const ConstraintTerms terms = terms_of<C>(c, state, motion);
        int row = c.first_row;
        for (int k = 0; k < c.equations; ++k) {
            if (!c.has_row(k)) { continue; }
            VectorX entries = VectorX::Zero(assembler.layout().columns());
            const auto add = [&](int body, const MatrixX& block) {
                const int column = system.body_column(body, C::kAngular);
                if (column >= 0) { entries.segment(column, block.cols()) += block.row(k).transpose(); }
            };
            add(c.body_i, terms.block_i);
            add(c.body_j, terms.block_j);
            if (c.theta >= 0) { entries(system.theta_column(c.theta, C::kAngular)) = terms.block_theta(k); }
            CHECK(terms.value(k) == assembler.phi()(row));
            CHECK(-terms.bias(k) == assembler.gamma()(row));
            CHECK(entries == assembler.jacobian().row(row).transpose());
            rates(row++) = terms.rate(k);
        }
    }
    for (const DriverConstraint& c : system.drivers()) {
        const Driver& d = system.mechanism().drivers[static_cast<std::size_t>(c.driver)];
        const auto body = [&](int index) {
            const auto b = static_cast<std::size_t>(index);
            return kinematics_at<C>(state.r[b], state.p[b], motion.r_dot[b], motion.omega_local[b]);
        };
        const auto k = static_cast<std::size_t>(c.theta);
        const Theta theta = c.theta < 0 ? Theta{} : Theta{state.theta[k], motion.theta_dot[k]};
        const auto write = [&](const auto& measure) {
            rates(c.row) = measured<Content::motion>(measure, body(d.body_i), body(d.body_j), theta).rate(0);
        };
        std::visit(write, d.measure);
    }
    return rates;
}

template <class C>
void check_against_differences(
    const Mechanism& mechanism, const State& state, const Motion& motion, unsigned seed) {
    const System system(mechanism, everything(mechanism));
    Assembler<C> assembler(system);
    const double t0 = 0.3;
    assembler.assemble_phi_and_jacobian(state, t0);
    assembler.assemble_nu(t0);
    assembler.assemble_gamma(state, motion, t0);
    const VectorX v = assembler.layout().columns_of(state, motion);
    const Eigen::Index columns = v.size();
    test::Random random(seed + 1000);
    VectorX a(columns);
    for (double& entry : a) { entry = random.number(); }
    const VectorX none = VectorX::Zero(columns);

    constexpr bool homogeneous = C::kChoice != CoordinateChoice::true_euler_parameters;
    const auto phi = [&](const VectorX& velocity, const VectorX& acceleration, Real t, Real time) {
        return reference::phi(
            system, test::moved<C>(system, state, velocity, acceleration, t), time, homogeneous,
            C::kNormalised);
    };
    const auto difference = [](const auto& f) { return test::first_difference_of(f, kFirstStep); };
    const auto close = [](const VectorX& ours, const VX& theirs) {
        const VectorX reference = theirs.cast<double>();
        return (ours - reference).cwiseAbs().maxCoeff() <=
               kDifferenceTolerance * std::max(1.0, reference.cwiseAbs().maxCoeff());
    };

    CHECK(close(assembler.phi(), phi(none, none, 0, t0)));
    for (Eigen::Index k = 0; k < columns; ++k) {
        CAPTURE(k);
        const VectorX unit = VectorX::Unit(columns, k);
        CHECK(close(assembler.jacobian().col(k), difference([&](Real t) { return phi(unit, none, t, t0); })));
    }
    CHECK(close(assembler.nu(), -difference([&](Real t) { return phi(none, none, 0, Real(t0) + t); })));

    const auto along = [&](Real t) { return phi(v, a, t, Real(t0) + t); };
    const Real h = kSecondStep;
    const VX second =
        (16 * (along(h) + along(-h)) - (along(2 * h) + along(-2 * h)) - 30 * along(0)) / (12 * h * h);
    CHECK(close(assembler.jacobian() * a - assembler.gamma(), second));
    const VectorX rates = rates_of<C>(assembler, state, motion);
    CHECK(close(rates, (assembler.jacobian().topRows(rates.size()) * v).template cast<Real>()));
}

State random_theta(State state, test::Random& random) {
    for (double& theta : state.theta) { theta = random.number(-3.0, 3.0); }
    return state;
}

Motion random_theta_rate(Motion motion, test::Random& random) {
    for (double& rate : motion.theta_dot) { rate = random.number(); }
    return motion;
}

}  // namespace

TEMPLATE_TEST_CASE(
    "Phi, Jacobian and gamma of every joint type equal differences of Phi in every coordinate choice",
    "[core][derivatives]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    const auto form = GENERATE(
        ParallelForm::rule, ParallelForm::drop_x, ParallelForm::drop_y, ParallelForm::drop_z,
        ParallelForm::all_three, ParallelForm::pair);
    for (const JointType& type : kJointTypes) {
        for (unsigned seed = 1; seed <= 3; ++seed) {
            test::Random random(seed);
            const auto screw =
                std::array{ScrewAngleForm::rotation, ScrewAngleForm::cosine, ScrewAngleForm::sine}[seed % 3];
            const Mechanism mechanism = test::random_joint(random, type, form, screw);
            CAPTURE(type.name, seed, static_cast<int>(form));
            const State state = random_theta(start_state(mechanism), random);
            const Motion motion = random_theta_rate(start_motion(mechanism), random);
            check_against_differences<TestType>(mechanism, state, motion, seed);
        }
    }
}

TEMPLATE_TEST_CASE(
    "Derivatives hold for what is left when single equations are taken out", "[core][derivatives]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    const auto form = GENERATE(ParallelForm::rule, ParallelForm::all_three, ParallelForm::pair);
    for (const JointType& type : kJointTypes) {
        if (type.independent_rows() < 2) { continue; }
        test::Random random(5);
        Mechanism mechanism = test::random_joint(random, type, form, ScrewAngleForm::rotation);
        mechanism.joints[0].without = {{type.roles.front(), 0}};
        if (type.roles.size() > 1) { mechanism.joints[0].without.push_back({type.roles[1], 1}); }
        CAPTURE(type.name, static_cast<int>(form));
        check_against_differences<TestType>(mechanism, start_state(mechanism), start_motion(mechanism), 5);
    }
}

TEMPLATE_TEST_CASE(
    "Both Euler parameter choices are exact for p of any length", "[core][derivatives]", TrueEulerParameters,
    ModifiedEulerParameters) {
    for (const JointType& type : kJointTypes) {
        test::Random random(7);
        Mechanism mechanism = test::random_joint(random, type, ParallelForm::rule, ScrewAngleForm::rotation);
        mechanism.bodies[0].p *= 1.3;
        mechanism.bodies[1].p *= 0.8;
        CAPTURE(type.name);
        check_against_differences<TestType>(mechanism, start_state(mechanism), start_motion(mechanism), 7);
    }
}

TEMPLATE_TEST_CASE(
    "Every driver equals differences of Phi in every coordinate choice", "[core][derivatives]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        const Mechanism mechanism = test::random_drivers(random);
        CAPTURE(seed);
        const State state = random_theta(start_state(mechanism), random);
        const Motion motion = random_theta_rate(start_motion(mechanism), random);
        check_against_differences<TestType>(mechanism, state, motion, seed);
    }
}

TEST_CASE("Derivatives hold at and next to the hard spots", "[core][derivatives]") {
    // aligned, anti-parallel and perpendicular axes, coincident points, θ = 0 and π
    const double offset = GENERATE(0.0, 1e-9, 1e-3);
    const auto angle = GENERATE(0.0, 0.5, 1.0);  // half turns of body j
    for (const JointType& type : kJointTypes) {
        test::Random random(3);
        Mechanism mechanism = test::random_joint(random, type, ParallelForm::rule, ScrewAngleForm::rotation);
        JointGeometry& g = mechanism.joints[0].geometry;
        g.s_i_local = g.s_j_local = Vec3::UnitZ();
        g.u_i_local = g.u_j_local = Vec3::UnitX();
        g.P_i_local = g.P_j_local = Vec3::Zero();
        // a line of wheels with no length would turn at any rate
        if (type.has_own_coordinate()) { g.theta_dot_start = 0.7; }
        mechanism.bodies[0].p = Vec4::Unit(0);
        mechanism.bodies[1].p = euler_parameters_of(Vec3::UnitX(), angle * std::numbers::pi + offset);
        mechanism.bodies[1].r = mechanism.bodies[0].r + Vec3::Constant(offset);
        CAPTURE(type.name, offset, angle);
        const State state = start_state(mechanism);
        check_against_differences<OmegaLocal>(mechanism, state, start_motion(mechanism), 3);
        check_against_differences<ModifiedEulerParameters>(mechanism, state, start_motion(mechanism), 3);
    }
}

TEMPLATE_TEST_CASE(
    "Columns hold a motion, and a step along them changes Phi as the Jacobian says", "[core][derivatives]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    test::Random random(4);
    const Mechanism mechanism = test::random_drivers(random);
    const System system(mechanism, everything(mechanism));
    const State state = start_state(mechanism);
    const Motion motion = random_theta_rate(start_motion(mechanism), random);
    Assembler<TestType> assembler(system);
    const VectorX columns = assembler.layout().columns_of(state, motion);

    const Motion back = assembler.layout().motion_of(state, columns);
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        CHECK((back.r_dot[b] - motion.r_dot[b]).norm() == 0.0);
        CHECK((back.omega_local[b] - motion.omega_local[b]).norm() < 1e-14);  // rounding
    }
    CHECK(back.theta_dot == motion.theta_dot);

    // h² and 1e-15 / h are below 1e-9, and third derivatives below 100
    const double h = 1e-5;
    const auto stepped = [&](double step) {
        State moved = state;
        assembler.layout().advance(moved, step * columns);
        return moved;
    };
    const auto phi = [&](double step) {
        assembler.assemble_phi_and_jacobian(stepped(step), 0.3);
        return VectorX(assembler.phi());
    };
    const VectorX slope = (phi(h) - phi(-h)) / (2.0 * h);
    assembler.assemble_phi_and_jacobian(state, 0.3);
    CHECK((assembler.jacobian() * columns - slope).cwiseAbs().maxCoeff() < 1e-7);

    // bodies turn by |ω'| h, the fastest the furthest
    const double fastest = std::max(motion.omega_local[0].norm(), motion.omega_local[1].norm());
    CHECK(std::abs(assembler.layout().largest_turn(h * columns) - fastest * h) < 1e-15);
}
