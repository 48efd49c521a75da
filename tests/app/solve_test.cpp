#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace jw::test {
namespace {

std::vector<std::string> split(const std::string& line, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(line);
    for (std::string part; std::getline(stream, part, separator);) { parts.push_back(part); }
    return parts;
}

/// Text of a row of CSV, from 0 on, under a name.
std::string cell(const Ran& ran, int row, const std::string& name) {
    const std::vector<std::string> lines = split(ran.out, '\n');
    const std::vector<std::string> header = split(lines.at(0), ',');
    const auto column = std::ranges::find(header, name) - header.begin();
    return split(lines.at(static_cast<std::size_t>(row) + 1), ',').at(static_cast<std::size_t>(column));
}

/// A free sphere on a ball joint, started with a spin, nothing driven.
constexpr const char* kUndriven = R"(format = 1
title = "Not driven"
[[body]]
name = "top"
omega_local_rad_per_s = [0, 0, 2]
[[joint]]
name = "ball"
type = "spherical"
bodies = ["ground", "top"]
at = [0, 0, 0]
)";

}  // namespace

TEST_CASE("CSV of a turning crank is the closed form to the last digits", "[app][solve]") {
    const Folder folder;
    const std::string file = folder.file("crank.toml", kCrank);
    const Ran ran = run({"solve", file, "--analysis", "acceleration", "--to", "1", "--step", "0.125"});
    REQUIRE(ran.status == 0);
    const std::vector<std::string> lines = split(ran.out, '\n');
    REQUIRE(lines.size() == 10);
    const std::vector<std::string> header = split(lines[0], ',');
    CHECK(header.front() == "time_s");
    CHECK(header.back() == "change_point");
    const auto column = [&](const std::string& name) {
        const auto found = std::find(header.begin(), header.end(), name);
        INFO(name);
        REQUIRE(found != header.end());
        return static_cast<std::size_t>(found - header.begin());
    };
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const std::vector<std::string> row = split(lines[k], ',');
        const double t = std::stod(row[0]);
        const double half = 0.25 * std::numbers::pi * t;  // half of 90 deg/s t
        CHECK(t == 0.125 * static_cast<double>(k - 1));
        // Newton stops at 1e-13 of the equations
        CHECK(std::abs(std::stod(row[column("crank.e0")]) - std::cos(half)) < 1e-13);
        CHECK(std::abs(std::stod(row[column("crank.e3")]) - std::sin(half)) < 1e-13);
        CHECK(std::abs(std::stod(row[column("crank.omega_local.z")]) - 0.5 * std::numbers::pi) < 1e-13);
        CHECK(std::abs(std::stod(row[column("crank.omega_local_dot.z")])) < 1e-13);
        CHECK(row[column("unique")] == "1");
        CHECK(row[column("consistent")] == "1");
    }
}

TEST_CASE("the last time of a sweep is the one asked for", "[app][solve]") {
    const Folder folder;
    const std::string file = folder.file("crank.toml", kCrank);
    const Ran ran = run({"solve", file, "--from", "0", "--to", "1", "--step", "0.3", "--format", "json"});
    const auto json = nlohmann::json::parse(ran.out);
    REQUIRE(json["rows"].size() == 5);
    CHECK(json["rows"][4]["values"][0] == 1.0);
    CHECK(json["failure"].is_null());
    CHECK(json["columns"].size() == json["rows"][0]["values"].size());
}

TEST_CASE("every row of solve says what its answers miss", "[app][solve]") {
    const Ran ran =
        run({"solve", lesson_path("loops/four-bar.toml"), "--analysis", "acceleration", "--format", "json"});
    REQUIRE(ran.status == 0);
    CHECK(ran.err.find("warning") == std::string::npos);
    const nlohmann::json j = nlohmann::json::parse(ran.out);
    REQUIRE(j["rows"].size() > 1);
    for (const auto& row : j["rows"]) {
        for (const char* key : {"position_residual", "velocity_residual", "acceleration_residual"}) {
            CAPTURE(key, row.dump());
            CHECK(row[key]["value"] <= row[key]["bound"]);
            CHECK(row[key]["bound"] < 1e-9);  // 1e4 roundings of numbers up to some hundreds
        }
    }
}

TEST_CASE("an under-driven scene says that its velocities are not unique", "[app][solve]") {
    const Folder folder;
    const std::string file = folder.file("undriven.toml", kUndriven);
    const Ran ran =
        run({"solve", file, "--analysis", "velocity", "--to", "0.5", "--step", "0.5", "--format", "json"});
    REQUIRE(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    CHECK(json["rows"][0]["unique"] == false);
    CHECK(json["rows"][0]["consistent"] == true);
    CHECK(ran.err.find("not everything is driven") != std::string::npos);
    // the solution nearest to the velocities before: the spin goes on
    const auto& values = json["rows"][1]["values"];
    CHECK(std::abs(values[13].get<double>() - 2.0) < 1e-12);
}

TEST_CASE("a lesson that only forces move says that they play no part here", "[app][solve]") {
    const Ran ran = run({"solve", lesson_path("dynamics/simple-pendulum.toml"), "--to", "0"});
    CHECK(ran.status == 0);
    CHECK(ran.err.find("jointwise simulate") != std::string::npos);
    const Ran driven = run({"solve", lesson_path("loops/four-bar.toml"), "--to", "0"});
    CHECK(driven.err.find("jointwise simulate") == std::string::npos);
}

TEST_CASE("rows that contradict each other are reported, never hidden", "[app][solve]") {
    const Folder folder;
    // a second driver of the same angle with another speed: at t = 0 both agree on the pose, not on its rate
    const std::string file = folder.file(
        "contradiction.toml", std::string(kCrank) +
                                  "[[driver]]\nname = \"other\"\njoint = \"pivot\"\nquantity = \"angle\"\n"
                                  "polynomial_deg = [0, 60]\n");
    const Ran ran = run({"solve", file, "--analysis", "velocity", "--to", "0", "--format", "json"});
    CHECK(ran.status == 0);
    CHECK(nlohmann::json::parse(ran.out)["rows"][0]["consistent"] == false);
    CHECK(ran.err.find("equations contradict each other") != std::string::npos);
    // later not even a pose exists: the rows found before are kept, and the reason is printed
    const Ran later = run({"solve", file, "--to", "1", "--step", "0.5"});
    CHECK(later.status == 3);
    CHECK(later.out.find("\n0,") != std::string::npos);
    CHECK_FALSE(later.err.empty());
}

TEST_CASE("solve names both drivers that contradict each other, when, and by how much", "[app][solve]") {
    const auto with_second = [](const char* function) {
        return std::string(kCrank) +
               "[[driver]]\nname = \"other\"\njoint = \"pivot\"\nquantity = \"angle\"\npolynomial_deg = " +
               function + "\n";
    };
    const Folder folder;
    struct Case {
        const char* function;
        const char* said;
    };
    // the crank is driven with 90 deg/s from 0: at first the angles differ by less than Newton's tolerance
    for (const Case& c :
         {Case{"[0, 91]", "other asks for 9.1°, but"}, Case{"[0, 90, 1]", "contradict each other at t = "},
          Case{"[5, 90]", "other asks for 5°, but"}}) {
        CAPTURE(c.function);
        const std::string file = folder.file("two.toml", with_second(c.function));
        const Ran ran = run({"solve", file, "--to", "0.5", "--step", "0.1"});
        CHECK(ran.status == 3);
        INFO(ran.err);
        CHECK(ran.err.find("contradict each other at t = ") != std::string::npos);
        CHECK(ran.err.find(c.said) != std::string::npos);
        CHECK(ran.err.find("lengths") == std::string::npos);
    }
    const std::string file = folder.file("two.toml", with_second("[0, 91]"));
    const Ran ran = run({"solve", file, "--analysis", "velocity", "--to", "0.5", "--step", "0.1"});
    INFO(ran.err);
    CHECK(ran.err.find("requires another rate: 91 deg/s instead of 90 deg/s") != std::string::npos);
}

TEST_CASE("An angle has the same turns in every command and claim", "[app][solve]") {
    const Folder folder;
    const auto claimed = [](const std::string& at, const std::string& degrees) {
        return "[[expect]]\nquantity = \"gamma.angle\"\n" + at + "\nvalue_deg = " + degrees +
               "\ntolerance_deg = 1e-6\n";
    };
    const std::string hinge = R"(format = 1
title = "Three turns"
[[body]]
name = "module"
mass = 1
inertia = [1, 1, 1]
[[joint]]
name = "gamma"
type = "revolute"
bodies = ["ground", "module"]
at = [0, 0, 0]
axis = [0, 0, 1]
[[driver]]
name = "bend"
joint = "gamma"
quantity = "angle"
step = { from_deg = 0, to_deg = 1080, start_s = 0, end_s = 6 }
)";
    for (const std::string motion : {"[motion]\nto_s = 8\nsteps = 1\n", "[dynamics]\nduration = 8\n"}) {
        CAPTURE(motion);
        const bool driven = motion[1] == 'm';
        const std::string file = folder.file("turns.toml", hinge + motion + claimed("at_s = 8", "1080"));
        REQUIRE(run({"check", file}).status == 0);
        const Ran table = driven ? run({"solve", file, "--quantities", "gamma.angle"})
                                 : run({"simulate", file, "--samples", "1", "--quantities", "gamma.angle"});
        const std::vector<std::string> lines = split(table.out, '\n');
        const std::vector<std::string> header = split(lines.front(), ',');
        const auto column = std::ranges::find(header, "gamma.angle") - header.begin();
        const std::string last = split(lines.back(), ',')[static_cast<std::size_t>(column)];
        CHECK(std::stod(last) == Approx(6.0 * std::numbers::pi).epsilon(1e-9));
        const auto steps = nlohmann::json::parse(run({"step", file, "--format", "json"}).out)["steps"];
        CHECK(steps.back()["quantities"][0]["value"] == Approx(1080.0).epsilon(1e-9));
        // after a motion 0 is another angle; without a motion 360 deg is the same pose
        const std::string wrong = folder.file("wrong.toml", hinge + motion + claimed("at_s = 8", "0"));
        CHECK(run({"check", wrong}).status == 1);
        const std::string pose = folder.file("pose.toml", hinge + motion + claimed("as_given = true", "360"));
        CHECK(run({"check", pose}).status == 0);
    }
}

TEST_CASE("solve says once for each change point that it is passed along the tangent", "[app][solve]") {
    const std::string file = lesson_path("loops/parallelogram.toml");
    // change points at 1.5 s and 3.5 s: at a time of the table, between two times, and not reached
    const auto said = [&](const std::string& from, const std::string& to, const std::string& step) {
        const Ran ran = run({"solve", file, "--from", from, "--to", to, "--step", step});
        REQUIRE(ran.status == 0);
        std::vector<std::string> warnings;
        for (const std::string& line : split(ran.err, '\n')) {
            if (line.find("passes a change point") != std::string::npos) { warnings.push_back(line); }
        }
        return warnings;
    };
    CHECK(said("0", "1.4", "0.1").empty());
    for (const std::string step : {"0.05", "0.7"}) {
        CAPTURE(step);
        const std::vector<std::string> both = said("0", "4", step);
        REQUIRE(both.size() == 2);
        CHECK_THAT(both[0], Catch::StartsWith("jointwise: warning: at t = 1.5 s the motion passes"));
        CHECK_THAT(both[1], Catch::StartsWith("jointwise: warning: at t = 3.5 s the motion passes"));
    }
}

TEST_CASE("A dead centre is a change point in solve as in check", "[app][solve]") {
    const Folder folder;
    const auto slider_crank = [&](const std::string& x) {
        return folder.file(
            "dead.toml",
            "format = 1\ntitle = \"Dead centre\"\n[[body]]\nname = \"crank\"\n[[body]]\nname = \"rod\"\n"
            "position = [0.5, 0, 0]\n[[body]]\nname = \"slider\"\nposition = [1.75, 0, 0]\n"
            "[[joint]]\nname = \"A\"\ntype = \"revolute\"\nbodies = [\"ground\", \"crank\"]\nat = [0, 0, "
            "0]\naxis = [0, 0, 1]\n"
            "[[joint]]\nname = \"B\"\ntype = \"revolute\"\nbodies = [\"crank\", \"rod\"]\nat = [0.5, 0, 0]\n"
            "axis = [0, 0, 1]\n"
            "[[joint]]\nname = \"C\"\ntype = \"revolute\"\nbodies = [\"rod\", \"slider\"]\nat = [1.75, 0, "
            "0]\naxis = [0, 0, 1]\n"
            "[[joint]]\nname = \"D\"\ntype = \"prismatic\"\nbodies = [\"ground\", \"slider\"]\n"
            "at = [1.75, 0, 0]\naxis = [1, 0, 0]\n"
            "[[driver]]\nname = \"s\"\nquantity = \"coordinate\"\nbody = \"slider\"\ncoordinate = \"x\"\n"
            "polynomial = [" +
                x +
                ", 0]\n[motion]\nto_s = 0.001\nsteps = 1\n[[expect]]\nchange_point = true\n"
                "[[expect]]\nat_s = 0.001\nchange_point = true\n");
    };
    for (const std::string x : {"1.75", "1.6"}) {
        CAPTURE(x);
        const std::string file = slider_crank(x);
        const bool is_dead = x == "1.75";
        const std::vector<std::string> lines = split(run({"solve", file}).out, '\n');
        for (std::size_t k = 1; k < lines.size(); ++k) {
            CHECK(split(lines[k], ',').back() == (is_dead ? "1" : "0"));
        }
        CHECK(run({"check", file}).status == (is_dead ? 0 : 1));
    }
}

TEST_CASE("Reactions of a driven motion are those without the joints that were taken out", "[app][solve]") {
    const Folder folder;
    const std::string file = folder.file("door.toml", R"(format = 1
title = "Door on two hinges"
[[body]]
name = "door"
position = [0.4, 0, 0]
mass = 10
inertia = [1, 1, 1]
[[joint]]
name = "low"
type = "revolute"
bodies = ["ground", "door"]
at = [0, 0, -0.5]
axis = [0, 0, 1]
[[joint]]
name = "high"
type = "revolute"
bodies = ["ground", "door"]
at = [0, 0, 0.5]
axis = [0, 0, 1]
[[driver]]
name = "push"
quantity = "angle"
joint = "low"
polynomial_rad = [0, 1]
[dynamics]
gravity = [0, 0, -9.81]
duration = 1
)");
    const auto reaction = [&](const std::vector<std::string>& experiment) {
        std::vector<std::string> arguments{"solve", file, "--to", "0", "--quantities", "low.force.z"};
        arguments.insert(arguments.end(), experiment.begin(), experiment.end());
        const Ran ran = run(arguments);
        REQUIRE(ran.status == 0);
        return cell(ran, 0, "low.force.z");
    };
    // two hinges share the weight, and the equations do not determine how
    CHECK(reaction({}).empty());
    CHECK(std::stod(reaction({"--try", "take out high"})) == Approx(98.1));
}

TEST_CASE("A spring about a driven joint is twisted by whole turns, too", "[app][solve]") {
    const Folder folder;
    const auto lesson = [](const std::string& type, const std::string& more) {
        return R"(format = 1
title = "Wound up"
[[body]]
name = "drum"
mass = 2
inertia = [0.1, 0.1, 0.1]
[[joint]]
name = "axle"
type = ")" + type +
               R"("
bodies = ["ground", "drum"]
at = [0, 0, 0]
axis = [0, 0, 1]
)" + more + R"(
[[driver]]
name = "motor"
joint = "axle"
quantity = "angle"
polynomial_deg = [0, 90]
[motion]
to_s = 24
[dynamics]
duration = 1
[[rotational_spring]]
joint = "axle"
stiffness = 3
free_angle_deg = 40
)";
    };
    const std::string rail =
        "[[driver]]\nname = \"rail\"\njoint = \"axle\"\nquantity = \"displacement\"\npolynomial = [0]";
    for (const auto& [type, more] :
         {std::pair<std::string, std::string>("revolute", ""),
          {"cylindrical", rail},
          {"screw", "pitch = 0.01"}}) {
        CAPTURE(type);
        const std::string file = folder.file(type + ".toml", lesson(type, more));
        const Ran ran = run(
            {"solve", file, "--from", "0", "--to", "24", "--step", "8", "--quantities",
             "energy.potential,motor.effort"});
        REQUIRE(ran.status == 0);
        for (int k = 0; k < 4; ++k) {
            // 3 N m/rad, 90 deg/s, and 40 deg without torque
            const double twist = (720.0 * k - 40.0) * std::numbers::pi / 180.0;
            CHECK(std::stod(cell(ran, k, "motor.effort")) == Approx(3.0 * twist));
            CHECK(std::stod(cell(ran, k, "energy.potential")) == Approx(1.5 * twist * twist));
        }
        const std::string claim =
            "[[expect]]\nat_s = 4\nof = \"motion\"\nquantity = \"motor.effort\"\nvalue = "
            "16.7551608191456\ntolerance = 1e-9\n";
        CHECK(run({"check", folder.file("claim.toml", lesson(type, more) + claim)}).status == 0);
    }
}

}  // namespace jw::test
