#include "lessons/explanations/explanations.hpp"

#include <set>

#include <catch2/catch.hpp>

using namespace jw;

namespace {

/// True for codes of exercises: their pages are written with the reader of exercises, which gives them.
bool has_no_page_yet(Code code) { return code >= Code::exercise_kind; }

std::vector<Diagnostic> said_of(const Explanation& page, const std::string& example) {
    return read_example(page.setting, example, JW_SOURCE_ROOT);
}

}  // namespace

TEST_CASE("Codes are read as they are printed, in small letters and as bare numbers", "[explanations]") {
    for (const Code code : all_codes()) {
        const std::string printed = to_string(code);
        CAPTURE(printed);
        CHECK(printed.starts_with("JW"));
        CHECK(read_code(printed) == code);
        CHECK(read_code("jw" + printed.substr(2)) == code);
        CHECK(read_code(printed.substr(2)) == code);
    }
    CHECK(to_string(Code::file_unreadable) == "JW101");
    CHECK(to_string(Code::exercise_variant) == "JW855");
    for (const char* text : {"", "JW", "JW1", "JW2010", "JW 201", "201 ", "XW201", "JWJW201"}) {
        CHECK_FALSE(read_code(text).has_value());
    }
}

TEST_CASE("Every code has a title of its own, and a page with cause, cure and example", "[explanations]") {
    std::set<std::string> titles{""};
    std::size_t pages = 0;
    for (const Code code : all_codes()) {
        CAPTURE(to_string(code));
        CHECK(titles.insert(title_of(code)).second);
        CHECK_FALSE(group_of(code).empty());
        const Explanation* page = explanation_of(code);
        REQUIRE((page != nullptr) != has_no_page_yet(code));
        if (page == nullptr) { continue; }
        ++pages;
        CHECK_FALSE(page->cause.empty());
        CHECK_FALSE(page->cure.empty());
        CHECK_FALSE(page->right.empty());
        CHECK(page->right != page->wrong);
    }
    CHECK(explanations().size() == pages);
}

TEST_CASE("The wrong example of every page has the mistake of its code and no other", "[explanations]") {
    for (const Explanation& page : explanations()) {
        CAPTURE(to_string(page.code), page.wrong);
        const std::vector<Diagnostic> diagnostics = said_of(page, page.wrong);
        CHECK(std::ranges::find(diagnostics, page.code, &Diagnostic::code) != diagnostics.end());
        for (const Diagnostic& diagnostic : diagnostics) {
            CAPTURE(diagnostic.message);
            CHECK((diagnostic.code == page.code || diagnostic.severity == Severity::warning));
        }
    }
}

TEST_CASE("The mended example of every page is read without a word", "[explanations]") {
    for (const Explanation& page : explanations()) {
        CAPTURE(to_string(page.code), page.right);
        for (const Diagnostic& diagnostic : said_of(page, page.right)) {
            CAPTURE(diagnostic.message);
            CHECK(false);
        }
    }
}
