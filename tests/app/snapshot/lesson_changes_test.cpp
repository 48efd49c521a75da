#include <catch2/catch.hpp>

#include "app/snapshot/explanation.hpp"
#include "tests/app/program.hpp"

namespace jw::snapshot {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

std::vector<std::string> changes(const std::string& from, const std::string& to) {
    const std::string before = test::bytes_of(test::lesson_path("loops/four-bar.toml"));
    return lesson_changes(before, replaced(before, from, to));
}

}  // namespace

TEST_CASE("a change of a lesson is one line with its amount", "[snapshot]") {
    CHECK(
        changes("radius = 0.028", "radius = 0.029") ==
        std::vector<std::string>{
            "radius of crank: 1 mm larger (body.crank.shape.0.rod.radius, 0.028 → 0.029)"});
    CHECK(
        changes("angle_deg = 48", "angle_deg = 45") ==
        std::vector<std::string>{
            "angle_deg of crank: 3 deg smaller (body.crank.rotation.angle_deg, 48 → 45)"});
    CHECK(
        changes("position = [-0.48, -0.03, 0.38]", "position = [-0.48, -0.03, 0.68]") ==
        std::vector<std::string>{
            "position of crank: z 0.3 m larger (body.crank.position, [-0.48, -0.03, 0.38] → [-0.48, -0.03, "
            "0.68])"});
    CHECK(
        changes("title = \"A four-bar of four revolutes\"", "title = \"Four bars\"") ==
        std::vector<std::string>{"title: 'A four-bar of four revolutes' → 'Four bars'"});
    CHECK(
        changes("colour = \"vermilion\"", "colour = \"blue\"") ==
        std::vector<std::string>{"colour of crank: 'vermilion' → 'blue'"});
}

TEST_CASE("a changed load is explained with its body and its unit", "[snapshot]") {
    const std::string before =
        "[[force]]\nbody = 'rod'\nforce = [0, 0, -5]\n"
        "[[force]]\nbody = 'crank'\ndirection = [0, 0, 1]\npolynomial = [2, 3]\n"
        "step = [{ from = 1, to = 2, end_s = 1 }]\n"
        "[[torque]]\nbody = 'rod'\ntorque = [0.5, 0, 0]\nharmonics = [{ amplitude = 1, frequency_hz = 2 }]\n"
        "[[spring]]\nstiffness = 100\n[dynamics]\ngravity = [0, 0, -9.5]\n";
    const auto line = [&](const std::string& from, const std::string& to) {
        return lesson_changes(before, replaced(before, from, to)).at(0);
    };
    CHECK(
        line("[0, 0, -5]", "[0, 0, -4]") ==
        "force on rod: z 1 N larger (force.0.force, [0, 0, -5] → [0, 0, -4])");
    CHECK(
        line("[2, 3]", "[3, 2]") ==
        "polynomial of force on crank: number 1 1 N larger, number 2 1 N/s smaller "
        "(force.1.polynomial, [2, 3] → [3, 2])");
    CHECK(line("from = 1", "from = 1.05").starts_with("from of force on crank: 0.05 N larger"));
    CHECK(line("[0.5, 0, 0]", "[0, 0, 0]").starts_with("torque on rod: x 0.5 N m smaller"));
    // a factor of the vector
    CHECK(line("amplitude = 1", "amplitude = 3").starts_with("amplitude of torque on rod: 2 larger"));
    CHECK(line("stiffness = 100", "stiffness = 101").starts_with("stiffness of spring 1: 1 N/m larger"));
    CHECK(line("-9.5]", "-1.5]").starts_with("gravity of dynamics: z 8 m/s² larger"));
}

TEST_CASE("the camera comes behind what it looks at", "[snapshot]") {
    const std::string body = "[[body]]\nname = \"a\"\nmass = 1\n";
    const std::string before = body + "[camera]\ndistance = 2\n";
    const std::string now = "title = \"the camera. of\"\n" + replaced(body, "mass = 1", "mass = 2");
    const std::vector<std::string> lines = lesson_changes(before, now);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "title: added");
    CHECK(lines[1].starts_with("mass of a: 1 kg larger"));
    CHECK(lines[2].starts_with("camera"));
}

TEST_CASE("a change late in a long text is shown", "[snapshot]") {
    CHECK(
        changes("between 78 and 143 deg. Three", "between 79 and 143 deg. Three") ==
        std::vector<std::string>{
            "text of step 2: ...ker swings between 78 and 143 deg. Three equations stay redu... → ...ker "
            "swings between 79 and 143 deg. Three equations stay redu..."});
}

TEST_CASE("characters are not cut in two", "[snapshot]") {
    // characters of two, three and four bytes, with the change at every place of a longer text
    for (const std::string letter : {"é", "漢", "𝄞"}) {
        for (std::size_t at = 0; at < 60; ++at) {
            std::string text;
            for (std::size_t k = 0; k < 60; ++k) { text += k == at ? "X" : letter; }
            const std::string before = "title = '" + text + "'";
            const std::string line = lesson_changes(before, replaced(before, "X", "Y")).at(0);
            std::size_t begun = 0;  // bytes that their characters still need
            for (const char c : line) {
                const auto byte = static_cast<unsigned char>(c);
                REQUIRE(((byte & 0xC0U) == 0x80U) == (begun > 0));
                begun = byte >= 0xF0U ? 3 : byte >= 0xE0U ? 2 : byte >= 0xC0U ? 1 : begun > 0 ? begun - 1 : 0;
            }
            CHECK(line.find('X') < line.find('Y'));
            CHECK(line.find('Y') != std::string::npos);
        }
    }
}

TEST_CASE("directions have no unit, and choices are not larger or smaller", "[snapshot]") {
    CHECK(
        changes("from = [0.35, -1, 0.3]", "from = [0.36, -1, 0.3]") ==
        std::vector<std::string>{
            "from of camera: x 0.01 larger (camera.from, [0.35, -1, 0.3] → [0.36, -1, 0.3])"});
    CHECK(changes("answer = 2", "answer = 1") == std::vector<std::string>{"answer of question 5: 2 → 1"});
}

TEST_CASE("comments and layout are no changes of a lesson", "[snapshot]") {
    CHECK(changes("# 0.4 m", "# the crank").empty());
    CHECK(changes("colour = \"vermilion\"", "\n\ncolour  =  \"vermilion\"").empty());
}

TEST_CASE(
    "an inserted shape is one change, wherever it stands, and one that is left out another", "[snapshot]") {
    const auto body = [](const std::string& shapes) {
        return "[[body]]\nname = \"crank\"\nshape = [" + shapes + "]\n";
    };
    const std::string rod = "{ rod = { from = [0, 0, 0], to = [1, 0, 0], radius = 0.1 } }";
    const std::string box = "{ box = { size = [1, 1, 1] } }";
    const std::string ball = "{ sphere = { radius = 0.2 } }";
    const std::string two = body(rod + ", " + box);
    using Lines = std::vector<std::string>;
    const auto inserted = [](const std::string& number, const std::string& path) {
        return "shape " + number + " of crank: inserted (body.crank.shape." + path + ")";
    };
    CHECK(lesson_changes(two, body(ball + ", " + rod + ", " + box)) == Lines{inserted("1", "0")});
    CHECK(lesson_changes(two, body(rod + ", " + ball + ", " + box)) == Lines{inserted("2", "1")});
    CHECK(lesson_changes(two, body(rod + ", " + box + ", " + ball)) == Lines{inserted("3", "2")});
    CHECK(
        lesson_changes(body(rod + ", " + ball + ", " + box), two) ==
        Lines{"shape 2 of crank: left out (body.crank.shape.1)"});
    CHECK(
        lesson_changes(two, body(ball + ", " + rod + ", " + ball + ", " + box)) ==
        Lines{inserted("1", "0"), inserted("3", "2")});
    // a changed value beside it is reported on its own
    const std::string thicker = replaced(rod, "0.1", "0.3");
    CHECK(
        lesson_changes(two, body(thicker + ", " + box + ", " + ball)) ==
        Lines{
            inserted("3", "2"), "radius of crank: 0.2 m larger (body.crank.shape.0.rod.radius, 0.1 → 0.3)"});
    CHECK(lesson_changes(two, body(box + ", " + rod)) == Lines{"order of shapes of crank: [1, 2] → [2, 1]"});
}

TEST_CASE("another order of bodies is told as such", "[snapshot]") {
    const std::string frame = "[[body]]\nname = \"frame\"\n";
    const std::string leaf = "[[body]]\nname = \"leaf\"\nmass = 1\n";
    const std::string knob = "[[body]]\nname = \"knob\"\n";
    CHECK(
        lesson_changes(frame + leaf, leaf + frame) ==
        std::vector<std::string>{"order of bodies: frame, leaf → leaf, frame"});
    CHECK(lesson_changes(frame + leaf, knob + frame + leaf) == std::vector<std::string>{"body.knob: added"});
    const std::vector<std::string> both = lesson_changes(frame + leaf, replaced(leaf, "1", "2") + frame);
    REQUIRE(both.size() == 2);
    CHECK(both[1].starts_with("mass of leaf: 1 kg larger"));
}

TEST_CASE("a table that is left out is named", "[snapshot]") {
    const std::string all = std::string(test::kCrank);
    const std::string less = replaced(
        all,
        "[[driver]]\nname = \"drive\"\njoint = \"pivot\"\nquantity = \"angle\"\npolynomial_deg = [0, 90]\n",
        "");
    CHECK(lesson_changes(all, less).front().find("driver") == 0);
    CHECK(lesson_changes(less, all).front().find("added") != std::string::npos);
}

}  // namespace jw::snapshot
