#include <catch2/catch.hpp>

#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/story.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/view/series.hpp"
#include "app/session/view/view.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

/// A run as `simulate` writes it, of every sample; the story's steps and curves of the same lesson.
struct Shown {
    explicit Shown(const Lesson& lesson)
        : table(simulate(lesson, request_of(lesson))),
          story(lesson, poses_only(true)),
          set(motion_series(story)) {}

    double of_table(const std::string& name, std::size_t row) const {
        return table.rows[row][table.column_of(name)];
    }
    double of_plot(const std::string& name, std::size_t row) const {
        const auto found = std::ranges::find(set.series, name, &Series::name);
        REQUIRE(found != set.series.end());
        return found->values[row];
    }

    DynamicsTable table;
    Story story;
    SeriesSet set;
};

/// A number of `simulate` is that number wherever it is shown: no tolerance.
void check_agreement(const Lesson& lesson) {
    const Shown shown(lesson);
    REQUIRE(shown.table.failure.empty());
    REQUIRE(shown.set.at.size() == shown.table.rows.size());
    for (std::size_t row = 0; row < shown.table.rows.size(); ++row) {
        REQUIRE(shown.set.at[row] == shown.of_table("time_s", row));
        const Step& step = shown.story.steps()[static_cast<std::size_t>(shown.set.steps[row])];
        const View view = view_of(shown.story, shown.set.steps[row], ViewParts::without_matrix);
        for (const BodyMotion& body : view.bodies) {
            INFO(body.body << " at " << step.t << " s");
            const std::array axes{".x", ".y", ".z"};
            for (int k = 0; k < 3; ++k) {
                const std::string axis = axes[static_cast<std::size_t>(k)];
                CHECK(body.r(k) == shown.of_table(body.body + axis, row));
                CHECK(body.r_dot(k) == shown.of_table(body.body + ".r_dot" + axis, row));
                CHECK(shown.of_plot(body.body + axis, row) == body.r(k));
                CHECK(shown.of_plot(body.body + ".r_dot" + axis, row) == body.r_dot(k));
            }
            for (int k = 0; k < 4; ++k) {
                CHECK(body.p(k) == shown.of_table(body.body + ".e" + std::to_string(k), row));
            }
        }
        for (const char* energy : {"energy.kinetic", "energy.potential"}) {
            CHECK(shown.of_plot(energy, row) == shown.of_table(energy, row));
        }
    }
    // one of the samples that is not at a step's end
    constexpr std::size_t some = 37;
    const Inspection inspection =
        inspect_time(lesson, shown.of_table("time_s", some), lesson.coordinates, Spectrum::of_small);
    for (std::size_t b = 0; b < lesson.mechanism.bodies.size(); ++b) {
        const Body& body = lesson.mechanism.bodies[b];
        if (body.fixed) { continue; }
        INFO(body.name);
        CHECK(inspection.state.r[b].x() == shown.of_table(body.name + ".x", some));
        CHECK(inspection.state.p[b](0) == shown.of_table(body.name + ".e0", some));
        CHECK(inspection.velocity.omega_local[b].z() == shown.of_table(body.name + ".omega_local.z", some));
    }
}

}  // namespace

TEST_CASE("inspect, steps and curves show the numbers of simulate to the last digit", "[app][dynamics]") {
    for (const char* name :
         {"andrews", "bricard-falling", "chain-revolute-4", "chain-spherical-4", "four-bar-1", "four-bar-4",
          "free-asymmetric-body", "governor", "simple-pendulum", "spatial-slider-crank-falling",
          "spinning-top", "torsion-pendulum"}) {
        INFO(name);
        check_agreement(lesson_named(std::string("dynamics/") + name));
    }
}

TEST_CASE("simulate and solve add columns that are asked for by name", "[app][dynamics]") {
    const std::string pendulum = lesson_path("dynamics/simple-pendulum.toml");
    const Ran ran = run(
        {"simulate", pendulum, "--samples", "2", "--quantities", "pin.force.y,energy.sum,pin.angle rate"});
    CHECK(ran.status == 0);
    CHECK(ran.out.find("p_drift,pin.force.y,energy.sum,pin.angle_dot\n") != std::string::npos);
    CHECK(ran.err.find("'pin.angle rate' is now called 'pin.angle_dot'") != std::string::npos);
    const Ran wrong = run({"simulate", pendulum, "--quantities", "pin.forc.y"});
    CHECK(wrong.status == 2);
    CHECK(wrong.err.find("no quantity 'pin.forc.y'") != std::string::npos);
    const Ran old = run({"simulate", pendulum, "--samples", "1", "--old-names"});
    CHECK(old.out.find("kinetic_J,potential_J,position_violation") != std::string::npos);
    const Ran solved = run(
        {"solve", lesson_path("loops/four-bar.toml"), "--to", "0", "--quantities",
         "jacobian.smallest_singular_value"});
    CHECK(solved.status == 0);
    CHECK(solved.out.find(",residual,jacobian.smallest_singular_value,unique") != std::string::npos);
}

TEST_CASE("a claim about dynamics that is wrong, or has no number, is not proved", "[app][dynamics]") {
    const std::string text = bytes_of(lesson_path("dynamics/four-bar-1.toml"));
    const Folder folder;
    const auto checked = [&](const std::string& claim) {
        return run({"check", folder.file("four-bar.toml", text + "\n[[expect]]\nat_s = 0.1\n" + claim)});
    };
    const Ran wrong = checked("quantity = \"energy.sum\"\nvalue = 20\ntolerance = 0.1\n");
    CHECK(wrong.status == 1);
    // out of its plane the four-bar braces itself
    const Ran open = checked("quantity = \"pin 0.force.z\"\nvalue = 0\ntolerance = 1\n");
    CHECK(open.status == 1);
    CHECK(open.out.find("not unique") != std::string::npos);
}

}  // namespace jw::test
