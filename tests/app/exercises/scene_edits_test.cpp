#include <catch2/catch.hpp>

#include <vector>

#include "lessons/exercise/scene_difference.hpp"
#include "lessons/exercise/scene_edits.hpp"

using namespace jw;

namespace {

const std::string kScene = R"(format = 1   # the version
title = "ä scene"

[[body]]
name = "crank"
rotation = { axis = [0, 0, 1], angle_deg = 30 }  # turned

[[joint]]
name = "A"
axis = [0, 0, 1]     # up

[[joint]]
name = "B"
axis = [
  1, 0,
  0]

[[expect]]
rank = 3

[motion]
to_s = 2
)";

std::string after(const std::vector<SceneEdit>& edits) {
    const EditedScene edited = with_edits(kScene, edits);
    CAPTURE(edited.problem);
    REQUIRE(edited.problem.empty());
    return edited.text;
}

}  // namespace

TEST_CASE("A change of a scene leaves everything else as it was, comments too", "[exercises]") {
    CHECK(after({{"joint.A.axis", "[1, 2, 3]"}}).find("axis = [1, 2, 3]     # up\n") != std::string::npos);
    CHECK(
        after({{"joint.B.axis", "[9]"}}).find("name = \"B\"\naxis = [9]\n\n[[expect]]") != std::string::npos);
    CHECK(
        after({{"body.crank.rotation.angle_deg", "45.5"}}).find("angle_deg = 45.5 }  # turned") !=
        std::string::npos);
    CHECK(after({{"joint.A.axis.2", "-1"}}).find("[0, 0, -1]") != std::string::npos);
    CHECK(after({{"joint.1.name", "\"C\""}}).find("name = \"C\"") != std::string::npos);
    CHECK(after({{"motion.to_s", "3"}}).find("to_s = 3\n") != std::string::npos);
    CHECK(
        after({{"joint.A.without", "[\"s x\"]"}}).find("[[joint]]\nwithout = [\"s x\"]\nname = \"A\"") !=
        std::string::npos);
}

TEST_CASE("A table or a key can be taken out", "[exercises]") {
    const std::string without_a = after({{"joint.A", ""}});
    CHECK(without_a.find("\"A\"") == std::string::npos);
    CHECK(without_a.find("\"B\"") != std::string::npos);
    CHECK(value_in(without_a, "joint.0.name") == value_in(kScene, "joint.B.name"));
    CHECK(value_in(after({{"joint.A.axis", ""}}), "joint.A.axis").empty());
    const std::string silent = without_tables(kScene, {"expect"});
    CHECK(silent.find("rank = 3") == std::string::npos);
    CHECK(value_in(silent, "motion.to_s") == "2");
}

TEST_CASE("Texts are taken out in every language, and nothing else", "[exercises]") {
    const std::string scene = R"(format = 1
title = "T"
text = """
The rank is 16.
"""
summary = "16"
[zh-Hant]
title = "T2"
text = "16"

[[joint]]
name = "A"
text = '''
Rank 5.
'''
zh-Hant.text = "5"
axis = [0, 0, 1]  # up

[[driver]]
text = "5"
name = "text"
)";
    CHECK(
        without_texts(scene) ==
        "format = 1\ntitle = \"T\"\n[zh-Hant]\ntitle = \"T2\"\n\n[[joint]]\nname = \"A\"\n"
        "axis = [0, 0, 1]  # up\n\n[[driver]]\nname = \"text\"\n");
    CHECK(without_texts(kScene) == kScene);
}

TEST_CASE("What is not there cannot be changed", "[exercises]") {
    for (const char* key : {"joint.C.axis", "joint.A.axis.7", "nothing", "body.crank.rotation.x.y", ""}) {
        CAPTURE(key);
        const std::vector<SceneEdit> edits{{key, "1"}};
        const EditedScene edited = with_edits(kScene, edits);
        CHECK_FALSE(edited.problem.empty());
        CHECK(edited.text == kScene);
    }
}

TEST_CASE("Differences of scenes are what changes the mechanism", "[exercises]") {
    const SceneDifference none = difference_of(kScene, "# other comment\n" + kScene);
    CHECK(none.count() == 0);
    const SceneDifference axis = difference_of(kScene, after({{"joint.A.axis", "[1, 0, 0]"}}));
    REQUIRE(axis.changed.size() == 1);
    CHECK(axis.changed.front() == "joint.A.axis");
    CHECK(difference_of(kScene, after({{"joint.A", ""}})).removed == std::vector<std::string>{"joint.A"});
    CHECK(difference_of(after({{"joint.A", ""}}), kScene).added == std::vector<std::string>{"joint.A"});
    const std::string without_joints = without_tables(kScene, {"joint"});
    CHECK(difference_of(kScene, without_joints).removed == std::vector<std::string>{"joint.A", "joint.B"});
    CHECK(difference_of(kScene, after({{"joint.A.axis", "[0.0, 0.0, 1.0]"}})).count() == 0);
    CHECK(difference_of(kScene, after({{"title", "\"other\""}})).count() == 0);
}
