#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "app/session/picture/picture.hpp"
#include "app/session/picture/picture_parts.hpp"
#include "tests/app/session/picture_lessons.hpp"
#include "tests/support/grown_mechanisms.hpp"
#include "tests/support/random_nets.hpp"

namespace jw::test {

using namespace picture;

TEST_CASE("one camera has everything in sight that is ever drawn", "[app][picture]") {
    for (Lesson lesson :
         {chain(), one_joint("screw"), one_joint("prismatic"), one_joint("distance"), crank()}) {
        lesson.mechanism.bodies[1].r += Vec3(0.05, 0.02, -0.03);
        const Story story(lesson);
        const PictureStyle style = picture_style(story);
        const render::Rect viewport{0.0, 60.0, 768.0, 500.0};
        const render::Rect safe = render::shrunk(viewport, 40.0);
        const render::Camera camera = camera_of(story, style, viewport, safe);
        for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
            const Picture picture = picture_of(story, style, k);
            for (const Annotation& a : picture.annotations) {
                const render::Projected seen = render::project(camera, viewport, a.at);
                INFO(a.text << " at " << seen.x << ", " << seen.y);
                CHECK(seen.visible);
                CHECK(render::shrunk(safe, -1.0).contains(seen.x, seen.y));
            }
            const render::Bounds drawn = render::bounds_of(picture.scene);
            CHECK((drawn.lowest() - style.bounds.lowest()).minCoeff() >= 0.0);
            CHECK((style.bounds.highest() - drawn.highest()).minCoeff() >= 0.0);
        }
        CHECK(style.ground.normal.dot(style.ground.point) < style.up.dot(style.bounds.lowest()) + 1e-9);
    }
}

// the style skips bodies that have not moved; here every step is drawn whole
TEST_CASE("bounds of what moves are those of whole pictures", "[app][picture]") {
    for (unsigned seed = 0; seed < 60; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        Lesson lesson = lesson_of(seed % 2 == 0 ? grown_mechanism(seed, 12, 3) : random_net(random));
        if (seed % 3 == 0) { lesson.motion = MotionPlan{.to = 0.5, .steps = 40}; }
        for (Body& body : lesson.mechanism.bodies) {
            if (!body.fixed) { body.r += 0.01 * random.vector(); }
        }
        const Story story(lesson);
        const PictureStyle style = picture_style(story);
        render::Bounds all;
        render::Bounds with_iterations;
        for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
            const Step& step = story.steps()[static_cast<std::size_t>(k)];
            const render::Bounds now = render::bounds_of(compose(story, style, step, k).scene);
            if (step.kind != Step::Kind::iteration) { all.include(now); }
            with_iterations.include(now);
        }
        const bool wild = style.bounds.diagonal() < 0.99 * with_iterations.diagonal();
        const render::Bounds& expected = wild ? all : with_iterations;
        for (int n = 0; n < 50; ++n) {
            const Vec3 direction = random.vector().normalized();
            // what moves by less than a millionth of the picture is not drawn again
            CHECK(
                style.bounds.extent(direction) ==
                Approx(expected.extent(direction)).margin(1e-5 * style.unit));
        }
    }
}

TEST_CASE("a wished camera is where the lesson wants it", "[app][picture]") {
    Lesson lesson = chain();
    lesson.camera.from = Vec3(0.0, -1.0, 0.5).normalized();
    lesson.camera.target = Vec3(0.4, 0.1, 0.2);
    const Story story(lesson);
    const PictureStyle style = picture_style(story);
    const render::Rect viewport{0.0, 0.0, 640.0, 480.0};
    const render::Rect safe = render::shrunk(viewport, 30.0);
    const render::Camera camera = camera_of(story, style, viewport, safe);
    CHECK((camera.target - *lesson.camera.target).norm() < 1e-12);
    CHECK(((camera.eye - camera.target).normalized() - *lesson.camera.from).norm() < 1e-12);
    // as near as can be with everything in sight
    for (const Vec3& corner : {style.bounds.lowest(), style.bounds.highest()}) {
        CHECK(render::project(camera, viewport, corner).visible);
    }
    lesson.camera.distance = 7.0;
    const Story again(lesson);
    CHECK(camera_of(again, picture_style(again), viewport, safe).distance() == Approx(7.0));
}

TEST_CASE("the camera's own choice sees no axis end-on", "[app][picture]") {
    for (int k = 0; k < 12; ++k) {
        const double a = k * std::numbers::pi / 12.0;
        Lesson lesson = one_joint("revolute");
        const Vec3 axis(std::cos(a), std::sin(a), 0.3 * std::sin(5.0 * a));
        SceneBuilder scene;
        const int body = scene.add_body("body", Vec3(1.0, 0.4, 0.6));
        scene.add_joint("revolute", 0, body, kPoint, axis);
        lesson = lesson_of(scene.mechanism);
        const Story story(lesson);
        // 0.4: an arrow is seen with at least two fifths of its length
        CHECK(view_direction(story, Vec3::UnitZ()).cross(axis.normalized()).norm() > 0.4);
    }
}

TEST_CASE("pictures of degenerate mechanisms have only finite numbers", "[app][picture]") {
    std::vector<Lesson> lessons;
    SceneBuilder nothing;
    nothing.add_body("alone", Vec3::Zero());
    lessons.push_back(lesson_of(nothing.mechanism));
    SceneBuilder ground_only;
    lessons.push_back(lesson_of(ground_only.mechanism));
    for (const char* type : {"n2", "p2", "cylindrical", "distance", "planar"}) {
        // all points in one place, d = 0
        lessons.push_back(one_joint(type));
        JointGeometry& g = lessons.back().mechanism.joints.front().geometry;
        lessons.back().mechanism.bodies[1] = lessons.back().mechanism.bodies[0];
        lessons.back().mechanism.bodies[1].fixed = false;
        g.P_j_local = g.P_i_local;
        if (g.length > 0.0) { g.length = 1e-9; }
    }
    // an author may give p another length than 1, which must be drawn, too
    lessons.push_back(chain());
    lessons.back().mechanism.bodies[1].p *= 1.5;
    lessons.push_back(chain());
    lessons.back().camera.from = Vec3::UnitZ();  // along up
    for (const double up : {-1.0, 1.0}) {
        lessons.push_back(chain());
        lessons.back().camera.up = up * Vec3::UnitY();
    }
    const render::Rect viewport{0.0, 0.0, 640.0, 480.0};
    for (std::size_t n = 0; n < lessons.size(); ++n) {
        INFO("lesson " << n);
        const Story story(lessons[n]);
        const PictureStyle style = picture_style(story);
        CHECK(std::isfinite(style.unit));
        CHECK(style.unit > 0.0);
        const render::Camera camera = camera_of(story, style, viewport, render::shrunk(viewport, 30.0));
        CHECK(camera.eye.allFinite());
        CHECK(render::view_matrix(camera).allFinite());
        for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
            CHECK(is_finite(picture_of(story, style, k)));
        }
    }
}

TEST_CASE("a picture depends on nothing but the step", "[app][picture]") {
    const Lesson lesson = chain();
    const Story story(lesson);
    const Story again(lesson);
    const PictureStyle style = picture_style(story);
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        CHECK(same_pictures(picture_of(story, style, k), picture_of(again, picture_style(again), k)));
    }
}

TEST_CASE("a scaled machine gives a scaled picture", "[app][picture]") {
    const auto unit_of = [](double scale) {
        SceneBuilder scene;
        scene.mechanism.bodies[0].r *= scale;
        const int body = scene.add_body("body", scale * Vec3(1.0, 0.4, 0.6));
        scene.add_joint("revolute", 0, body, scale * kPoint, kAxis);
        const Lesson lesson = lesson_of(scene.mechanism);
        return picture_style(Story(lesson)).unit / scale;
    };
    // tolerance: the poses come from an iteration that ends at 1e-12 or so
    CHECK(unit_of(1e-3) == Approx(unit_of(1.0)).epsilon(1e-9));
    CHECK(unit_of(1e3) == Approx(unit_of(1.0)).epsilon(1e-9));
}

TEST_CASE("a solid knows what is inside and how far out is", "[app][picture]") {
    Lesson lesson = one_joint("revolute");
    lesson.mechanism.bodies[0].r.setZero();
    lesson.mechanism.bodies[0].p = Vec4::Unit(0);
    lesson.looks[0].shapes = {
        Box{Vec3(2.0, 0.2, 0.2)}, Cylinder{Vec3(3, 0, 0), Vec3(3, 0, 1), 0.5}, Sphere{Vec3(5, 0, 0), 0.3},
        Rod{Vec3(7, 0, 0), Vec3(8, 0, 0), 0.1}};
    lesson.looks[1].shapes = {Sphere{Vec3(0, 0, 50), 0.1}};
    const Story story(lesson);
    PictureStyle style;
    style.bodies = {lesson.looks[0].shapes, lesson.looks[1].shapes};
    const Solid solid(style, story.steps().front().state, 0, 1);
    CHECK(solid.contains(Vec3(0.99, 0.09, -0.09)));
    CHECK_FALSE(solid.contains(Vec3(1.01, 0.0, 0.0)));
    CHECK(solid.contains(Vec3(3.3, 0.3, 0.01)));
    CHECK_FALSE(solid.contains(Vec3(3.3, 0.3, -0.01)));
    CHECK(solid.contains(Vec3(5.0, 0.29, 0.0)));
    CHECK(solid.contains(Vec3(8.09, 0.0, 0.0)));
    CHECK_FALSE(solid.contains(Vec3(8.11, 0.0, 0.0)));
    // tolerance: the way out is searched in 40 steps of the limit
    CHECK(solid.reach(Vec3::Zero(), Vec3::UnitX(), 2.0) == Approx(1.0).margin(2.0 / 40));
    CHECK(solid.reach(Vec3(1.5, 0.0, 0.0), Vec3::UnitX(), 2.0) == 0.0);
    // along the bar a vector is hidden, across it is not
    CHECK(solid.clearance(Vec3::Zero(), Vec3(0.8, 0.0, 0.0), 0.5) > 0.1);
    CHECK(solid.clearance(Vec3::Zero(), Vec3(0.0, 0.8, 0.0), 0.5) == 0.0);
}

}  // namespace jw::test
