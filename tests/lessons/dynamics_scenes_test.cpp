#include <catch2/catch.hpp>

#include "core/integrate/explicit_integrator.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/lesson_difference.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/dynamics_scenes.hpp"
#include "tests/support/scene_builder.hpp"

using namespace jw;
using test::dynamics_scene_files;
using test::SceneFile;

namespace {

/// Equations of motion of a scene, and its start.
struct Scene {
    explicit Scene(const Lesson& scene)
        : lesson(&scene),
          centred(centroidal(scene.mechanism, scene.dynamics->loads)),
          equations(block_equations(centred)),
          y(static_cast<std::size_t>(equations->size())) {
        for (int b = 0; b < static_cast<int>(scene.mechanism.bodies.size()); ++b) {
            if (!scene.mechanism.bodies[static_cast<std::size_t>(b)].fixed) { moving.push_back(b); }
        }
        pack(start_state(centred.mechanism), start_motion(centred.mechanism), moving, y.data());
    }

    /// Position of the lesson's point at `end`.
    Vec3 point_at(const std::vector<double>& end) const {
        State state = start_state(centred.mechanism);
        Motion motion = start_motion(centred.mechanism);
        unpack(end.data(), moving, state, motion);
        const State given = centred.as_given(state);
        const auto b = static_cast<std::size_t>(lesson->dynamics->point->body);
        return given.r[b] + rotation_matrix(given.p[b]) * lesson->dynamics->point->point_local;
    }

    const Lesson* lesson;
    Centroidal centred;
    std::unique_ptr<MotionEquations> equations;
    std::vector<int> moving;
    std::vector<double> y;
};

}  // namespace

TEST_CASE("Shipped scenes of dynamics are what their program writes", "[lessons][dynamics]") {
    for (const SceneFile& file : dynamics_scene_files()) {
        INFO(file.path << ": ./dev scenes writes it anew");
        const std::string text = test::text_of_file(("lessons" / file.path).string());
        CHECK(text == lesson_text(file.lesson));
        const ReadResult read = read_lesson(text, "scene.toml");
        CHECK(read.report() == "");
        REQUIRE(read.lesson.has_value());
        CHECK(test::first_difference(file.lesson, *read.lesson) == "");
    }
}

TEST_CASE("Scenes of dynamics start assembled, moving as their joints allow", "[lessons][dynamics]") {
    for (const SceneFile& file : dynamics_scene_files()) {
        INFO(file.path);
        const Scene scene(file.lesson);
        const auto [phi, phi_dot] = scene.equations->violation(0.0, scene.y.data());
        // a few roundings of lengths up to 64 m and of velocities up to 2 m/s
        CHECK(phi < 1e-15);
        CHECK(phi_dot < 1e-14);
        CHECK(file.lesson.dynamics->point.has_value());
    }
}

TEST_CASE("Scenes of dynamics end where the references say", "[lessons][dynamics]") {
    int compared = 0;
    for (const SceneFile& file : dynamics_scene_files()) {
        const DynamicsPlan& plan = *file.lesson.dynamics;
        // an explicit method needs a second and more for the stiff one
        if (!plan.point_at_end || plan.settings.method == Method::implicit_5) { continue; }
        INFO(file.path);
        Scene scene(file.lesson);
        IntegrationOptions options;
        options.tolerance = 1e-9;
        ExplicitIntegrator integrator(*scene.equations, dormand_prince_853(), options, 0.0, scene.y);
        while (integrator.t() < plan.duration) { REQUIRE(integrator.step(plan.duration)); }
        // a thousand times the tolerance: 160 steps, and the singular line of A02 twice a turn
        CHECK((scene.point_at(integrator.y()) - *plan.point_at_end).norm() < 1e-6);
        ++compared;
    }
    CHECK(compared == 11);
}

TEST_CASE("Any number of bodies makes a scene with the freedoms it should have", "[lessons][dynamics]") {
    for (const int n : {1, 2, 3, 7}) {
        CHECK(test::rank_of(test::n_four_bar(n).mechanism).dof == 1);
        CHECK(test::rank_of(test::chain(test::ChainJoint::revolute, n).mechanism).dof == n);
        CHECK(test::rank_of(test::chain(test::ChainJoint::spherical, n).mechanism).dof == 3 * n);
    }
}
