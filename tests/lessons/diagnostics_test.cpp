#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "lessons/files/catalogue.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace jw;
using test::TemporaryFolder;

namespace {

struct Case {
    std::string name;
    std::string lesson;
    std::string says;
};

/// Inserts the keys of a mass after the first line of each body, its name.
void give_masses(std::string& lesson) {
    const std::string header = "[[body]]\n";
    for (std::size_t at = lesson.find(header); at != std::string::npos; at = lesson.find(header, at + 1)) {
        lesson.insert(lesson.find('\n', at + header.size()) + 1, "mass = 1\ninertia = [1, 1, 1]\n");
    }
}

/// Cases of wrong_lessons.txt, in its order.
std::vector<Case> wrong_lessons() {
    std::istringstream lines(test::text_of_file("tests/lessons/wrong_lessons.txt"));
    std::vector<Case> cases;
    std::string* into = nullptr;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("=== ")) {
            cases.push_back({line.substr(4), "", ""});
        } else if (line == "--- whole" || line == "--- after the base" || line == "--- with masses") {
            into = &cases.back().lesson;
            if (line != "--- whole") { *into = cases.front().lesson; }
            if (line == "--- with masses") { give_masses(*into); }
        } else if (line == "--- says") {
            into = &cases.back().says;
        } else if (into != nullptr) {
            *into += line + '\n';
        }
    }
    return cases;
}

bool has_error(const ReadResult& result) {
    return std::ranges::any_of(
        result.diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string report_of_file(const std::filesystem::path& path) { return read_lesson_file(path).report(); }

}  // namespace

TEST_CASE("A wrong lesson is answered letter by letter as written down", "[lessons][diagnostics]") {
    const std::vector<Case> cases = wrong_lessons();
    REQUIRE(cases.size() > 50);
    for (const Case& c : cases) {
        INFO(c.name);
        const ReadResult result = read_lesson(c.lesson, "lesson.toml");
        CHECK(result.report() == c.says);
        CHECK(result.lesson.has_value() != has_error(result));
    }
}

TEST_CASE("Line ends of other systems and a byte order mark change nothing", "[lessons][diagnostics]") {
    const std::string lesson = "format = 1\ntitle = \"t\"\ntext = \"\"\"\na\nb\"\"\"\n[[body]]\nname = 3\n";
    std::string other = "\xEF\xBB\xBF";
    for (const char c : lesson) { other += c == '\n' ? std::string("\r\n") : std::string(1, c); }
    const std::string report = read_lesson(lesson, "lesson.toml").report();
    CHECK(
        report ==
        "lesson.toml:7:8: error: 'name' is a number; expected a text in quotes [JW203]\n  name = 3\n         "
        "^\n");
    CHECK(read_lesson(other, "lesson.toml").report() == report);
}

TEST_CASE("Bytes that are not UTF-8 are named with their place", "[lessons][diagnostics]") {
    CHECK(
        read_lesson("format = 1\ntitle = \"\xCE\xA6 na\xEFve\"\n", "lesson.toml").report() ==
        "lesson.toml:2:14: error: the byte 0xEF is not UTF-8; expected a text file in UTF-8 [JW103]\n"
        "  title = \"Φ na\xEF\xBF\xBDve\"\n"
        "               ^\n"
        "  hint: save the file with the encoding UTF-8\n");
    // overlong, surrogate, beyond U+10FFFF, cut off
    for (const char* bytes : {"\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82"}) {
        CHECK(read_lesson("# " + std::string(bytes), "x").report().find("is not UTF-8") != std::string::npos);
    }
}

TEST_CASE("Of very many errors fifty are shown", "[lessons][diagnostics]") {
    std::string lesson = "format = 1\ntitle = \"t\"\n";
    for (int k = 0; k < 60; ++k) { lesson += "[[body]]\nname = 1\n"; }
    const ReadResult result = read_lesson(lesson, "lesson.toml");
    CHECK(result.diagnostics.size() == 60);
    CHECK(result.report().ends_with("\n... and 10 more\n"));
}

TEST_CASE("Absurd sizes are refused quickly", "[lessons][diagnostics]") {
    const std::string head = "format = 1\ntitle = \"t\"\n";
    std::string bodies = head;
    for (int k = 0; k < 501; ++k) { bodies += "[[body]]\nname = \"b" + std::to_string(k) + "\"\n"; }
    CHECK(read_lesson(bodies, "lesson.toml")
              .report()
              .starts_with(
                  "lesson.toml:3:1: error: there are 501 times 'body'; expected at most 500 [JW209]\n"));
    CHECK(
        read_lesson(
            head + "text = \"" + std::string(20001, 'x') + "\"\n[[body]]\nname = \"b\"\n", "lesson.toml")
            .report()
            .starts_with("lesson.toml:3:8: error: 'text' has 20001 bytes; expected at most 20000 [JW209]\n"));
    // a million levels would exhaust the stack of a parser that follows them
    std::string deep = "a";
    for (int k = 0; k < 1000000; ++k) { deep += ".'a'"; }
    CHECK(has_error(read_lesson(deep + " = 1", "x")));
    CHECK(has_error(read_lesson("a = " + std::string(1000000, '['), "x")));
    CHECK(has_error(read_lesson("[" + std::string(1000000, '['), "x")));
    std::string inline_tables = "a = ";
    for (int k = 0; k < 200000; ++k) { inline_tables += "{a="; }
    CHECK(has_error(read_lesson(inline_tables, "x")));
}

TEST_CASE("Files that cannot be lessons are refused with their name", "[lessons][diagnostics]") {
    const TemporaryFolder folder;
    const std::string name = folder.path().string();
    CHECK(
        report_of_file(folder.path() / "no.toml") ==
        name + "/no.toml: error: there is no such file; expected a lesson (.toml) [JW101]\n");
    CHECK(
        report_of_file(folder.path()) ==
        name + ": error: this is a folder; expected a lesson (.toml) [JW101]\n");
    CHECK(
        report_of_file(folder.write("empty.toml", "")) ==
        name +
            "/empty.toml: error: the file is empty; expected a lesson that begins with format = 1 [JW102]\n");
    CHECK(
        report_of_file(folder.write("big.toml", std::string((10U << 20U) + 1, '#'))) ==
        name + "/big.toml: error: the file is larger than 10 MB; expected a lesson (.toml) [JW101]\n");
    const ReadResult binary = read_lesson_file(folder.write("x.png", std::string("\x89PNG\0\0\x1A", 7)));
    CHECK(!binary.lesson);
    CHECK(has_error(binary));
}

TEST_CASE("Lessons below a folder are found in order", "[lessons][catalogue]") {
    const TemporaryFolder folder;
    folder.write("b/two.toml", "");
    folder.write("a.toml", "");
    folder.write("b/c/one.toml", "");
    folder.write("b/readme.md", "");
    const auto found = lessons_below(folder.path());
    REQUIRE(found.size() == 3);
    CHECK(found[0] == folder.path() / "a.toml");
    CHECK(found[1] == folder.path() / "b/c/one.toml");
    CHECK(found[2] == folder.path() / "b/two.toml");
    CHECK(lessons_below(folder.path() / "nowhere").empty());
}

TEST_CASE("The nearest name is offered, and none that is far", "[lessons][diagnostics]") {
    const std::vector<std::string> names{"ground", "crank", "coupler", "rocker"};
    CHECK(did_you_mean("couper", names) == "did you mean 'coupler'?");
    CHECK(did_you_mean("rcank", names) == "did you mean 'crank'?");
    CHECK(did_you_mean("x", names).empty());
    CHECK(did_you_mean("piston", names).empty());
    CHECK(did_you_mean(std::string(1000000, 'c'), names).empty());
}
