#include <catch2/catch.hpp>

#include <algorithm>

#include <nlohmann/json.hpp>

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

/// Checks that a number of `simulate` is the same wherever it is shown, without tolerance.
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
    // out of its plane the reactions of the four-bar are not unique
    const Ran open = checked("quantity = \"pin 0.force.z\"\nvalue = 0\ntolerance = 1\n");
    CHECK(open.status == 1);
    CHECK(open.out.find("not unique") != std::string::npos);
}

TEST_CASE("simulate blames a driver that starts out of reach as step does", "[app][dynamics]") {
    // a link of 1 m on a hinge, its end driven to 2 m
    std::string text = bytes_of(lesson_path("dynamics/simple-pendulum.toml"));
    text.replace(
        text.find("[dynamics]"), 0,
        "[[driver]]\nname = \"pull\"\nquantity = \"coordinate\"\nbody = \"ball\"\ncoordinate = \"y\"\n"
        "polynomial = [2]\n");
    const Folder folder;
    const std::string file = folder.file("far.toml", text);
    const Ran stepped = run({"step", file});
    const Ran simulated = run({"simulate", file});
    CHECK(simulated.status == 3);
    const std::string told = "Driver pull cannot be closed: ";
    const std::size_t from = stepped.err.find(told);
    REQUIRE(from != std::string::npos);
    const std::string why = stepped.err.substr(from, stepped.err.find('\n', from) - from);
    CHECK(why.find("the nearest that can be reached is 1 m") != std::string::npos);
    CHECK(simulated.err.find(why) != std::string::npos);
}

TEST_CASE("A run that blew up is not told as a link out of reach", "[app][dynamics]") {
    const Folder folder;
    const std::string file = folder.file("stiff.toml", R"(format = 1
title = "Stiff"
[[body]]
name = "arm"
mass = 1
inertia = [0.1, 0.1, 0.1]
position = [0.5, 0, 0]
[[body]]
name = "end"
mass = 0.01
inertia = [0.001, 0.001, 0.001]
position = [1.5, 0, 0]
[[joint]]
name = "ball"
type = "spherical"
bodies = ["ground", "arm"]
at = [0, 0, 0]
[[joint]]
name = "slide"
type = "spherical"
bodies = ["arm", "end"]
at = [1, 0, 0]
[dynamics]
duration = 1
gravity = [0, -10, 0]
[[spring]]
bodies = ["ground", "end"]
at = [2, 2, 0]
to = [2, 0, 0]
stiffness = 1e7
free_length = 1
)");
    const Ran ran = run({"simulate", file, "--method", "euler", "--step", "0.01"});
    CHECK(ran.status == 3);
    CHECK(ran.err.find("the solution diverged") != std::string::npos);
}

TEST_CASE("simulate keeps a start velocity that one body of a chain was given", "[app][dynamics]") {
    const Folder folder;
    std::string text = bytes_of(lesson_path("dynamics/simple-pendulum.toml"));
    text.replace(text.find("mass = 1 "), 9, "omega_local_rad_per_s = [0, 0, 10]\nmass = 1 ");
    const Ran ran = run(
        {"simulate", folder.file("spun.toml", text), "--duration", "0.1", "--samples", "1", "--format",
         "json"});
    CHECK(ran.status == 0);
    CHECK(ran.err.find("note") == std::string::npos);
    const auto json = nlohmann::json::parse(ran.out);
    const auto columns = json["columns"].get<std::vector<std::string>>();
    const auto omega = std::ranges::find(columns, "ball.omega_local.z") - columns.begin();
    CHECK(json["rows"][0][static_cast<std::size_t>(omega)] == Approx(10.0).epsilon(1e-12));
}

TEST_CASE(
    "A run goes on in coordinates of the bodies where those of the joints lose digits", "[app][dynamics]") {
    // a rod shoots out of its sleeve while they spin
    const Folder folder;
    const std::string file = folder.file("sleeve.toml", R"(format = 1
title = "A rod leaves its sleeve"
[[body]]
name = "sleeve"
mass = 1
inertia = [0.003, 0.007, 0.005, 0, -0.001, 0]
[[body]]
name = "wheel"
mass = 2
inertia = [0.01, 0.01, 0.02]
[[body]]
name = "rod"
p = [0.449, 0.772, -0.434, 0.121]
omega_local_rad_per_s = [0, 1, -1]
mass = 1.4
inertia = [0.006, 0.0055, 0.003, 0, 0.0005, -0.001]
[[joint]]
name = "axle"
type = "revolute"
bodies = ["wheel", "sleeve"]
at = [0, 0, 0]
axis = [2.55, 1.5, 1.5]
[[joint]]
name = "guide"
type = "cylindrical"
bodies = ["rod", "sleeve"]
at = [0, 0, 0]
axis = [-0.66, 1.05, -0.64]
[dynamics]
gravity = [12, -15, 3]
duration = 3
tolerance = 1e-8
[[spring]]
bodies = ["ground", "sleeve"]
point_i = [0, 0, 0]
point_j = [0.1, 0, -0.1]
stiffness = 194
)");
    const auto ran = [&](const std::vector<std::string>& options) {
        std::vector<std::string> words{"simulate", file, "--samples", "10", "--format", "json"};
        words.insert(words.end(), options.begin(), options.end());
        return run(words);
    };
    // coordinates that were asked for are not replaced
    const Ran joints = ran({"--coordinates", "joints"});
    CHECK(joints.status == 3);
    CHECK(joints.err.find("'--coordinates bodies' computes them in another way") != std::string::npos);
    const Ran taken = ran({});
    CHECK(taken.status == 0);
    CHECK(taken.err.find("s on, coordinates of the bodies are used") != std::string::npos);
    const Ran bodies = ran({"--coordinates", "bodies"});
    CHECK(bodies.err.find("coordinates of the bodies are used") == std::string::npos);
    const auto rows = nlohmann::json::parse(taken.out)["rows"];
    const auto others = nlohmann::json::parse(bodies.out)["rows"];
    REQUIRE(rows.size() == 11);
    // until then accelerations of the joints were proved to 1e-8; the error grows to 1e-5
    for (std::size_t k = 1; k < 8; ++k) {
        CHECK(rows.back()[k].get<double>() == Approx(others.back()[k].get<double>()).margin(1e-4));
    }
    const auto steps = nlohmann::json::parse(run({"step", file, "--format", "json"}).out)["steps"];
    const auto says = [](const nlohmann::json& step) {
        return step["sentence"].get<std::string>().find("coordinates of the bodies are used") !=
               std::string::npos;
    };
    CHECK(std::ranges::count_if(steps, says) == 1);
}

}  // namespace jw::test
