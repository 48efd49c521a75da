#include "app/panels/column/direction_sphere.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "core/equations/assembler.hpp"
#include "core/poses/rank.hpp"
#include "tests/app/panels/support.hpp"
#include "tests/support/scene_builder.hpp"

namespace jw::panels::test {

namespace {

render::CameraAxes camera_from(const Vec3& eye) {
    render::Camera camera;
    camera.eye = eye;
    camera.target = Vec3::Zero();
    return render::axes_of(camera);
}

std::vector<Vec3> some_directions() {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<Vec3> directions{Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitZ(), Vec3::Ones().normalized()};
    for (int k = 0; k < 60; ++k) {
        directions.push_back(Vec3(normal(random), normal(random), normal(random)).normalized());
    }
    return directions;
}

constexpr PairInUse kPairs[] = {PairInUse::rule, PairInUse::drop_x, PairInUse::drop_y, PairInUse::drop_z};

/// Smallest singular value of the rows of p1 between the ground and a body, computed from the equations
/// themselves.
double smallest_singular_value(ParallelForm form, const Vec3& axis) {
    jw::test::SceneBuilder scene;
    const int body = scene.add_body("body", Vec3::Zero());
    scene.add_joint("revolute", 0, body, Vec3::Zero(), axis);
    scene.mechanism.joints[0].parallel_form = form;
    System system(scene.mechanism, everything(scene.mechanism));
    const State state = start_state(scene.mechanism);
    system.choose_rows(state);
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    for (const Constraint& c : system.constraints()) {
        if (!is_parallel(c.role)) { continue; }
        const VectorX sigma = singular_values_of(assembler.jacobian().middleRows(c.first_row, 2));
        return sigma(1) / c.unit;
    }
    return -1.0;
}

}  // namespace

TEST_CASE("the sphere shows the smallest singular value of the rows themselves", "[panels][sphere]") {
    constexpr ParallelForm forms[] = {
        ParallelForm::rule, ParallelForm::drop_x, ParallelForm::drop_y, ParallelForm::drop_z};
    for (std::size_t k = 0; k < 4; ++k) {
        for (const Vec3& s : some_directions()) {
            CAPTURE(k, s.transpose());
            // a start is aligned to the rounding of p
            CHECK(pair_quality(kPairs[k], s) == Approx(smallest_singular_value(forms[k], s)).margin(1e-12));
        }
    }
}

TEST_CASE("lines of the sphere lie where their values are", "[panels][sphere]") {
    for (const PairInUse pair : kPairs) {
        for (const SphereLine& line : lines_of(pair)) {
            for (const Vec3& d : line.points) {
                REQUIRE(d.norm() == Approx(1.0));
                const double quality = pair_quality(pair, d);
                switch (line.kind) {
                    case SphereLine::Kind::contour: REQUIRE(quality == Approx(std::stod(line.label))); break;
                    case SphereLine::Kind::lost: REQUIRE(quality < 1e-15); break;
                    case SphereLine::Kind::border: {
                        Vec3 size = d.cwiseAbs();
                        std::sort(size.begin(), size.end());
                        REQUIRE(size(1) == Approx(size(2)));
                        break;
                    }
                }
            }
        }
    }
}

TEST_CASE("a direction is found again under the pixel where it is drawn", "[panels][sphere]") {
    const Surface surface;
    const DirectionSphere sphere;
    const Box box{20.0F, 10.0F, 480.0F, 520.0F};
    for (const Vec3& eye : {Vec3(2.4, -3.6, 2.2), Vec3(-1.0, 0.2, -3.0), Vec3(0.01, 0.0, 5.0)}) {
        const SphereView view = direction_sphere(surface.canvas(), box, sphere, camera_from(eye));
        for (const Vec3& d : some_directions()) {
            const auto found = view.direction(view.pixel(d));
            REQUIRE(found.has_value());
            const Vec3 seen = view.faces(d) ? d : Vec3(d - 2.0 * d.dot(view.towards) * view.towards);
            // pixels are floats near 300 with a radius of 130: 2e-7, and its root where the sphere turns away
            CHECK((*found - seen).norm() < 2e-3);
        }
        const Point beyond{view.centre.x + 1.3F * view.radius, view.centre.y};
        REQUIRE(view.direction(beyond).has_value());
        CHECK(view.direction(beyond)->isApprox(view.right));
        CHECK_FALSE(view.direction({view.centre.x, view.centre.y + 1.6F * view.radius}).has_value());
    }
}

TEST_CASE("the sphere and its words stay in their box, from wherever it is seen", "[panels][sphere]") {
    Surface surface;
    for (const Box& box :
         {Box{10.0F, 10.0F, 480.0F, 260.0F}, Box{0.0F, 0.0F, 220.0F, 220.0F}, Box{5.0F, 5.0F, 480.0F, 520.0F},
          Box{0.0F, 0.0F, 1500.0F, 800.0F}}) {
        for (const PairInUse pair : kPairs) {
            for (const Vec3& eye : some_directions()) {
                DirectionSphere sphere;
                sphere.pair = pair;
                sphere.axis = some_directions()[static_cast<std::size_t>(box.width) % 50];
                sphere.trail = some_directions();
                surface.clear();
                const Vec3 from = eye.cross(Vec3::UnitZ()).norm() < 1e-6 ? Vec3(0.1, 0.2, eye.z()) : eye;
                direction_sphere(surface.canvas(), box, sphere, camera_from(from));
                CAPTURE(box.width, static_cast<int>(pair), from.transpose());
                REQUIRE(with_fringe(box).contains(surface.drawn()));
            }
        }
    }
}

TEST_CASE("words say which equation is left out and what that costs", "[panels][sphere]") {
    DirectionSphere sphere;
    sphere.axis = Vec3(0.6, 0.0, 0.8);
    CHECK(sphere_words(sphere).find("z is left out: value 0.8, condition 1.25.") != std::string::npos);
    sphere.dropped = 0;
    CHECK(sphere_words(sphere).find("x is left out: value 0.6") != std::string::npos);
    CHECK(sphere_words(sphere).find("earlier choice is kept") != std::string::npos);
    sphere.pair = PairInUse::drop_y;
    CHECK(sphere_words(sphere).find("value 0, condition ∞") != std::string::npos);
    sphere.axis.reset();
    CHECK(sphere_words(sphere).find("Now") == std::string::npos);
}

}  // namespace jw::panels::test
