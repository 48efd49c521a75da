#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <nlohmann/json.hpp>

#include "app/session/story/dynamics_run.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) { lines.push_back(line); }
    return lines;
}

const std::string kPendulum = lesson_path("dynamics/simple-pendulum.toml");

}  // namespace

TEST_CASE("simulate gives a table whose end is the reference", "[app][dynamics]") {
    const Ran ran =
        run({"simulate", kPendulum, "--tolerance", "1e-10", "--samples", "10", "--format", "json"});
    REQUIRE(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    CHECK(json["rows"].size() == 11);
    const auto& row = json["rows"].back();
    CHECK(row.size() == json["columns"].size());
    CHECK(row[0] == 10.0);
    // benchmarks' A01, at tolerance 1e-10
    CHECK(row[1].get<double>() == Approx(-0.295850422283221).margin(1e-8));
    CHECK(row[2].get<double>() == Approx(-0.955234278925772).margin(1e-8));
    CHECK(json["failure"].is_null());
}

TEST_CASE("simulate moves without the joints and drivers that were taken out", "[app][dynamics]") {
    const auto end_of = [](const std::vector<std::string>& arguments, const std::string& column) {
        const Ran ran = run(arguments);
        INFO(ran.err);
        REQUIRE(ran.status == 0);
        const auto json = nlohmann::json::parse(ran.out);
        const auto& names = json["columns"];
        const auto place = std::ranges::find(names, nlohmann::json(column)) - names.begin();
        return json["rows"].back()[static_cast<std::size_t>(place)].get<double>();
    };
    const std::vector<std::string> how{"--duration", "0.5", "--samples", "1", "--format", "json"};
    const auto simulated = [&](const std::string& lesson, const std::string& experiment) {
        std::vector<std::string> arguments{"simulate", lesson};
        if (!experiment.empty()) { arguments.insert(arguments.end(), {"--try", experiment}); }
        arguments.insert(arguments.end(), how.begin(), how.end());
        return end_of(arguments, "ball.y");
    };
    CHECK(simulated(kPendulum, "take out pin") == Approx(-0.5 * 9.81 * 0.25));
    const Folder folder;
    const std::string driver =
        "\n[[driver]]\nname = \"motor\"\njoint = \"pin\"\nquantity = \"angle\"\n"
        "polynomial_deg = [0, 90]\n";
    const std::string driven = folder.file("driven.toml", bytes_of(kPendulum) + driver);
    CHECK(simulated(driven, "") == Approx(-std::sin(0.25 * std::numbers::pi)));
    // without its motor it is the pendulum again
    const double free = simulated(kPendulum, "");
    CHECK(std::abs(free + std::sin(0.25 * std::numbers::pi)) > 0.1);
    CHECK(simulated(driven, "take out motor") == Approx(free));
}

TEST_CASE(
    "simulate says where the branches of a loop part because it does not quite fit", "[app][dynamics]") {
    const std::string exact = bytes_of(lesson_path("dynamics/four-bar-1.toml"));
    const std::string point = "point_j = [0, -0.5, 0]";
    const std::size_t where = exact.find(point);
    REQUIRE(where != std::string::npos);
    std::string off = exact;
    off.replace(where, point.size(), "point_j = [0, -0.5, 1e-8]");
    const Folder folder;
    const auto ran = [&](const std::string& lesson, const std::string& duration) {
        return run({"simulate", folder.file("loop.toml", lesson), "--duration", duration, "--samples", "4"});
    };
    // in line for the first time after 0.6 s
    CHECK(ran(off, "1").err.find("Branches that should cross") != std::string::npos);
    CHECK(ran(off, "0.3").err.find("Branches that should cross") == std::string::npos);
    CHECK(ran(exact, "1").err.find("Branches that should cross") == std::string::npos);
}

TEST_CASE("simulate says what to do about a loop that does not fit", "[app][dynamics]") {
    const std::string exact = bytes_of(lesson_path("dynamics/four-bar-1.toml"));
    const std::string axis = "axis_j = [0, 0, 1]";
    const std::size_t where = exact.find(axis);
    REQUIRE(where != std::string::npos);
    const Folder folder;
    const auto said_with = [&](const std::string& other) {
        std::string off = exact;
        off.replace(where, axis.size(), other);
        const Ran ran = run({"simulate", folder.file("loop.toml", off), "--duration", "1"});
        CHECK(ran.status == 3);
        CHECK(
            ran.err.find("depend linearly on those of other joints, but contradict them by") !=
            std::string::npos);
        return ran.err;
    };
    CHECK(said_with("axis_j = [0.0001, 0, 1]").find("with all their digits") != std::string::npos);
    CHECK(said_with("axis_j = [0.2, 0, 1]").find("do not fit") != std::string::npos);
}

TEST_CASE("simulate --reactions adds forces and names what is not unique", "[app][dynamics]") {
    const Ran ran = run(
        {"simulate", lesson_path("dynamics/four-bar-1.toml"), "--reactions", "--samples", "2", "--duration",
         "0.1"});
    REQUIRE(ran.status == 0);
    const std::vector<std::string> lines = lines_of(ran.out);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0].find(".force.x") != std::string::npos);
    CHECK(std::ranges::count(lines[0], ',') == std::ranges::count(lines[1], ','));
    CHECK(ran.err.find("is not unique") != std::string::npos);
}

TEST_CASE("simulate --reactions marks every number that other answers share", "[app][dynamics]") {
    const Ran ran = run(
        {"simulate", lesson_path("dynamics/four-bar-1.toml"), "--reactions", "--samples", "2", "--duration",
         "0.1", "--format", "json"});
    REQUIRE(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    const auto columns = json["columns"].get<std::vector<std::string>>();
    const auto column = [&](const std::string& name) {
        const auto found = std::ranges::find(columns, name);
        REQUIRE(found != columns.end());
        return static_cast<std::size_t>(found - columns.begin());
    };
    const std::string joint = json["not_unique"][0];
    for (const auto& row : json["rows"]) {
        REQUIRE(row.size() == columns.size());
        // in the plane of a planar loop everything is determined, across it nothing is
        CHECK(row[column(joint + ".force.unique.x")] == 1.0);
        CHECK(row[column(joint + ".force.unique.y")] == 1.0);
        CHECK(row[column(joint + ".force.unique.z")] == 0.0);
        CHECK(row[column(joint + ".torque.unique.x")] == 0.0);
    }
    // columns that existed before keep their places
    CHECK(column(joint + ".force.unique.x") > column(joint + ".torque.z"));
    CHECK(columns.back().find(".torque.unique.z") != std::string::npos);
}

TEST_CASE("A spring wound up by more than a turn swings as its formula says", "[app][dynamics]") {
    const Folder folder;
    for (const double free_deg : {400.0, -1000.0}) {
        const std::string file = folder.file(
            "wound.toml",
            "format = 1\ntitle = \"t\"\n[[body]]\nname = \"wheel\"\nmass = 1\ninertia = [1, 1, 1.5]\n"
            "[[joint]]\nname = \"hinge\"\ntype = \"revolute\"\nbodies = [\"ground\", \"wheel\"]\nat = [0, 0, "
            "0]\n"
            "axis = [0, 0, 1]\n[dynamics]\nduration = 3\n[[rotational_spring]]\njoint = \"hinge\"\n"
            "stiffness = 6\nfree_angle_deg = " +
                std::to_string(free_deg) + "\n");
        for (const char* method : {"explicit-8", "explicit-5", "implicit-5"}) {
            CAPTURE(free_deg, method);
            const Ran ran = run(
                {"simulate", file, "--method", method, "--tolerance", "1e-10", "--samples", "30", "--format",
                 "json"});
            REQUIRE(ran.status == 0);
            const auto json = nlohmann::json::parse(ran.out);
            const auto columns = json["columns"].get<std::vector<std::string>>();
            const auto column = [&](const char* name) {
                return static_cast<std::size_t>(std::ranges::find(columns, name) - columns.begin());
            };
            const double way = free_deg * std::acos(-1.0) / 180.0;
            const double frequency = 2.0;  // root of 6 / 1.5
            for (const auto& row : json["rows"]) {
                const double t = row[0].get<double>();
                // hundreds of steps with errors of 1e-10, relative to the size of the motion
                const double allowed = 1e-7 * std::abs(way);
                CHECK(
                    row[column("wheel.omega_local.z")].get<double>() ==
                    Approx(way * frequency * std::sin(frequency * t)).margin(allowed));
                CHECK(
                    row[column("energy.potential")].get<double>() ==
                    Approx(3.0 * std::pow(way * std::cos(frequency * t), 2))
                        .margin(20.0 * allowed * std::abs(way)));
            }
        }
    }
}

TEST_CASE("check proves where a motion by forces ends, and finds a wrong digit", "[app][dynamics]") {
    const Ran right = run({"check", kPendulum});
    CHECK(right.status == 0);
    CHECK(right.out.find("holds at 10 s") != std::string::npos);
    CHECK(right.out.find("point_at_end") != std::string::npos);
    std::string text = bytes_of(kPendulum);
    const std::string end = "point_at_end = [-0.29585";
    const std::size_t where = text.find(end);
    REQUIRE(where != std::string::npos);
    text.replace(where, end.size(), "point_at_end = [-0.29586");
    const Folder folder;
    const Ran wrong = run({"check", folder.file("wrong.toml", text)});
    CHECK(wrong.status == 1);
    CHECK(wrong.out.find("FAILS at 10 s") != std::string::npos);
    CHECK(wrong.out.find("off by 1.0e-05") != std::string::npos);
}

TEST_CASE("simulate names every start pose that it moves, however little", "[app][dynamics]") {
    const std::string exact = bytes_of(kPendulum);
    const Folder folder;
    CHECK(run({"simulate", kPendulum, "--duration", "0.1"}).err.find("start poses") == std::string::npos);
    const std::size_t body = exact.find("name = \"ball\"");
    REQUIRE(body != std::string::npos);
    const std::size_t begin = exact.find("position", body);
    REQUIRE(begin != std::string::npos);
    const std::size_t end = exact.find('\n', begin);
    for (const char* position : {"[-1, 0.003, 0]", "[-1.00001, 0, 0]", "[-1.3, 0, 0]"}) {
        CAPTURE(position);
        std::string moved = exact;
        moved.replace(begin, end - begin, std::string("position = ") + position);
        const Ran ran = run({"simulate", folder.file("moved.toml", moved), "--duration", "0.1"});
        CHECK(ran.err.find("start poses do not fit the joints") != std::string::npos);
        CHECK(ran.err.find("body 'ball' begins") != std::string::npos);
    }
}

TEST_CASE("A motion that ends without drivers is not blamed on one", "[app][dynamics]") {
    SimulationFailure failure;
    failure.cause = SimulationFailure::Cause::out_of_reach;
    failure.equation_of = "hinge";
    Mechanism mechanism;
    CHECK(failure_text(failure, {}, mechanism).find("driver") == std::string::npos);
    mechanism.drivers.emplace_back();
    CHECK(failure_text(failure, {}, mechanism).find("a driver leads") != std::string::npos);
}

TEST_CASE("simulate --reactions says what of the forces no reaction explains", "[app][dynamics]") {
    const auto simulated = [](const char* reactions) {
        std::vector<std::string> arguments{
            "simulate", lesson_path("dynamics/four-bar-1.toml"), "--samples", "4", "--format", "json"};
        if (*reactions != 0) { arguments.emplace_back(reactions); }
        const Ran ran = run(arguments);
        REQUIRE(ran.status == 0);
        CHECK(ran.err.find("do not balance") == std::string::npos);
        return nlohmann::json::parse(ran.out);
    };
    const nlohmann::json with = simulated("--reactions");
    CHECK(with["reaction_residual"] <= with["reaction_bound"]);
    CHECK(with["reaction_bound"] < 1e-9);
    CHECK(simulated("")["reaction_residual"].is_null());
}

TEST_CASE("simulate refuses what it cannot do, with status 2 and a way out", "[app][dynamics]") {
    const auto refused = [](std::vector<std::string> arguments, const std::string& word) {
        arguments.insert(arguments.begin(), "simulate");
        const Ran ran = run(arguments);
        INFO(ran.err);
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK(ran.err.find(word) != std::string::npos);
    };
    refused({lesson_path("loops/four-bar.toml")}, "[dynamics]");
    refused({kPendulum, "--method", "magic"}, "--method");
    refused({kPendulum, "--tolerance", "-1"}, "--tolerance");
    refused({kPendulum, "--tolerance", "1e-20"}, "expected 1e-15");
    refused({kPendulum, "--method", "rk4", "--tolerance", "1e-6"}, "expects --step");
    refused({kPendulum, "--step", "0.1"}, "expects --tolerance");
    refused({kPendulum, "--method", "rk4", "--step", "1e-20"}, "ten million");
    refused({kPendulum, "--duration", "0"}, "--duration");
    refused({kPendulum, "--samples", "0"}, "--samples");
    refused({kPendulum, "--samples", "1e9"}, "expected a whole number");
    refused({kPendulum, "--duration", "long"}, "expected a number");
    refused({kPendulum, "--coordinates", "rp", "--method", "implicit-5"}, "coordinate choice");
    refused({kPendulum, "--treatment", "tangent"}, "implicit");
    refused({kPendulum, "--treatment", "none", "--method", "implicit-5"}, "treatment");
}

TEST_CASE(
    "A motion by forces that cannot go on is told as far as it goes, with status 3", "[app][dynamics]") {
    // a motor pulls a pendulum of 1 m beyond its reach
    std::string text = bytes_of(kPendulum);
    text.replace(
        text.find("[dynamics]"), 0,
        "[[driver]]\nname = \"pull\"\nquantity = \"coordinate\"\nbody = \"ball\"\ncoordinate = \"y\"\n"
        "polynomial = [0, 0.5, 1]\n");
    const Folder folder;
    const std::string file = folder.file("pulled.toml", text);
    const Ran ran = run({"step", file, "--format", "json"});
    CHECK(ran.status == 3);
    const auto steps = nlohmann::json::parse(ran.out)["steps"];
    CHECK(steps.back()["title"] == "The motion ends");
    CHECK(steps.back()["failure"].get<std::string>().find("cannot be satisfied there") != std::string::npos);
    CHECK(steps[steps.size() - 2]["failure"].is_null());
    const Ran plotted = run({"plot", file, "--out", folder.path("plot.csv")});
    CHECK(plotted.status == 3);
    CHECK(plotted.err.find("cannot be satisfied there") != std::string::npos);
    // at the start the motor acts along the rod: no acceleration of the ball at rest satisfies it
    text.replace(text.find("coordinate = \"y\""), 16, "coordinate = \"x\"");
    text.replace(text.find("[0, 0.5, 1]"), 11, "[-1, 0, 1]");
    const Ran refused = run({"simulate", folder.file("along.toml", text)});
    CHECK(refused.status == 3);
    CHECK(
        refused.err.find(
            "equations of 'pull' depend linearly on those of other joints or drivers, but contradict their "
            "accelerations") != std::string::npos);
}

TEST_CASE("simulate says which start velocities it could not keep", "[app][dynamics]") {
    const Folder folder;
    std::string text = bytes_of(kPendulum);
    // towards the hinge, which the rod does not allow
    text.replace(
        text.find("mass = 1 "), 9, "omega_local_rad_per_s = [0, 0, 10]\nvelocity = [3, 0, 0]\nmass = 1 ");
    const Ran ran = run({"simulate", folder.file("spun.toml", text), "--duration", "0.1"});
    CHECK(ran.status == 0);
    CHECK(ran.err.find("body 'ball' was given 10 rad/s and begins with") != std::string::npos);
    CHECK(run({"simulate", kPendulum, "--duration", "0.1"}).err.find("note") == std::string::npos);
}

TEST_CASE("simulate says which start rate of a joint it could not keep", "[app][dynamics]") {
    const Folder folder;
    std::string text = bytes_of(lesson_path("dynamics/sled-and-spring.toml"));
    const std::size_t joint = text.find("[[joint]]");
    std::string second = text.substr(joint, text.find("[dynamics]") - joint);
    second.replace(second.find("\"rail\""), 6, "\"other\"");
    second.replace(second.find("displacement_dot = 1 "), 21, "displacement_dot = 2 ");
    text.insert(joint, second);
    const Ran ran = run({"simulate", folder.file("two.toml", text), "--duration", "0.1"});
    CHECK(ran.status == 0);
    INFO(ran.err);
    CHECK(ran.err.find("was given") != std::string::npos);
    CHECK(ran.err.find("m/s and begins with 1.5 m/s, 0.5 m/s off") != std::string::npos);
}

TEST_CASE("Start rates of more than a hundred bodies are refused with a note", "[app][dynamics]") {
    const Folder folder;
    std::string text = "format = 1\ntitle = \"t\"\n";
    for (int k = 0; k < 101; ++k) {
        const std::string name = "sled " + std::to_string(k);
        text += "[[body]]\nname = \"" + name +
                "\"\nmass = 1\ninertia = [1, 1, 1]\n[[joint]]\nname = \"rail " + std::to_string(k) +
                "\"\ntype = \"prismatic\"\nbodies = [\"ground\", \"" + name +
                "\"]\nat = [0, 0, 0]\naxis = [1, 0, 0]\ndisplacement_dot = 1\n";
    }
    const Ran ran =
        run({"simulate", folder.file("many.toml", text + "[dynamics]\nduration = 0.1\n"), "--samples", "1"});
    CHECK(ran.status == 0);
    INFO(ran.err);
    CHECK(
        ran.err.find("start rates of joints are kept in mechanisms of up to 100 moving bodies") !=
        std::string::npos);
}

TEST_CASE("inspect --time shows where masses and forces have led to", "[app][dynamics]") {
    const Ran table = run({"simulate", kPendulum, "--duration", "0.5", "--samples", "1", "--format", "json"});
    const Ran seen = run({"inspect", kPendulum, "--time", "0.5", "--format", "json"});
    REQUIRE(seen.status == 0);
    const auto there = nlohmann::json::parse(table.out)["rows"].back();
    const auto ball = nlohmann::json::parse(seen.out)["bodies"].back();
    // two runs at tolerance 1e-6
    CHECK(ball["r"][0].get<double>() == Approx(there[1].get<double>()).margin(1e-5));
    CHECK(ball["r"][1].get<double>() == Approx(there[2].get<double>()).margin(1e-5));
    CHECK(run({"inspect", kPendulum, "--time", "-1"}).status == 3);
}

TEST_CASE("bench says what a digit costs", "[app][dynamics]") {
    const Ran ran = run({"bench", "simple-pendulum", "--method", "explicit-8", "--format", "json"});
    REQUIRE(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    const auto& points = json["scenes"][0]["runs"][0]["points"];
    REQUIRE(points.size() > 10);
    CHECK(points.front()["position_m"].get<double>() > 1e-4);
    double best = 1.0;
    for (const auto& point : points) { best = std::min(best, point["position_m"].get<double>()); }
    CHECK(best < 1e-10);
    CHECK(points.back()["evaluations"].get<long>() > points.front()["evaluations"].get<long>());
}

TEST_CASE("bench draws one scene as a plot", "[app][dynamics]") {
    const Folder folder;
    const std::string picture = folder.path("plot.png");
    const Ran ran = run({"bench", "simple-pendulum", "--method", "implicit-9", "--picture", picture});
    REQUIRE(ran.status == 0);
    CHECK(bytes_of(picture).size() > 10000);
    CHECK(run({"bench", "simple-pendulum", "andrews", "--picture", picture}).status == 2);
    CHECK(run({"bench", "no-such-scene"}).status == 2);
}

}  // namespace jw::test
