#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/integrate/explicit_integrator.hpp"
#include "core/integrate/radau.hpp"
#include "core/integrate/simulation.hpp"
#include "tests/support/dynamics_scenes.hpp"

namespace jw {
namespace {

struct End {
    double error = 0.0;
    SimulationOutcome outcome;
};

/// Distance of the lesson's point from its trusted end.
End end_of(const Lesson& lesson, const SimulationSettings& settings) {
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    const BodyPoint& point = *lesson.dynamics->point;
    End end;
    end.outcome = simulation.run({0.0, lesson.dynamics->duration}, [&](double, const std::vector<double>& y) {
        end.error = (simulation.point(y, point.body, point.point_local) -
                     lesson.dynamics->point_at_end.value_or(Vec3::Zero()))
                        .norm();
    });
    return end;
}

SimulationSettings settings_with(Method method, double tolerance) {
    SimulationSettings settings;
    settings.method = method;
    settings.tolerance = settings.step = tolerance;
    return settings;
}

}  // namespace

TEST_CASE(
    "Radau's tables are those of the literature and integrate polynomials exactly", "[dynamics][radau]") {
    const RadauTable table = radau_table(3);
    const double root = std::sqrt(6.0);
    // Hairer, Wanner: Solving Ordinary Differential Equations II, table IV.5.6
    CHECK(std::abs(table.c(0) - (4.0 - root) / 10.0) < 1e-15);
    CHECK(std::abs(table.c(1) - (4.0 + root) / 10.0) < 1e-15);
    CHECK(std::abs(table.a(0, 1) - (296.0 - 169.0 * root) / 1800.0) < 1e-14);
    CHECK(std::abs(table.a(2, 2) - 1.0 / 9.0) < 1e-14);
    for (const int stages : {3, 5}) {
        const RadauTable t = radau_table(stages);
        for (int k = 1; k <= 2 * stages - 1; ++k) {
            const VectorX powers = t.c.array().pow(k - 1);
            // quadrature of order 2 s - 1; the tables are solved from powers, a few digits above rounding
            CHECK(std::abs(t.a.row(stages - 1).dot(powers) - 1.0 / k) < 1e-12);
            if (k > stages) { continue; }
            // collocation: from 0 to each node
            const VectorX integrals = t.c.array().pow(k) / k;
            CHECK((t.a * powers - integrals).cwiseAbs().maxCoeff() < 1e-12);
            // the quadrature behind the local error: weight gamma_0 at 0
            const VectorX b_hat = t.a.transpose() * t.e + t.a.row(stages - 1).transpose();
            CHECK(std::abs((k == 1 ? t.gamma_0 : 0.0) + b_hat.dot(powers) - 1.0 / k) < 1e-12);
        }
        const MatrixX shifted = t.a - t.gamma_0 * MatrixX::Identity(stages, stages);
        CHECK(std::abs(shifted.determinant()) < 1e-15);
    }
}

TEST_CASE("The stiff governor ends where the reference says, in few evaluations", "[dynamics][radau]") {
    const Lesson governor = test::flyball_governor();
    for (const Method method : {Method::implicit_5, Method::implicit_9}) {
        const End end = end_of(governor, settings_with(method, 1e-6));
        REQUIRE_FALSE(end.outcome.failure);
        CHECK(end.error < 1e-6);
        // stability limits the steps of explicit methods: they need a hundred thousand evaluations
        CHECK(end.outcome.counts.evaluations < 10000);
    }
}

TEST_CASE("Implicit methods agree with explicit ones on a scene that is not stiff", "[dynamics][radau]") {
    const End end = end_of(test::andrews_mechanism(), settings_with(Method::implicit_9, 1e-9));
    // 12 digits of the reference are trusted
    CHECK(end.error < 1e-11);
    // sixteen singular positions on the way
    CHECK(end_of(test::n_four_bar(1), settings_with(Method::implicit_9, 1e-8)).error < 1e-6);
}

TEST_CASE("Rows of four-bars pass their singular positions on their branch", "[dynamics]") {
    for (const int n : {1, 4, 16}) {
        for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
            CAPTURE(n, formulation == Formulation::joints);
            // joint coordinates take fewer steps for a tolerance, and less exact ones
            const double tolerance = formulation == Formulation::joints ? 1e-11 : 1e-10;
            SimulationSettings settings = settings_with(Method::explicit_8, tolerance);
            settings.formulation = formulation;
            const End end = end_of(test::n_four_bar(n), settings);
            REQUIRE_FALSE(end.outcome.failure);
            CHECK(end.outcome.counts.singular_passages > 0);
            // 16 passages, each free to lose a digit; the wrong branch would be metres away
            CHECK(end.error < 5e-8);
            CHECK(end.outcome.counts.steps < 400);
        }
    }
}

TEST_CASE("A million joules or none: fixed steps have the order that they promise", "[dynamics]") {
    const Lesson pendulum = test::simple_pendulum();
    const auto order_of = [&](Method method, double step) {
        const double coarse = end_of(pendulum, settings_with(method, step)).error;
        const double fine = end_of(pendulum, settings_with(method, step / 2.0)).error;
        return std::log2(coarse / fine);
    };
    struct Promise {
        Method method;
        double order;
        double step;  ///< short enough for the order to show, long enough to stay above rounding
    };
    constexpr std::array promises{
        Promise{Method::rk4, 4.0, 2e-3}, Promise{Method::semi_implicit, 1.0, 5e-4},
        Promise{Method::euler, 1.0, 1e-4}};
    for (const MethodName& entry : kMethods) {
        if (entry.adaptive) { continue; }
        CAPTURE(entry.name);
        const auto* const promise = std::ranges::find(promises, entry.method, &Promise::method);
        REQUIRE(promise != promises.end());
        // the measured order nears the true one from either side
        CHECK(order_of(entry.method, promise->step) == Approx(promise->order).margin(0.2));
    }
}

TEST_CASE("Times between steps are as exact as the steps", "[dynamics]") {
    const Lesson bricard = test::falling_bricard();
    const auto path = [&](double tolerance) {
        Simulation simulation(
            bricard.mechanism, bricard.dynamics->loads, settings_with(Method::explicit_8, tolerance));
        std::vector<double> times;
        for (int k = 0; k <= 101; ++k) { times.push_back(bricard.dynamics->duration * k / 101.0); }
        std::vector<Vec3> points;
        const SimulationOutcome outcome = simulation.run(times, [&](double, const std::vector<double>& y) {
            points.push_back(simulation.point(y, 3, Vec3::Zero()));
        });
        CHECK_FALSE(outcome.failure);
        return points;
    };
    const std::vector<Vec3> exact = path(1e-12);
    const std::vector<Vec3> loose = path(1e-8);
    REQUIRE(exact.size() == 102);
    REQUIRE(loose.size() == 102);
    double worst = 0.0;
    for (std::size_t k = 0; k < exact.size(); ++k) { worst = std::max(worst, (exact[k] - loose[k]).norm()); }
    // the end of this run is within 4e-9: what lies between may lose one digit more
    CHECK(worst < 4e-8);
}

TEST_CASE(
    "The slides' dense equations give the motion of the block-sparse ones in every choice", "[dynamics]") {
    for (const CoordinateChoice choice :
         {CoordinateChoice::true_euler_parameters, CoordinateChoice::modified_euler_parameters,
          CoordinateChoice::omega_local, CoordinateChoice::omega_global}) {
        SimulationSettings settings = settings_with(Method::explicit_8, 1e-9);
        settings.dense = choice;
        CHECK(end_of(test::chain(test::ChainJoint::spherical, 4), settings).error < 1e-7);
    }
}

TEST_CASE(
    "Joints and bodies as coordinates lead to the same end, through loops and redundant rows", "[dynamics]") {
    for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
        SimulationSettings settings = settings_with(Method::explicit_8, 1e-10);
        settings.formulation = formulation;
        CAPTURE(formulation == Formulation::joints);
        // a hundred times the tolerance, for what grows on the way; 12 digits of the references are trusted
        CHECK(end_of(test::andrews_mechanism(), settings).error < 1e-8);
        CHECK(end_of(test::falling_bricard(), settings).error < 1e-8);
        CHECK(end_of(test::chain(test::ChainJoint::revolute, 4), settings).error < 1e-8);
        CHECK(end_of(test::chain(test::ChainJoint::spherical, 4), settings).error < 1e-8);
    }
}

TEST_CASE(
    "Implicit methods take joint coordinates where no loop is left, and end where others do",
    "[dynamics][radau]") {
    for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
        SimulationSettings settings = settings_with(Method::implicit_9, 1e-8);
        settings.formulation = formulation;
        CAPTURE(formulation == Formulation::joints);
        CHECK(end_of(test::flyball_governor(), settings).error < 1e-8);
        CHECK(end_of(test::chain(test::ChainJoint::spherical, 4), settings).error < 1e-6);
    }
    SimulationSettings settings = settings_with(Method::implicit_9, 1e-8);
    settings.formulation = Formulation::joints;
    const Lesson loop = test::andrews_mechanism();
    CHECK_THROWS_AS(Simulation(loop.mechanism, loop.dynamics->loads, settings), std::invalid_argument);
}

TEST_CASE("Tolerances and steps that are not positive are refused in all coordinates", "[dynamics]") {
    const Lesson chain = test::chain(test::ChainJoint::revolute, 4);
    for (const Formulation formulation : {Formulation::automatic, Formulation::joints, Formulation::bodies}) {
        for (const double wrong : {0.0, -1.0, std::nan("")}) {
            for (const Method method : {Method::rk4, Method::explicit_8}) {
                SimulationSettings settings = settings_with(method, wrong);
                settings.formulation = formulation;
                CHECK_THROWS_AS(
                    Simulation(chain.mechanism, chain.dynamics->loads, settings), std::invalid_argument);
            }
        }
    }
}

TEST_CASE("A body that only turns, or only flies, is no division by zero", "[dynamics]") {
    Lesson body = test::free_asymmetric_body();
    const auto steps = [&] {
        const End end = end_of(body, settings_with(Method::explicit_8, 1e-8));
        CHECK_FALSE(end.outcome.failure);
        return end.outcome.counts.steps;
    };
    CHECK(steps() > 10);
    body.mechanism.bodies[1].omega_local.setZero();
    body.mechanism.bodies[1].r_dot = Vec3(1.0, 0.0, 0.0);
    CHECK(steps() < 100);
    body.mechanism.bodies[1].r_dot.setZero();
    CHECK(steps() < 100);
}

TEST_CASE("Without treatment the constraints drift, with it they do not", "[dynamics]") {
    const auto drift = [](Treatment treatment) {
        const Lesson pendulum = test::simple_pendulum();
        SimulationSettings settings = settings_with(Method::rk4, 0.02);
        settings.treatment = treatment;
        Simulation simulation(pendulum.mechanism, pendulum.dynamics->loads, settings);
        double worst = 0.0;
        const auto outcome = simulation.run({0.0, 10.0}, [&](double t, const std::vector<double>& y) {
            worst = simulation.snapshot(t, y).position_violation;
        });
        CHECK_FALSE(outcome.failure);
        return worst;
    };
    CHECK(drift(Treatment::none) > 1e-5);
    CHECK(drift(Treatment::baumgarte) < 0.1 * drift(Treatment::none));
    // a tenth of the tolerance 1e-6, below which nothing is moved
    CHECK(drift(Treatment::projection) < 1e-6);
}

}  // namespace jw
