#include <catch2/catch.hpp>

#include <new>

#include "core/poses/newton.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/driven.hpp"

using namespace jw;

namespace {

/// Allocations of one call.
template <class F>
long allocations_of(const F& f) {
    const long before = test::allocations();
    f();
    return test::allocations() - before;
}

std::vector<Mechanism> scenes() {
    return {
        test::driven(test::four_bar_at(0.7), 0, 1.0),
        test::driven(test::bricard(1.2), 0, 1.0),
        test::four_bar_at(0.7),
        test::rssr(0.7),
        test::cardan(0.5, 0.3),
        test::screw(0.7, 0.25, ScrewAngleForm::rotation)};
}

}  // namespace

TEST_CASE("The counter sees what the core and Eigen allocate", "[core][allocation]") {
    // a plain call, which the compiler may not leave out
    CHECK(allocations_of([] { ::operator delete(::operator new(8)); }) == 1);
    CHECK(allocations_of([] { const VectorX vector = VectorX::Zero(40); }) == 1);
    const Mechanism mechanism = test::four_bar_at(0.7);
    CHECK(allocations_of([&] { const System system(mechanism, everything(mechanism)); }) > 10);
}

TEMPLATE_TEST_CASE(
    "No Newton iteration after the first allocates", "[core][allocation]", TrueEulerParameters,
    ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const Mechanism& mechanism : scenes()) {
        const System system(mechanism, everything(mechanism));
        NewtonStepper<TestType> stepper(system);
        for (unsigned seed = 1; seed <= 5; ++seed) {
            test::Random random(seed);
            CAPTURE(mechanism.joints.size(), seed);
            stepper.start(test::disturbed(mechanism, start_state(mechanism), random, 0.2, 0.3), 0.0);
            int iterations = 0;
            while (!stepper.outcome()) {
                const long allocations = allocations_of([&] { stepper.step(); });
                // the first step of a stepper may still allocate its work space
                if (seed > 1 || iterations > 0) { CHECK(allocations == 0); }
                ++iterations;
            }
            CHECK(stepper.outcome()->converged);
            CHECK(iterations > 2);
        }
    }
}

TEMPLATE_TEST_CASE(
    "Assembling Phi, Jacobian, nu and gamma allocates nothing", "[core][allocation]", TrueEulerParameters,
    ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const Mechanism& mechanism : scenes()) {
        const System system(mechanism, everything(mechanism));
        Assembler<TestType> assembler(system);
        const State state = start_state(mechanism);
        const Motion motion = start_motion(mechanism);
        CHECK(allocations_of([&] {
                  assembler.assemble_phi_and_jacobian(state, 0.0);
                  assembler.assemble_nu(0.0);
                  assembler.assemble_gamma(state, motion, 0.0);
              }) == 0);
    }
}
