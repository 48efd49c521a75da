#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>

#include "app/session/encoding/html_words.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

namespace {

namespace fs = std::filesystem;

const std::string kVectors = std::string(JW_EXERCISES_FOLDER) + "/vectors.toml";

std::string key_in(const Folder& folder) {
    return folder.file(
        "key.toml", "format = 1\nsecret = \"quite a secret\"\nexercises = [\"" + kVectors + "\"]\n");
}

Ran sheet(const Folder& folder, const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> arguments{"sheet", kVectors,         "--key",       key_in(folder),
                                       "--out", folder.path(out), "--no-figures"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
}

}  // namespace

TEST_CASE(
    "A sheet is the same for the same student and key, and its solution gets all points but those of files",
    "[exercises][sheet]") {
    const Folder folder;
    const Ran first = sheet(folder, "one", {"--student", "ann", "--solution"});
    INFO(first.err);
    REQUIRE(first.status == 0);
    REQUIRE(sheet(folder, "two", {"--student", "ann", "--solution"}).status == 0);
    REQUIRE(sheet(folder, "two", {"--student", "bob"}).status == 0);
    for (const char* name :
         {"sheet.md", "sheet.html", "answers.toml", "solution/sheet.html", "solution/answers.toml"}) {
        const std::string one = bytes_of(folder.path(std::string("one/ann/") + name));
        CAPTURE(name);
        CHECK_FALSE(one.empty());
        CHECK(one == bytes_of(folder.path(std::string("two/ann/") + name)));
    }
    CHECK(bytes_of(folder.path("two/ann/sheet.md")) != bytes_of(folder.path("two/bob/sheet.md")));
    CHECK_THAT(
        bytes_of(folder.path("two/bob/sheet.md")),
        Catch::Contains("## Hints") && Catch::Contains("Exercise 1, hint 2"));
    fs::copy_file(
        folder.path("one/ann/solution/answers.toml"), folder.path("one/ann/answers.toml"),
        fs::copy_options::overwrite_existing);
    const Ran graded = run({"grade", folder.path("one/ann"), "--key", key_in(folder)});
    CHECK_THAT(graded.out, Catch::Contains("global-vector: right"));
    CHECK(graded.out.find("wrong") == std::string::npos);
    CHECK(graded.out.find("not understood") == std::string::npos);
}

TEST_CASE(
    "A list of a class gives a sheet for each student, and says what is wrong with it",
    "[exercises][sheet]") {
    const Folder folder;
    const std::string roster = folder.file("roster.csv", "Student,Name\n\"a1\",Ann\nb2;Bob\n");
    REQUIRE(sheet(folder, "class", {"--class", roster}).status == 0);
    CHECK(fs::exists(folder.path("class/a1/sheet.html")));
    CHECK(fs::exists(folder.path("class/b2/sheet.html")));
    const std::string wrong = folder.file("wrong.csv", "id\n../x\na\na\n");
    const Ran refused = sheet(folder, "no", {"--class", wrong});
    CHECK(refused.status == 2);
    CHECK_THAT(refused.err, Catch::Contains("wrong.csv:2:1") && Catch::Contains("is there twice"));
    CHECK_FALSE(fs::exists(folder.path("no")));
    CHECK(sheet(folder, "no", {}).status == 2);
    CHECK(sheet(folder, "no", {"--student", "a/b"}).status == 2);
}

TEST_CASE("A quiz is XML that another program reads, with every mistake as an answer", "[exercises][sheet]") {
    const Folder folder;
    const Ran ran = sheet(folder, "quiz", {"--variants", "3", "--format", "moodle"});
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    const std::string script = folder.file("read.py", R"(
import html, re, sys, xml.etree.ElementTree as et
quiz = et.parse(sys.argv[1]).getroot()
kinds = [q.get('type') for q in quiz]
assert kinds.count('category') >= 5, kinds
for q in quiz:
    if q.get('type') == 'numerical':
        answers = q.findall('answer')
        assert answers[0].get('fraction') == '100'
        values = [float(a.find('text').text) for a in answers]
        tolerance = float(answers[0].find('tolerance').text)
        assert all(abs(v - values[0]) > 2 * tolerance for v in values[1:]), values
        assert all(a.find('feedback/text').text for a in answers)
    if q.get('type') == 'cloze':
        gaps = re.findall(r'\{1:NUMERICAL:(.*?)(?<!\\)\}', q.find('questiontext/text').text)
        assert gaps
        for gap in gaps:
            alternatives = re.split(r'(?<!\\)~', gap)
            assert alternatives[0].startswith('=') and len(alternatives) > 1, gap
            for alternative in alternatives:
                answer, feedback = re.fullmatch(r'(?:=|%0%)([^#]*)#(.+)', alternative).groups()
                value, width = map(float, answer.split(':'))
                assert width > 0
                shown = html.unescape(feedback).replace('\\}', '}').replace('\\#', '#')
                assert '\\' not in shown and '&' not in shown, shown
    if q.get('type') == 'multichoice':
        assert [a.get('fraction') for a in q.findall('answer')].count('100') == 1
)");
    const std::string command = "python3 " + script + " " + folder.path("quiz/moodle.xml");
    CHECK(std::system(command.c_str()) == 0);
}

TEST_CASE("Text of students does nothing in a page", "[exercises][sheet]") {
    CHECK(markup_text("<script>&\"'") == "&lt;script&gt;&amp;&quot;&#39;");
    CHECK(
        markup_text(std::string("a\xff\x1b") + "b") ==
        "a\xEF\xBF\xBD\xEF\xBF\xBD"
        "b");
    for (const char* none : {"\xEF\xBF\xBF", "\xED\xA0\x80", "\xE0\x80\x80", "\xF4\x90\x80\x80"}) {
        CHECK(markup_text(none).starts_with("\xEF\xBF\xBD"));
    }
    CHECK(markup_text("ω 數 😀") == "ω 數 😀");
    CHECK(html_words("x < y and $a < b$").find("<script") == std::string::npos);
    CHECK(html_words("1 < 2").find("&lt;") != std::string::npos);
}

}  // namespace jw::test
