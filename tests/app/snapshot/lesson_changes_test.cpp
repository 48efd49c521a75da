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

TEST_CASE("comments and layout are no changes of a lesson", "[snapshot]") {
    CHECK(changes("# 0.4 m", "# the crank").empty());
    CHECK(changes("colour = \"vermilion\"", "\n\ncolour  =  \"vermilion\"").empty());
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
