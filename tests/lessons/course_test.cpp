#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

#include "lessons/files/catalogue.hpp"
#include "lessons/files/course.hpp"
#include "lessons/read/reader.hpp"
#include "tests/support/temporary_folder.hpp"

namespace jw::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_below(const fs::path& folder, const fs::path& named_from) {
    std::vector<std::string> names;
    for (const CourseLessons::Entry& entry : course_lessons(folder).lessons) {
        names.push_back(entry.file.lexically_relative(named_from).generic_string());
    }
    return names;
}

constexpr const char* kTwoChapters = R"(format = 1
[[chapter]]
name = "z"
title = "First"
lessons = ["b.toml", "not-there.toml", "a.toml"]
[[chapter]]
name = "m"
title = "Second"
needs = ["z"]
)";

/// A folder of an instructor, with chapters and lessons that the course does not name.
struct School : TemporaryFolder {
    School() {
        for (const char* const name :
             {"z/a.toml", "z/b.toml", "z/0.toml", "m/y.toml", "m/x.toml", "a/1.toml", "0.toml"}) {
            write(name, "format = 1\ntitle = \"t\"\n");
        }
    }
};

}  // namespace

TEST_CASE("Every chapter and lesson that the course names is there", "[lessons][course]") {
    const CourseRead read = read_course_of(catalogue_folder());
    INFO(read.report());
    CHECK(read.diagnostics.empty());
    REQUIRE_FALSE(read.course.chapters.empty());
    for (const Chapter& chapter : read.course.chapters) {
        CAPTURE(chapter.name);
        CHECK_FALSE(chapter.title.empty());
        CHECK_FALSE(chapter.about.empty());
        for (const std::string& lesson : chapter.lessons) {
            CAPTURE(lesson);
            CHECK(fs::is_regular_file(catalogue_folder() / chapter.name / lesson));
        }
    }
}

TEST_CASE("Lessons come in the order of the course, the others behind them", "[lessons][course]") {
    const School school;
    const std::vector<std::string> by_path{"0.toml",   "a/1.toml", "m/x.toml", "m/y.toml",
                                           "z/0.toml", "z/a.toml", "z/b.toml"};
    CHECK(names_below(school.path(), school.path()) == by_path);
    school.write("course.toml", kTwoChapters);
    const std::vector<std::string> by_course{"z/b.toml", "z/a.toml", "z/0.toml", "m/x.toml",
                                             "m/y.toml", "0.toml",   "a/1.toml"};
    CHECK(names_below(school.path(), school.path()) == by_course);
    // names in one chapter, and in a folder around the course
    CHECK(
        names_below(school.path() / "z", school.path()) ==
        std::vector<std::string>{"z/b.toml", "z/a.toml", "z/0.toml"});
    const CourseLessons all = course_lessons(school.path());
    REQUIRE(all.chapters.size() == 2);
    CHECK(all.chapters[0].title == "First");
    CHECK(all.lessons[0].chapter_title == "First");
    CHECK(all.lessons[5].chapter_title.empty());
}

TEST_CASE("A course is found from a folder above it and from the folder one is in", "[lessons][course]") {
    const School school;
    school.write("course.toml", kTwoChapters);
    const TemporaryFolder outer;
    fs::rename(school.path(), outer.path() / "school");
    CHECK(names_below(outer.path(), outer.path() / "school").front() == "z/b.toml");
    const fs::path before = fs::current_path();
    fs::current_path(outer.path() / "school");
    const std::vector<std::string> here = names_below(".", ".");
    fs::current_path(before);
    CHECK(here.front() == "z/b.toml");
}

TEST_CASE("A chapter without a folder is told with its place", "[lessons][course]") {
    const School school;
    const fs::path file = school.write(
        "course.toml", std::string(kTwoChapters) + "[[chapter]]\nname = \"loop\"\ntitle = \"Loops\"\n");
    fs::create_directory(school.path() / "loops");
    const std::string told = course_lessons(school.path()).report;
    CHECK_THAT(
        told, Catch::StartsWith(file.string() + ":11:8: error: there is no folder 'loop' beside this file"));
    CHECK_THAT(told, Catch::Contains("did you mean 'loops'?"));
    CHECK_THAT(read_lesson_file(file).report(), Catch::Contains(":11:8: error: there is no folder 'loop'"));
    // reading one chapter does not ask for the others
    CHECK(course_lessons(school.path() / "z").report.empty());
    CHECK(names_below(school.path() / "z", school.path()).front() == "z/b.toml");
    fs::create_directory(school.path() / "loop");
    CHECK(course_lessons(school.path()).report.empty());
}

TEST_CASE("The joints come in the order of the slides", "[lessons][course]") {
    std::vector<std::string> joints;
    for (const CourseLessons::Entry& entry : course_lessons(catalogue_folder()).lessons) {
        if (entry.folder == "joints") { joints.push_back(entry.file.stem().string()); }
    }
    joints.resize(std::min<std::size_t>(joints.size(), 6));
    CHECK(
        joints ==
        std::vector<std::string>{"spherical", "universal", "revolute", "cylindrical", "prismatic", "screw"});
}

TEST_CASE("A course is no lesson", "[lessons][course]") {
    const School school;
    const fs::path file = school.write("course.toml", kTwoChapters);
    const auto lessons = lessons_below(school.path());
    CHECK(std::ranges::find(lessons, file) == lessons.end());
    const ReadResult read = read_lesson_file(file);
    CHECK_FALSE(read.lesson);
    CHECK(
        read.report() ==
        file.string() + ": error: this is the order of a course; expected a lesson (.toml) [JW804]\n");
    school.write("course.toml", "format = 1\nchapters = 3\n");
    CHECK_THAT(read_lesson_file(file).report(), Catch::Contains(":2:1: error: unknown key 'chapters'"));
}

TEST_CASE(
    "A mistake in a course is told with its place, and the order is then that of paths",
    "[lessons][course]") {
    const std::string head = "format = 1\n[[chapter]]\nname = \"z\"\ntitle = \"Z\"\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "course.toml: error: the file is empty"},
        {"format = 2\n[[chapter]]\nname = \"z\"\ntitle = \"Z\"\n", ":1:10: error: 'format' is 2"},
        {"format = 1\n", ":1:1: error: the course has no 'chapter'; expected at least one [[chapter]]"},
        {"format = 1\n[[chapter]]\ntitle = \"Z\"\n", ":2:1: error: chapter has no 'name'"},
        {head + "titel = \"Z\"\n", ":5:1: error: unknown key 'titel' in chapter 'z'"},
        {head + "needs = [\"m\"]\n",
         ":5:10: error: no chapter 'm' comes before this one; expected an empty list"},
        {head + "lessons = [\"a\"]\n", ":5:12: error: 'a' is not the name of a lesson file"},
        {head + "lessons = [\"../a.toml\"]\n", ":5:12: error: '../a.toml' is not the name of a lesson file"},
        {head + "lessons = [\"a.toml\", \"a.toml\"]\n", ":5:22: error: the lesson 'a.toml' is named twice"},
        {head + "[[chapter]]\nname = \"z\"\ntitle = \"Z\"\n", ":6:8: error: there are two chapters 'z'"},
        {"format = 1\n[[chapter]]\nname = \"a/b\"\ntitle = \"Z\"\n",
         ":3:8: error: 'a/b' is not the name of a folder"},
        {head + "lessons = 3\n", ":5:11: error: 'lessons' is a number"}};
    const School school;
    for (const auto& [text, says] : cases) {
        CAPTURE(text);
        const fs::path file = school.write("course.toml", text);
        const CourseLessons found = course_lessons(school.path());
        CHECK_THAT(found.report, Catch::Contains(says));
        CHECK(found.faulty.size() == 1);
        CHECK(found.lessons.front().file.filename() == "0.toml");
        CHECK(read_course(text, file.string()).course.chapters.empty());
    }
}

}  // namespace jw::test
