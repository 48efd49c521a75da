#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

#include "tests/lessons/dynamics_paths.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/dynamics_scenes.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Loops whose numbers were typed with some digits only: their links do not quite fit.
namespace jw {

using test::path_of;
using test::Random;
using test::times_until;

namespace {

/// Rounds numbers as if typed with so many digits.
void type(auto& numbers, int digits) {
    for (double& x : numbers.reshaped()) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.*g", digits, x);
        x = std::strtod(text.data(), nullptr);
    }
}

/// The scene, laid by p in the frame of the ground, as somebody types it.
Lesson typed(Lesson lesson, const Vec4& p, int digits) {
    const Mat3 A = rotation_matrix(p);
    std::vector<Body>& bodies = lesson.mechanism.bodies;
    for (Body& body : bodies) {
        if (body.fixed) { continue; }
        body.r = A * body.r;
        body.p = product(p, body.p);
        body.r_dot = A * body.r_dot;
        type(body.r, digits);
        type(body.p, digits);
        type(body.r_dot, digits);
    }
    const auto lay = [&](int body, std::initializer_list<Vec3*> vectors) {
        if (!bodies[at(body)].fixed) { return; }
        for (Vec3* v : vectors) {
            *v = A * *v;
            type(*v, digits);
        }
    };
    for (Joint& joint : lesson.mechanism.joints) {
        JointGeometry& g = joint.geometry;
        lay(joint.body_i, {&g.P_i_local, &g.s_i_local, &g.h_i_local, &g.u_i_local});
        lay(joint.body_j, {&g.P_j_local, &g.s_j_local, &g.h_j_local, &g.u_j_local});
    }
    Vec3& gravity = lesson.dynamics->loads.gravity;
    gravity = A * gravity;
    type(gravity, digits);
    return lesson;
}

}  // namespace

TEST_CASE(
    "A parallelogram typed with some digits falls through its line and keeps its energy", "[dynamics]") {
    // its branches cross only if its numbers fit: otherwise there is a gap of the root of the misfit
    const int digits = GENERATE(6, 7, 8, 10, 12, 15);
    for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
        for (unsigned seed = 0; seed < 4; ++seed) {
            CAPTURE(digits, static_cast<int>(formulation), seed);
            Random random(seed);
            const Lesson lesson = typed(test::n_four_bar(1), random.unit_p(), digits);
            SimulationSettings settings;
            settings.formulation = formulation;
            const auto path = path_of(lesson, settings, times_until(10.0, 100));
            REQUIRE_FALSE(path.failed);
            const auto [least, most] = std::ranges::minmax(path.energies);
            // of 20 J that move: 1e-3 J without a gap; all of it, and more, if a step may end anywhere beyond
            CHECK(most - least < (digits > 10 ? 5e-3 : 1.0));
            CHECK(path.violation < (digits > 10 ? 1e-5 : 2e-2));
        }
    }
}

}  // namespace jw
