#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

#include <nlohmann/json.hpp>

#include "lessons/explanations/explanations.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

TEST_CASE("explain shows the page about a code however it is typed", "[app][explain]") {
    for (const Explanation& page : explanations()) {
        const std::string code = to_string(page.code);
        CAPTURE(code);
        const Ran ran = run({"explain", code});
        CHECK(ran.status == 0);
        CHECK(ran.err.empty());
        CHECK_THAT(ran.out, Catch::StartsWith(code + ": " + title_of(page.code)));
        // the example is answered with the message that the page is about
        const bool is_answered = page.setting != Explanation::Setting::path;
        CHECK((ran.out.find('[' + code + ']') != std::string::npos) == is_answered);
        CHECK(run({"explain", "jw" + code.substr(2)}).out == ran.out);
        CHECK(run({"explain", code.substr(2)}).out == ran.out);
    }
}

TEST_CASE("explain lists every code that has a page", "[app][explain]") {
    const Ran all = run({"explain"});
    CHECK(all.status == 0);
    const nlohmann::json json = nlohmann::json::parse(run({"explain", "--format", "json"}).out);
    CHECK(json["codes"].size() == explanations().size());
    for (const Explanation& page : explanations()) {
        const std::string line = to_string(page.code) + "  " + title_of(page.code) + '\n';
        CHECK_THAT(all.out, Catch::Contains(line));
    }
}

TEST_CASE("explain refuses a code that is none, and offers the nearest", "[app][explain]") {
    const Ran near = run({"explain", "jw219"});
    CHECK(near.status == 2);
    CHECK(near.out.empty());
    CHECK(
        near.err ==
        "jointwise: error: no code 'jw219'; expected one such as JW301\nhint: did you mean 'JW209'?\n");
    CHECK_THAT(run({"explain", "four-bar"}).err, Catch::Contains("hint: 'jointwise explain' lists them"));
}

TEST_CASE("docs/diagnostics.md is what explain writes", "[app][explain][golden]") {
    const std::string page = run({"explain", "--format", "markdown"}).out;
    const std::string path = std::string(JW_SOURCE_ROOT) + "/docs/diagnostics.md";
    if (std::getenv("JW_REGENERATE_GOLDEN") != nullptr) { std::ofstream(path) << page; }
    CHECK(bytes_of(path) == page);
}

}  // namespace jw::test
