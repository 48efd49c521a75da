#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace jw::test {

TEST_CASE("bench --kinematics finds the same moments in every choice of coordinates and rows", "[app]") {
    const Ran ran = run({"bench", "--kinematics", "four-bar", "parallelogram", "--format", "json"});
    REQUIRE(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    REQUIRE(json["scenes"].size() == 2);
    for (const auto& scene : json["scenes"]) {
        CHECK(scene["runs"].size() == 9);
        for (const auto& run : scene["runs"]) {
            INFO(scene["scene"] << " " << run.dump());
            CHECK(run["missed"] == 0);
        }
    }
    // Newton's tolerance of 1e-13 over the singular values of a four-bar, 0.2 and more
    for (const auto& run : json["scenes"][0]["runs"]) {
        INFO(run.dump());
        CHECK(run["position"].get<double>() < 1e-12);
        CHECK(run["velocity"].get<double>() < 1e-12);
        CHECK(run["acceleration"].get<double>() < 1e-11);
    }
    // the method by which motions are followed iterates down to rounding
    const auto& graph = json["scenes"][0]["runs"].back();
    CHECK(graph["coordinates"] == "graph");
    CHECK(graph["position"].get<double>() < 1e-14);
    CHECK(graph["acceleration"].get<double>() < 1e-13);
}

TEST_CASE("bench --kinematics refuses lessons that no driver moves", "[app]") {
    CHECK(run({"bench", "--kinematics", "simple-pendulum"}).status == 2);
    CHECK(run({"bench", "--kinematics", "no-such-lesson"}).status == 2);
    CHECK(run({"bench", "--kinematics", "--render"}).status == 2);
    CHECK(run({"bench", "--kinematics", "--picture", "x.png"}).status == 2);
    CHECK(run({"bench", "--kinematics", "four-bar", "--format", "markdown"}).status == 2);
    CHECK(run({"bench", "--kinematics", "four-bar", "--format", "csv"}).out.starts_with("scene,"));
}

}  // namespace jw::test
