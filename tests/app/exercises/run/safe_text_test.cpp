#include <catch2/catch.hpp>

#include <random>

#include "app/exercises/run/safe_text.hpp"

namespace jw::exercises::test {

TEST_CASE("Text stays as it is, and what controls a terminal is spelled out", "[run]") {
    CHECK(printable("plain\n\ttext, Φq, 𝛾, ü") == "plain\n\ttext, Φq, 𝛾, ü");
    CHECK(printable("\x1b[2J\x1b]0;title\x07") == "\\x1b[2J\\x1b]0;title\\x07");
    CHECK(printable("right\rwrong\b\x7f") == "right\\x0dwrong\\x08\\x7f");
    CHECK(printable(std::string(1, '\0')) == "\\x00");
    CHECK(printable("\xc2\x9b") == "\\u{9b}");        // a control sequence in one character
    CHECK(printable("\xe2\x80\xae") == "\\u{202e}");  // writes from right to left
    CHECK(printable("\xe2\x81\xa6\xe2\x80\xa8") == "\\u{2066}\\u{2028}");
}

TEST_CASE("Invalid UTF-8 is spelled out byte by byte", "[run]") {
    CHECK(printable("\xff") == "\\xff");
    CHECK(printable("a\xc3") == "a\\xc3");         // cut off
    CHECK(printable("\xc0\xaf") == "\\xc0\\xaf");  // longer than necessary
    CHECK(printable("\xe0\x80\xaf") == "\\xe0\\x80\\xaf");
    CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // half a pair
    CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond the last character
}

TEST_CASE("Printable text of any bytes is printable", "[run]") {
    constexpr std::uint32_t seed = 3;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int sample = 0; sample < 2000; ++sample) {
        std::string bytes;
        for (int k = 0; k < 30; ++k) { bytes += static_cast<char>(random() % 256); }
        const std::string text = printable(bytes);
        CHECK(printable(text) == text);
        CHECK(text.find('\x1b') == std::string::npos);
    }
}

TEST_CASE("First lines are cut in number and width, but not within a character", "[run]") {
    CHECK(first_lines("a\nb\nc\n", 3, 10) == "a\nb\nc");
    CHECK(first_lines("a\nb\nc\n", 2, 10) == "a\nb\n...");
    CHECK(first_lines("abcdef\ngh", 2, 3) == "abc...\ngh");
    CHECK(first_lines("aüb", 1, 2) == "a...");
    CHECK(first_lines("", 3, 10).empty());
    CHECK(first_lines("\n\n", 3, 10).empty());
}

}  // namespace jw::exercises::test
