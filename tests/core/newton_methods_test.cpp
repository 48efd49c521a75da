#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include <Eigen/SVD>

#include "core/poses/newton_methods.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/singular_scenes.hpp"

using namespace jw;
using test::kPi;

namespace {

constexpr std::array kMethods{
    NewtonMethod::stepwise_limited, NewtonMethod::plain, NewtonMethod::damped,
    NewtonMethod::levenberg_marquardt};

std::vector<Mechanism> regular_scenes() {
    return {
        test::driven(test::four_bar_at(0.7), 0, 0.0), test::driven(test::bennett(0.7), 0, 0.0),
        test::driven(test::rssr(0.7), 0, 0.0), test::driven(test::slider_crank(1.0, 3.0, 0.7), 0, 0.0)};
}

template <class C>
NewtonTrace trace_from(
    const Mechanism& mechanism, unsigned seed, double off, NewtonMethod method, bool rows = true) {
    const System system(mechanism, everything(mechanism));
    test::Random random(seed);
    const State start = test::disturbed(mechanism, start_state(mechanism), random, off, off);
    return trace_newton<C>(system, start, 0.0, method, rows);
}

/// Mean of the orders measured from twenty starts.
template <class C>
double mean_order(const Mechanism& mechanism, NewtonMethod method) {
    double sum = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const NewtonTrace trace = trace_from<C>(mechanism, seed, 0.1, method);
        CAPTURE(seed);
        REQUIRE(trace.converged);
        REQUIRE(trace.order.has_value());
        sum += *trace.order;
    }
    return sum / 20.0;
}

bool is_finite(const NewtonTrace& trace) {
    bool finite = true;
    for (const NewtonIterate& i : trace.iterates) {
        for (const double x : {i.phi_norm, i.residual, i.delta_norm, i.turn, i.fraction, i.damping}) {
            finite = finite && std::isfinite(x);
        }
        for (std::size_t b = 0; b < i.state.r.size(); ++b) {
            finite = finite && i.state.r[b].allFinite() && i.state.p[b].allFinite();
        }
        for (const double theta : i.state.theta) { finite = finite && std::isfinite(theta); }
    }
    return finite && (!trace.order || std::isfinite(*trace.order));
}

/// ‖Φ‖ in scaled rows, which is what damped steps and Levenberg-Marquardt lower.
template <class C>
double scaled_norm(const System& system, const State& state) {
    Assembler<C> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    return assembler.phi().cwiseQuotient(scaling_of<C>(system).row).norm();
}

}  // namespace

TEMPLATE_TEST_CASE(
    "Next to a regular solution Newton's order is 2 in every coordinate choice", "[core][newton_methods]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const Mechanism& mechanism : regular_scenes()) {
        for (const NewtonMethod method :
             {NewtonMethod::stepwise_limited, NewtonMethod::plain, NewtonMethod::damped}) {
            CAPTURE(mechanism.joints.size(), static_cast<int>(method));
            // The order belongs to the solution, not to the coordinates. One start measures it to some 0.4,
            // since ε₃/ε₂² still changes with the direction in which the solution is approached.
            CHECK(mean_order<TestType>(mechanism, method) == Approx(2.0).margin(0.2));
        }
    }
}

TEMPLATE_TEST_CASE(
    "At a singular solution every method falls back to order 1, a quarter of the residual per step",
    "[core][newton_methods]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const Mechanism& mechanism : {test::stretched_bars(), test::stretched_revolutes()}) {
        for (const NewtonMethod method : kMethods) {
            CAPTURE(static_cast<int>(method), mechanism.joints[1].type->name);
            const NewtonTrace trace = trace_from<TestType>(mechanism, 1, 0.1, method);
            REQUIRE(trace.converged);
            REQUIRE(trace.order.has_value());
            // the ratio is constant up to the next order, which has died out after ten steps
            CHECK(*trace.order == Approx(1.0).margin(0.02));
            CHECK(trace.iterates.size() > 14);
            // the distance halves and Φ is its square
            const auto& i = trace.iterates;
            CHECK(i[10].residual / i[9].residual == Approx(0.25).margin(0.01));
        }
    }
}

TEMPLATE_TEST_CASE(
    "The first whole step is the pseudo-inverse applied to -Phi, in the scene's units",
    "[core][newton_methods]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    // RSSR has no redundant rows and one more freedom: the pseudo-inverse takes the shortest step
    const Mechanism mechanism = test::rssr(0.7);
    const System system(mechanism, everything(mechanism));
    for (const bool rows : {true, false}) {
        test::Random random(3);
        const State start = test::disturbed(mechanism, start_state(mechanism), random, 0.1, 0.1);
        const NewtonTrace trace = trace_newton<TestType>(system, start, 0.0, NewtonMethod::plain, rows);
        Assembler<TestType> assembler(system);
        assembler.assemble_phi_and_jacobian(start, 0.0);
        const Eigen::Index used = rows ? assembler.phi().size() : system.rows();
        const Scaling scaling = scaling_of<TestType>(system);
        const MatrixX J = scaling.row.cwiseInverse().asDiagonal() * assembler.jacobian();
        Eigen::JacobiSVD<MatrixX> svd(J.topRows(used), Eigen::ComputeThinU | Eigen::ComputeThinV);
        const VectorX phi = assembler.phi().cwiseQuotient(scaling.row);
        const VectorX step = svd.solve(-phi.head(used));
        State expected = start;
        assembler.layout().advance(expected, step);
        REQUIRE(trace.iterates.size() > 1);
        for (std::size_t b = 1; b < expected.r.size(); ++b) {
            // rounding times a condition number of some tens
            CHECK((trace.iterates[1].state.r[b] - expected.r[b]).norm() < 1e-13);
            CHECK((trace.iterates[1].state.p[b] - expected.p[b]).norm() < 1e-13);
        }
        CHECK(trace.iterates[0].delta_norm == Approx(step.norm()).epsilon(1e-12));
    }
}

TEMPLATE_TEST_CASE(
    "Far off, plain steps are whole, limited ones turn 0.5 rad at most, the others always come down",
    "[core][newton_methods]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    const Mechanism mechanism = test::driven(test::four_bar_at(0.7), 0, 0.0);
    const System system(mechanism, everything(mechanism));
    int shortened = 0;
    for (unsigned seed = 1; seed <= 15; ++seed) {
        for (const NewtonMethod method : kMethods) {
            CAPTURE(seed, static_cast<int>(method));
            const NewtonTrace trace = trace_from<TestType>(mechanism, seed, 1.2, method);
            CHECK(trace.method == method);
            for (std::size_t k = 0; k + 1 < trace.iterates.size(); ++k) {
                const NewtonIterate& now = trace.iterates[k];
                const bool comes_down =
                    method == NewtonMethod::damped || method == NewtonMethod::levenberg_marquardt;
                if (method == NewtonMethod::plain) { CHECK(now.fraction == 1.0); }
                if (method == NewtonMethod::stepwise_limited) { CHECK(now.fraction * now.turn < 0.5000001); }
                if (comes_down) {
                    CHECK(
                        scaled_norm<TestType>(system, trace.iterates[k + 1].state) <
                        scaled_norm<TestType>(system, now.state));
                }
                CHECK((now.damping > 0.0) == (method == NewtonMethod::levenberg_marquardt));
                if (method == NewtonMethod::damped && now.fraction < 1.0) { ++shortened; }
            }
            const NewtonIterate& last = trace.iterates.back();
            CHECK(last.delta_norm == 0.0);
            // where a lesson's numbers are exact, converged means the tolerance of the arithmetic
            if (trace.converged) { CHECK(last.residual < 1e-11); }
        }
    }
    CHECK(shortened > 10);  // the search had something to do
}

TEST_CASE("A converged trace says when it has reached the wrong branch", "[core][newton_methods]") {
    test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3(0.1, 0.0, 0.0));
    scene.add_joint("revolute", 0, body, Vec3::Zero(), Vec3(1.0, 2.0, 3.0));
    const System system(scene.mechanism, everything(scene.mechanism));
    const Vec3 axis = Vec3(1.0, 2.0, 3.0).normalized();
    for (const double angle : {0.3, kPi - 0.3}) {
        State start = start_state(scene.mechanism);
        start.p[1] = turned_global(start.p[1], angle * perpendicular_to(axis));
        for (const NewtonMethod method : kMethods) {
            CAPTURE(angle, static_cast<int>(method));
            const NewtonTrace trace = trace_newton<OmegaLocal>(system, start, 0.0, method);
            CHECK(trace.converged);
            CHECK(trace.wrong_branch.has_value() == (angle > 1.0));
        }
    }
}

TEMPLATE_TEST_CASE(
    "Without the rows pTp = 1 Newton lets p drift and parts assemble that are too short",
    "[core][newton_methods]", TrueEulerParameters, ModifiedEulerParameters) {
    const Mechanism mechanism = test::stretched_bars();
    const NewtonTrace with = trace_from<TestType>(mechanism, 1, 0.1, NewtonMethod::plain);
    const NewtonTrace without = trace_from<TestType>(mechanism, 1, 0.1, NewtonMethod::plain, false);
    REQUIRE(with.converged);
    REQUIRE(without.converged);
    const auto drift = [](const NewtonTrace& trace) {
        return std::max(
            std::abs(trace.iterates.back().state.p[1].norm() - 1.0),
            std::abs(trace.iterates.back().state.p[2].norm() - 1.0));
    };
    CHECK(drift(with) < 1e-12);
    CHECK(drift(without) > 1e-4);
    // a pose with stretched parts is not singular: the order is 2 again, and few steps are enough
    CHECK(without.iterates.size() < 8);
    CHECK(with.iterates.size() > 14);
}

TEMPLATE_TEST_CASE(
    "Whatever the start, no trace holds a number that is not finite", "[core][newton_methods]",
    TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    const Mechanism mechanism = test::driven(test::screw(0.7, 0.25, ScrewAngleForm::cosine), 0, 0.0);
    const System system(mechanism, everything(mechanism));
    for (const NewtonMethod method : kMethods) {
        for (const bool rows : {true, false}) {
            for (const double size : {1e3, 1e100, 1e160, 1e308}) {
                CAPTURE(size, static_cast<int>(method), rows);
                State start = start_state(mechanism);
                start.r[1] *= size;
                CHECK(is_finite(trace_newton<TestType>(system, start, 0.0, method, rows)));
                start.p[1] = Vec4::Zero();
                CHECK(is_finite(trace_newton<TestType>(system, start, 0.0, method, rows)));
                start.theta[0] = size;
                CHECK(is_finite(trace_newton<TestType>(system, start, 0.0, method, rows)));
            }
            State nowhere = start_state(mechanism);
            nowhere.r[1].x() = std::numeric_limits<double>::quiet_NaN();
            const NewtonTrace trace = trace_newton<TestType>(system, nowhere, 0.0, method, rows);
            CHECK(trace.iterates.empty());
            CHECK_FALSE(trace.converged);
        }
    }
}

TEST_CASE("Parts that cannot meet end every trace unconverged", "[core][newton_methods]") {
    Mechanism mechanism = test::stretched_bars();
    mechanism.joints[2].geometry.P_i_local *= 1.5;  // a bearing out of reach
    for (const NewtonMethod method : kMethods) {
        CAPTURE(static_cast<int>(method));
        const NewtonTrace trace = trace_from<OmegaLocal>(mechanism, 1, 0.05, method);
        CHECK_FALSE(trace.converged);
        CHECK_FALSE(trace.order.has_value());
        CHECK(is_finite(trace));
        CHECK(trace.iterates.size() <= (method == NewtonMethod::levenberg_marquardt ? 201U : 61U));
        if (method == NewtonMethod::plain) { continue; }
        CHECK(trace.iterates.back().residual < 2.0 * trace.iterates.front().residual);
    }
}
