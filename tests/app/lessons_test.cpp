#include <catch2/catch.hpp>

#include <algorithm>

#include "app/session/claims/checks.hpp"
#include "app/session/story/story.hpp"
#include "app/session/view/view.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

TEST_CASE("every shipped lesson reads without a warning and all its claims hold", "[app][lessons]") {
    const auto files = lessons_below(catalogue_folder());
    REQUIRE(files.size() >= 18);
    for (const auto& file : files) {
        const ReadResult read = read_lesson_file(file);
        INFO(file << "\n" << read.report());
        REQUIRE(read.lesson.has_value());
        CHECK(read.diagnostics.empty());
        CHECK_FALSE(read.lesson->title.empty());
        CHECK_FALSE(read.lesson->text.empty());
        CHECK_FALSE(read.lesson->source.empty());
        CHECK(read.lesson->claims.size() >= 3);
        for (const ClaimResult& result : check_claims(*read.lesson)) {
            INFO(
                result.moment << ": " << result.subject << " expected " << result.expected << ", found "
                              << result.found);
            CHECK(result.holds);
        }
    }
}

TEST_CASE(
    "Every lesson of the course asks, proposes what to try and to break, and sums up", "[app][lessons]") {
    for (const auto& file : lessons_below(catalogue_folder())) {
        const ReadResult read = read_lesson_file(file);
        INFO(file);
        REQUIRE(read.lesson.has_value());
        const Lesson& lesson = *read.lesson;
        CHECK_FALSE(lesson.questions.empty());
        // `check` proves that a trial does what it says
        const auto breaking = std::ranges::count_if(lesson.trials, &Trial::breaks);
        CHECK(std::ssize(lesson.trials) > breaking);
        // a body without joints has no equations that can be broken
        CHECK((breaking > 0 || lesson.mechanism.joints.empty()));
        // two lines, with a line feed between them
        const std::string& summary = lesson.summary.own();
        CHECK(std::ranges::count(summary, '\n') == 1);
    }
}

TEST_CASE("every view of every shipped lesson has its words, and its numbers agree", "[app][lessons]") {
    for (const auto& file : lessons_below(catalogue_folder())) {
        const ReadResult read = read_lesson_file(file);
        REQUIRE(read.lesson.has_value());
        const Story story(*read.lesson);
        for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
            const View view = view_of(story, k);
            INFO(file << " step " << k << ": " << view.sentence);
            CHECK_FALSE(view.title.empty());
            CHECK_FALSE(view.sentence.empty());
            CHECK(view.sentence.find("nan") == std::string::npos);
            CHECK(view.rank.rank + view.rank.dof == view.rank.columns);
            CHECK(view.matrix.values.rows() == static_cast<Eigen::Index>(view.matrix.rows.size()));
            CHECK(view.matrix.values.cols() == static_cast<Eigen::Index>(view.matrix.columns.size()));
            CHECK(view.matrix.values.allFinite());
            for (const EquationGroup& group : view.equations) {
                for (const EquationRow& row : group.rows) { CHECK(std::isfinite(row.value)); }
            }
        }
    }
}

TEST_CASE("list names every shipped lesson once", "[app][lessons]") {
    const Ran ran = run({"list"});
    CHECK(ran.status == 0);
    for (const auto& file : lessons_below(catalogue_folder())) {
        CHECK(ran.out.find(file.filename().string() + " ") != std::string::npos);
    }
}

TEST_CASE("The table of lessons in docs is the one that list makes", "[app][lessons]") {
    const std::string page = bytes_of(source_path("docs/lessons.md"));
    const std::string begin = "<!-- lessons: written by ./dev scenes -->\n";
    const std::size_t from = page.find(begin) + begin.size();
    const std::size_t to = page.find("<!-- lessons: end -->");
    REQUIRE(from < to);
    REQUIRE(to != std::string::npos);
    INFO("where lessons have changed: ./dev scenes");
    CHECK(page.substr(from, to - from) == run({"list", "--format", "markdown"}).out);
}

TEST_CASE("The lesson and the exercise of README hold", "[app][lessons]") {
    const std::string page = bytes_of(source_path("README.md"));
    const std::string fence = "```toml\n";
    std::string door;
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
        at += fence.size();
        door += page.substr(at, page.find("```", at) - at) + '\n';
    }
    const Folder folder;
    const Ran ran = run({"check", folder.file("door.toml", door)});
    INFO(ran.out << ran.err);
    CHECK(ran.status == 0);
    CHECK(ran.out.find("3 of 3 claims hold") != std::string::npos);
}

TEST_CASE("A bar in a lesson's title does not end its cell of the table", "[app][lessons]") {
    const Folder folder;
    std::string crank = kCrank;
    crank.replace(crank.find("A crank"), 7, "One | two");
    folder.file("crank.toml", crank);
    const Ran ran = run({"list", folder.path(), "--format", "markdown"});
    CHECK(ran.status == 0);
    CHECK_THAT(ran.out, Catch::EndsWith("\n| `crank` | One \\| two |  |\n"));
}

}  // namespace jw::test
