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
    for (const CodeEntry& entry : kCodes) {
        const std::string number(entry.printed.substr(2));
        CAPTURE(entry.printed);
        CHECK(read_code(entry.printed) == entry.code);
        CHECK(read_code("jw" + number) == entry.code);
        CHECK(read_code(number) == entry.code);
    }
    for (const char* text : {"", "JW", "JW1", "JW2010", "JW 201", "201 ", "XW201", "JWJW201"}) {
        CHECK_FALSE(read_code(text).has_value());
    }
}

TEST_CASE("Every code has a title of its own, and a page with cause, cure and example", "[explanations]") {
    std::set<std::string_view> titles;
    for (const CodeEntry& entry : kCodes) {
        CAPTURE(entry.printed);
        CHECK(titles.insert(entry.title).second);
        CHECK_FALSE(group_of(entry.code).empty());
        const Explanation* page = explanation_of(entry.code);
        REQUIRE((page != nullptr) != has_no_page_yet(entry.code));
        if (page == nullptr) { continue; }
        CHECK_FALSE(page->cause.empty());
        CHECK_FALSE(page->cure.empty());
        CHECK_FALSE(page->right.empty());
        CHECK(page->right != page->wrong);
    }
    CHECK(explanations().size() == static_cast<std::size_t>(Code::exercise_kind));
}

TEST_CASE("The wrong example of every page has the mistake of its code and no other", "[explanations]") {
    for (const Explanation& page : explanations()) {
        CAPTURE(entry_of(page.code).printed, page.wrong);
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
        CAPTURE(entry_of(page.code).printed, page.right);
        for (const Diagnostic& diagnostic : said_of(page, page.right)) {
            CAPTURE(diagnostic.message);
            CHECK(false);
        }
    }
}
