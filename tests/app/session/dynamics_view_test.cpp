#include "app/session/view/dynamics_view.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <ranges>

#include "app/session/output/describe.hpp"
#include "app/session/view/view.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {

namespace {

std::vector<std::filesystem::path> lessons_of_dynamics() {
    std::vector<std::filesystem::path> files;
    for (const auto& file : all_lesson_files()) {
        const Lesson lesson = shipped(file);
        if (lesson.dynamics && !lesson.motion) { files.push_back(file); }
    }
    return files;
}

/// Momentum, angular momentum and kinetic energy, from the given frames: by other formulas than the view's.
struct Sums {
    Vec3 momentum = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    double kinetic = 0.0;
};

Sums sums_of(const Step& step) {
    const Centroidal& scene = *step.centroidal;
    Sums sums;
    for (std::size_t b = 0; b < scene.mechanism.bodies.size(); ++b) {
        if (scene.mechanism.bodies[b].fixed) { continue; }
        const MassProperties& own = *scene.loads.masses[b];
        const Mat3 A = rotation_matrix(step.state.p[b]);
        const Vec3 omega = A * step.velocity.omega_local[b];
        const Vec3 arm = A * scene.centres[b];
        const Vec3 v = step.velocity.r_dot[b] + omega.cross(arm);
        const Vec3 spin = A * own.J_local * A.transpose() * omega;
        sums.momentum += own.mass * v;
        sums.angular += (step.state.r[b] + arm).cross(own.mass * v) + spin;
        sums.kinetic += 0.5 * own.mass * v.dot(v) + 0.5 * omega.dot(spin);
    }
    return sums;
}

/// Largest difference between the accelerations of the view and those of the run, by the largest of all.
double apart(const Step& step, const DynamicsView& view) {
    double difference = 0.0;
    double size = 1.0;
    std::size_t k = 0;
    for (const int body : step.system->moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        const DynamicsView::Body& own = view.bodies[k++];
        const Motion& run = step.centroidal_acceleration;
        difference = std::max(
            {difference, (own.r_ddot - run.r_dot[b]).norm(),
             (own.omega_local_dot - run.omega_local[b]).norm()});
        size = std::max({size, run.r_dot[b].norm(), run.omega_local[b].norm()});
    }
    return difference / size;
}

}  // namespace

TEST_CASE("M q̈ − Φqᵀ λ − Q is zero to rounding in all lessons of dynamics", "[app][dynamics]") {
    const auto files = lessons_of_dynamics();
    REQUIRE(files.size() >= 10);
    for (const auto& file : files) {
        const Lesson lesson = shipped(file);
        StoryOptions options;
        options.intervals = 12;
        options.curve_moments = 0;
        const Story story(lesson, options);
        for (const Step& step : story.steps()) {
            const auto view = dynamics_view_of(step);
            CAPTURE(file, step.t);
            REQUIRE(view.has_value() == (step.kind == Step::Kind::motion));
            if (!view) { continue; }
            const VectorX inertia = view->M * view->acceleration;
            const VectorX left = inertia - view->jacobian.transpose() * view->lambda - view->Q;
            // rounding of a system of up to a hundred unknowns
            CHECK(left.norm() <= 1e-12 * (inertia.norm() + view->Q.norm()));
            CHECK(view->residual < 1e-12);
            // the run has its own method, on a tree or in blocks; where rows are redundant, poses that are
            // right to the tolerance of the run make rows contradict each other by as much
            CHECK(apart(step, *view) < 1e-5);
            CHECK(view->multipliers.size() == static_cast<std::size_t>(view->lambda.size()));

            const Sums sums = sums_of(step);
            const double size = 1.0 + sums.kinetic;
            CHECK((view->momentum - sums.momentum).norm() < 1e-10 * size);
            CHECK((view->angular_momentum - sums.angular).norm() < 1e-10 * size);
            CHECK(std::abs(view->energy.kinetic - sums.kinetic) < 1e-10 * size);
        }
    }
}

TEST_CASE("M is diag(m I, J′), and Q has f and n′ − ω̃′J′ω′, body by body", "[app][dynamics]") {
    const Lesson lesson = lesson_named("dynamics/spinning-top");
    const Story story(lesson);
    const auto moves = [](const Step& s) { return s.kind == Step::Kind::motion; };
    const Step& step = *std::ranges::find_if(story.steps() | std::views::reverse, moves);
    const auto view = dynamics_view_of(step);
    REQUIRE(view);
    REQUIRE(view->bodies.size() == 1);
    const DynamicsView::Body& body = view->bodies.front();
    CHECK(view->M.topLeftCorner(3, 3) == body.mass * MatrixX::Identity(3, 3));
    CHECK(view->M.block(3, 3, 3, 3) == MatrixX(body.J_local));
    CHECK(view->M.block(0, 3, 3, 3).isZero());
    CHECK(view->Q.head(3) == VectorX(body.f));
    const auto b = static_cast<std::size_t>(step.system->moving_bodies().front());
    const Vec3& omega = step.velocity.omega_local[b];
    // gravity has no moment about the centre of mass
    CHECK((body.n_local + omega.cross(body.J_local * omega)).norm() < 1e-12 * omega.squaredNorm());
    CHECK(view->multipliers.front().owner == lesson.mechanism.joints.front().name);
}

TEST_CASE("inspect tells M, Q, λ, energies and momenta of a moment of dynamics", "[app][dynamics]") {
    const Lesson lesson = lesson_named("dynamics/four-bar-1");
    const Inspection inspection = inspect_time(lesson, 0.25, lesson.coordinates);
    REQUIRE(inspection.dynamics);
    const std::string text = describe(inspection, lesson);
    for (const char* const part :
         {"| M   Φqᵀ | |  q̈ |   | Q |", "J′ [kg m²]", "n′ − ω̃′J′ω′", "λ of", "kinetic energy",
          "angular momentum about the origin"}) {
        CHECK_THAT(text, Catch::Contains(part));
    }
    const Json json = json_of(inspection, lesson)["dynamics"];
    CHECK(json["M"].size() == json["Q"].size());
    CHECK(json["lambda"].size() == json["gamma"].size());
    CHECK(json["kinetic_energy"] == inspection.dynamics->energy.kinetic);
    // a lesson of kinematics has no dynamics
    const Lesson driven = lesson_named("loops/four-bar");
    CHECK(json_of(inspect_time(driven, 0.5, driven.coordinates), driven)["dynamics"].is_null());
}

}  // namespace jw::test
