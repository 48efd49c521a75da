#include <catch2/catch.hpp>

#include <array>
#include <regex>

#include <nlohmann/json.hpp>

#include "app/session/encoding/html_words.hpp"
#include "lessons/files/catalogue.hpp"
#include "tests/app/program.hpp"

namespace jw::test {
namespace {

const std::string kTrueClaim = std::string(kCrank) + "[[expect]]\nrank = 6\n";
const std::string kFalseClaim =
    std::string(kCrank) + "[[expect]]\nrank = 5\ndof = 0\nwhy = \"One <is> driven & \\\"held\\\".\"\n";

/// A folder with one lesson of each kind, some of them in folders of their own.
struct Lessons : Folder {
    Lessons() {
        std::filesystem::create_directories(path("b/deep"));
        good = file("a.toml", kTrueClaim);
        bad = file("b/deep/c.toml", kFalseClaim);
        claimless = file("d.toml", kCrank);
    }
    std::string good;
    std::string bad;
    std::string claimless;
};

/// True if attributes and text have nothing that XML forbids, and every tag is closed in the right order.
bool is_well_formed(const std::string& xml) {
    static const std::regex tag("<(/?)([a-z]+)((?: [a-z]+=\"[^\"<]*\")*)(/?)>");
    static const std::regex entity("&(amp|lt|gt|quot|#[0-9]+);");
    if (!xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n")) { return false; }
    const std::string body = xml.substr(xml.find('\n') + 1);
    std::vector<std::string> open;
    std::string outside;
    auto last = body.begin();
    for (std::sregex_iterator it(body.begin(), body.end(), tag), end; it != end; ++it) {
        outside.append(last, (*it)[0].first);
        last = (*it)[0].second;
        const std::string name = (*it)[2];
        if ((*it)[1].length() > 0) {
            if (open.empty() || open.back() != name) { return false; }
            open.pop_back();
        } else if ((*it)[4].length() == 0) {
            open.push_back(name);
        }
    }
    outside.append(last, body.end());
    const std::string plain = std::regex_replace(body, entity, "");
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20U && c != '\n'; };
    return open.empty() && outside.find_first_of("<>") == std::string::npos &&
           plain.find('&') == std::string::npos && std::ranges::none_of(body, is_control);
}

int count_of(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) { ++count; }
    return count;
}

}  // namespace

TEST_CASE("check takes folders and goes through all lessons below them in order", "[app][check]") {
    const Lessons lessons;
    const Ran ran = run({"check", lessons.path(), lessons.good, "--quiet"});
    CHECK(ran.status == 1);
    CHECK(
        ran.out == lessons.good + ": 1 of 1 claim holds\n" + lessons.bad +
                       ": 1 of 2 claims hold\n"
                       "  FAILS after drive        rank                   expected 5, found 6\n"
                       "        " +
                       lessons.bad + ":20:8\n        One <is> driven & \"held\".\n" + lessons.claimless +
                       ": no claims\n" + lessons.good + ": 1 of 1 claim holds\n");
    CHECK(ran.err.empty());
}

TEST_CASE("check of a folder without lessons is status 2, and the rest is checked", "[app][check]") {
    const Lessons lessons;
    std::filesystem::create_directories(lessons.path("empty"));
    const Ran ran = run({"check", lessons.path("empty"), lessons.good});
    CHECK(ran.status == 2);
    CHECK(
        ran.err ==
        lessons.path("empty") + ": error: there is no lesson below this folder; expected files *.toml\n");
    CHECK_THAT(ran.out, Catch::Contains("1 of 1 claim holds"));
}

TEST_CASE("A lesson without claims is status 1 only where claims are required", "[app][check]") {
    const Lessons lessons;
    const Ran ran = run({"check", lessons.claimless});
    CHECK(ran.status == 0);
    CHECK(ran.out == lessons.claimless + ": no claims\n");
    const Ran required = run({"check", lessons.claimless, "--require-claims"});
    CHECK(required.status == 1);
    CHECK(
        required.err ==
        lessons.claimless + ": error: the lesson claims nothing; expected an [[expect]] block\n");
    CHECK(run({"check", lessons.good, "--require-claims"}).status == 0);
}

TEST_CASE("The JSON of check has every claim, every error and the exit status", "[app][check]") {
    const Lessons lessons;
    const std::string missing = lessons.path("missing.toml");
    const Ran ran = run({"check", lessons.path(), missing, "--format", "json"});
    CHECK(ran.status == 2);
    const nlohmann::json json = nlohmann::json::parse(ran.out);
    CHECK(json["format"] == "jointwise check");
    CHECK(json["version"] == 1);
    CHECK(json["exit_status"] == 2);
    REQUIRE(json["lessons"].size() == 4);
    const std::vector<std::string> states{"holds", "fails", "no claims", "error"};
    for (std::size_t k = 0; k < 4; ++k) { CHECK(json["lessons"][k]["state"] == states[k]); }
    const nlohmann::json& bad = json["lessons"][1];
    CHECK(bad["file"] == lessons.bad);
    CHECK(bad["title"] == "A crank");
    CHECK(bad["held"] == 1);
    CHECK(bad["failed"] == 1);
    CHECK(bad["error"].is_null());
    const nlohmann::json rank{{"holds", false},    {"moment", "after drive"},
                              {"subject", "rank"}, {"expected", "5"},
                              {"found", "6"},      {"why", "One <is> driven & \"held\"."},
                              {"line", 20},        {"column", 8}};
    CHECK(bad["claims"][0] == rank);
    CHECK_THAT(json["lessons"][3]["error"].get<std::string>(), Catch::Contains("there is no such file"));
    CHECK(json["lessons"][3]["diagnostics"][0]["code"] == "JW101");
    CHECK_FALSE(bad.contains("diagnostics"));
}

TEST_CASE("What is found reads differently from what is claimed, where they differ", "[app][check]") {
    const std::array<std::array<std::string, 3>, 2> claims{
        {{"formula = \"10^9 + 1 = 10^9\"", "holds", "1000000001 and 1000000000, 1.0e+00 apart"},
         {"at_s = 0.3\nquantity = \"pivot.angle\"\nvalue_deg = 27.00000000000004\ntolerance_deg = 1e-14",
          "27.00000000000004 deg ± 1e-14", "27 deg, off by"}}};
    const Folder folder;
    for (const auto& [claim, expected, found] : claims) {
        CAPTURE(claim);
        const std::string file = folder.file("near.toml", kCrank + ("[[expect]]\n" + claim + "\n"));
        const Ran ran = run({"check", file, "--format", "json"});
        REQUIRE(ran.status == 1);
        const nlohmann::json told = nlohmann::json::parse(ran.out)["lessons"][0]["claims"][0];
        CHECK(told["expected"] == expected);
        CHECK_THAT(told["found"].get<std::string>(), Catch::StartsWith(found));
    }
}

TEST_CASE("The JSON of check says what was tried and how many claims it left out", "[app][check]") {
    const std::string file = lesson_path("loops/four-bar.toml");
    const Ran ran = run({"check", file, "--try", "take out motor", "--format", "json"});
    const nlohmann::json lesson = nlohmann::json::parse(ran.out)["lessons"][0];
    CHECK(lesson["tried"].size() == 1);
    CHECK(lesson["not_judged"].is_number());
}

TEST_CASE("The JUnit of check is XML with a suite per lesson and a case per claim", "[app][check]") {
    const Lessons lessons;
    const std::string wrong = lessons.file("wrong&.toml", "format = 1\ntitle = \"t<\"\ncolor = 3\n");
    const Ran ran = run({"check", lessons.path(), wrong, "--format", "junit"});
    INFO(ran.out);
    CHECK(ran.status == 2);
    CHECK(is_well_formed(ran.out));
    CHECK_THAT(
        ran.out,
        Catch::Contains("<testsuites name=\"jointwise check\" tests=\"6\" failures=\"1\" errors=\"2\">"));
    CHECK(count_of(ran.out, "<testsuite ") == 5);
    CHECK(count_of(ran.out, "<testcase ") == 6);
    CHECK(count_of(ran.out, "<skipped message=\"no claims\"/>") == 1);
    CHECK_THAT(
        ran.out, Catch::Contains(
                     "name=\"after drive: rank 5\">\n      <failure type=\"claim\" message=\"expected 5, "
                     "found 6\">" +
                     lessons.bad + ":20:8\nOne &lt;is&gt; driven &amp; \"held\".</failure>"));
    CHECK_THAT(
        ran.out, Catch::Contains(
                     "<error type=\"JW202\" message=\"" + lessons.path() +
                     "/wrong&amp;.toml:1:1: error: the lesson has no 'body'"));
    const Ran required = run({"check", lessons.claimless, "--format", "junit", "--require-claims"});
    CHECK(required.status == 1);
    CHECK_THAT(required.out, Catch::Contains("tests=\"1\" failures=\"1\" errors=\"0\""));
}

TEST_CASE("Text in XML keeps nothing that XML forbids", "[app][check]") {
    CHECK(xml_text("a < b & \"c\"\n\t>") == "a &lt; b &amp; \"c\"\n\t&gt;");
    CHECK(xml_attribute("a \"b\"\n\t") == "a &quot;b&quot;&#10;&#9;");
    const std::string mark = "\xEF\xBF\xBD";
    for (const std::string forbidden : {"\x01", "\x1B", "\xFF", "\xC3", "\xEF\xBF\xBE"}) {
        CHECK(xml_text("a" + forbidden).starts_with("a" + mark));
        CHECK(xml_text("a" + forbidden).find(forbidden) == std::string::npos);
    }
    // overlong, a surrogate, beyond the last character
    for (const std::string wrong : {"\xC0\xAF", "\xED\xA0\x80", "\xF5\x80\x80\x80"}) {
        CHECK(xml_text(wrong).starts_with(mark));
    }
    CHECK(xml_text("Φ ω′ 𝛷") == "Φ ω′ 𝛷");
}

TEST_CASE("Every shipped lesson claims something that holds", "[app][check]") {
    const Ran ran = run({"check", (catalogue_folder() / "joints").string(), "--require-claims", "--quiet"});
    INFO(ran.out << ran.err);
    CHECK(ran.status == 0);
}

}  // namespace jw::test
