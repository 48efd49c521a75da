#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace jw::test {
namespace {

/// Crank `name` in chapter `chapter`, with a source.
void write_crank(const Folder& folder, const std::string& name, const std::string& source) {
    std::string text = kCrank;
    text.replace(text.find("A crank"), 7, "Crank " + name);
    text.insert(text.find("[[body]]"), "chapter = \"cranks\"\nsource = \"" + source + "\"\n");
    folder.file(name + ".toml", text);
}

}  // namespace

TEST_CASE("list shows the lessons that have all words, and slides by number", "[app][list]") {
    const Folder folder;
    write_crank(folder, "five", "slide 5");
    write_crank(folder, "range", "slides 4-6");
    write_crank(folder, "fifteen", "slides 15, 25");
    const auto titles = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"list", folder.path()});
        words.insert(words.end(), {"--format", "json"});
        const Ran ran = run(words);
        CHECK(ran.status == 0);
        std::vector<std::string> found;
        const nlohmann::json json = nlohmann::json::parse(ran.out);
        for (const auto& lesson : json["lessons"]) { found.push_back(lesson["title"]); }
        return found;
    };
    using Titles = std::vector<std::string>;
    CHECK(titles({}) == Titles{"Crank fifteen", "Crank five", "Crank range"});
    CHECK(titles({"slide", "5"}) == Titles{"Crank five", "Crank range"});
    CHECK(titles({"slide 5", "REVOLUTE", "five"}) == Titles{"Crank five"});
    CHECK(titles({"slides", "14-16"}) == Titles{"Crank fifteen"});
}

TEST_CASE("list that finds nothing is status 1 and says for which words", "[app][list]") {
    const Folder folder;
    write_crank(folder, "five", "slide 5");
    const Ran ran = run({"list", folder.path(), "slide", "6"});
    CHECK(ran.status == 1);
    CHECK(ran.out.empty());
    CHECK(ran.err == "jointwise: no lesson has all of these words: slide 6\n");
    const Ran json = run({"list", folder.path(), "slide", "6", "--format", "json"});
    CHECK(json.status == 1);
    CHECK(nlohmann::json::parse(json.out)["lessons"].empty());
    // an argument that looks like a path is not a word to search for
    CHECK(run({"list", folder.path("nowhere")}).status == 2);
}

TEST_CASE("list searches the shipped lessons where no folder is named", "[app][list]") {
    const Ran ran = run({"list", "bennett", "slide", "8"});
    CHECK(ran.status == 0);
    CHECK_THAT(ran.out, Catch::Contains("bennett.toml") && !Catch::Contains("rssr.toml"));
}

TEST_CASE("The JSON of list has the chapters of the course and the joints of each lesson", "[app][list]") {
    const Ran ran = run({"list", "--format", "json"});
    const nlohmann::json json = nlohmann::json::parse(ran.out);
    CHECK(json["format"] == "jointwise list");
    CHECK(json["version"] == 1);
    REQUIRE(json["chapters"].size() >= 8);
    CHECK(json["chapters"][0]["name"] == "vectors");
    CHECK(json["chapters"][1]["needs"] == nlohmann::json{"vectors"});
    const auto four_bar = std::ranges::find_if(json["lessons"], [](const nlohmann::json& lesson) {
        return lesson["file"].get<std::string>().ends_with("loops/four-bar.toml");
    });
    REQUIRE(four_bar != json["lessons"].end());
    CHECK((*four_bar)["chapter"] == "loops");
    CHECK((*four_bar)["joints"] == nlohmann::json{"revolute"});
    const nlohmann::json slides{{{"first", 3}, {"last", 3}}, {{"first", 8}, {"last", 8}}};
    CHECK((*four_bar)["slides"] == slides);
}

TEST_CASE(
    "list counts the exercises of each lesson, those within it and those of files beside", "[app][list]") {
    const Folder folder;
    folder.file(
        "lessons/vectors/frames.toml",
        "format = 1\ntitle = \"F\"\n[[body]]\nname = \"b\"\n[[exercise]]\nname = \"inside\"\n");
    folder.file(
        "exercises/one.toml",
        "format = 1\n[[exercise]]\nname = \"a\"\nlesson = \"vectors/frames\"\n"
        "[[exercise]]\nname = \"b\"\nlesson = \"vectors/other\"\n[[exercise]]\nname = \"c\"\n");
    const Ran text = run({"list", folder.path("lessons")});
    CHECK_THAT(text.out, Catch::Contains("F, 2 exercises"));
    const Ran chapter = run({"list", folder.path("lessons/vectors"), "--format", "json"});
    CHECK(nlohmann::json::parse(chapter.out)["lessons"][0]["exercises"] == 2);
}

TEST_CASE("list and check report a course with mistakes with its place", "[app][list]") {
    const Folder folder;
    write_crank(folder, "five", "slide 5");
    const std::string course = folder.file("course.toml", "format = 1\n[[chapter]]\nname = \"a\"\n");
    for (const Ran& ran : {run({"list", folder.path()}), run({"check", course})}) {
        CHECK(ran.status == 2);
        CHECK_THAT(ran.err, Catch::StartsWith(course + ":2:1: error: chapter 'a' has no 'title'"));
    }
    CHECK_THAT(run({"list", folder.path()}).out, Catch::Contains("five.toml"));
}

}  // namespace jw::test
