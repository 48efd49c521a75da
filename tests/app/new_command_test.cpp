#include <catch2/catch.hpp>

#include "lessons/read/reader.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

TEST_CASE("new writes a lesson whose claims hold, with a title made from its name", "[app][new]") {
    const Folder folder;
    const std::string file = folder.path("slider-crank_2.toml");
    const Ran ran = run({"new", folder.path("slider-crank_2")});
    CHECK(ran.status == 0);
    CHECK(ran.out.empty());
    CHECK_THAT(ran.err, Catch::StartsWith(file + " is written; "));
    const ReadResult read = read_lesson_file(file);
    REQUIRE(read.lesson);
    INFO(read.report());
    CHECK(read.diagnostics.empty());
    CHECK(read.lesson->title == "Slider crank 2");
    CHECK(read.lesson->mechanism.bodies.size() == 3);  // with the ground
    CHECK(read.lesson->mechanism.joints.size() == 1);
    CHECK(read.lesson->mechanism.drivers.size() == 1);
    const Ran checked = run({"check", file, "--require-claims"});
    INFO(checked.out);
    CHECK(checked.status == 0);
    CHECK(run({"step", file}).status == 0);
}

TEST_CASE(
    "new --exercise writes a lesson with an exercise that is sound, and from which a sheet is made",
    "[app][new]") {
    const Folder folder;
    REQUIRE(run({"new", folder.path("mine"), "--exercise"}).status == 0);
    const std::string file = folder.path("mine.toml");
    const Ran checked = run({"check", file});
    INFO(checked.out);
    CHECK(checked.status == 0);
    CHECK_THAT(checked.out, Catch::Contains("exercise tip"));
    const std::string key = folder.file("key.toml", "format = 1\nsecret = \"a long secret\"\n");
    const Ran sheet = run(
        {"sheet", file, "--student", "ann", "--key", key, "--out", folder.path("sheets"), "--no-figures"});
    INFO(sheet.err);
    CHECK(sheet.status == 0);
    CHECK_THAT(bytes_of(folder.path("sheets/ann/sheet.md")), Catch::Contains("Where is the tip?"));
}

TEST_CASE("new never overwrites a file, nor follows a link", "[app][new]") {
    const Folder folder;
    const std::string file = folder.file("mine.toml", "mine");
    std::filesystem::create_symlink("nowhere", folder.path("link.toml"));
    for (const char* const name : {"mine", "mine.toml", "link"}) {
        const Ran ran = run({"new", folder.path(name)});
        CHECK(ran.status == 2);
        CHECK_THAT(ran.err, Catch::Contains("already exists and is not changed; expected another name"));
    }
    CHECK(bytes_of(file) == "mine");
    CHECK_FALSE(std::filesystem::exists(folder.path("nowhere")));
}

TEST_CASE("new refuses names that cannot be a lesson's, and writes nothing", "[app][new]") {
    const Folder folder;
    for (const std::string name :
         {"course", "course.toml", "x/", ".toml", "no-folder/x", "bad\xFF", "a\x01"}) {
        CAPTURE(name);
        const Ran ran = run({"new", folder.path() + '/' + name});
        CHECK(ran.status == 2);
        CHECK_THAT(ran.err, Catch::StartsWith("jointwise: error: "));
    }
    CHECK(run({"new", ""}).status == 2);
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("new takes titles with quotes and letters of any language", "[app][new]") {
    const Folder folder;
    for (const std::string name : {"über \"das\" Gelenk", "a\\b", "ground's"}) {
        CAPTURE(name);
        REQUIRE(run({"new", folder.path(name)}).status == 0);
        const ReadResult read = read_lesson_file(folder.path(name + ".toml"));
        REQUIRE(read.lesson);
        CHECK(read.lesson->title.substr(1) == name.substr(1));
    }
}

}  // namespace jw::test
