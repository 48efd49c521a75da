#include "app/panels/parts/text_lines.hpp"

#include <catch2/catch.hpp>

#include "app/panels/frame/frame.hpp"
#include "tests/app/panels/support.hpp"

namespace jw::panels::test {

TEST_CASE("hyphens of numbers become minus signs, those of words stay", "[panels][text]") {
    CHECK(with_minus_signs("x = -0.5, e-3") == "x = −0.5, e-3");
    CHECK(with_minus_signs("-1.2e-07") == "−1.2e−07");
    CHECK(with_minus_signs("(-1, 2)") == "(−1, 2)");
    CHECK(with_minus_signs("p1-2 and Newton-Raphson - so") == "p1-2 and Newton-Raphson - so");
}

TEST_CASE("what authors can type is set as they meant it", "[panels][text]") {
    CHECK(typeset("s_i and u_j, d_0") == "sᵢ and uⱼ, d₀");
    CHECK(typeset("θ_0") == "θ₀");
    CHECK(typeset("(d - d_0) - p1-2") == "(d – d₀) – p1-2");
    CHECK(typeset("file_1 and s_in") == "file_1 and s_in");
}

TEST_CASE("code points survive UTF-8, and broken bytes do not stop it", "[panels][text]") {
    CHECK(from_utf8("Φq′") == U"Φq′");
    CHECK(
        from_utf8("a\xFF"
                  "b") == U"a\uFFFDb");
    CHECK(from_utf8("\xCE") == U"\uFFFD");
}

TEST_CASE("every line fits, and nothing is lost by wrapping", "[panels][text]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    const std::string text =
        "The largest residual is D · s · x = −0.065 and an_endless_word_that_fits_no_line_of_this_width "
        "ends.";
    const float width = GENERATE(60.0F, 120.0F, 300.0F, 2000.0F);
    std::string joined;
    for (const std::string& line : wrapped(font, text, width)) {
        CHECK(text_width(font, line) <= width);
        joined += line;
    }
    const auto without_spaces = [](std::string s) {
        std::erase(s, ' ');
        return s;
    };
    CHECK(without_spaces(joined) == without_spaces(text));
}

TEST_CASE("names with dots and equations stay on one line where it is wide enough", "[panels][text]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    const std::string unit = "D · s · x = −0.065";
    const float width = text_width(font, unit + " is");
    for (const std::string& line : wrapped(font, "The largest residual there is is " + unit, width)) {
        CHECK((line.find("D · s") == std::string::npos || line == unit));
    }
}

TEST_CASE("what does not fit is left out from the end of a sentence on", "[panels][text]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    const std::string text =
        "One sentence. A second one. And a third that is a good deal longer than these two.";
    const float width = text_width(font, "One sentence. A second one. …");
    CHECK(wrapped_to(font, text, width, 1) == std::vector<std::string>{"One sentence. A second one. …"});
    CHECK(wrapped_to(font, text, 1e6F, 1) == std::vector<std::string>{text});
    const auto cut = wrapped_to(font, "no end of a sentence in sight anywhere", 80.0F, 1);
    REQUIRE(cut.size() == 1);
    CHECK(cut[0].ends_with("…"));
    CHECK(text_width(font, cut[0]) <= 80.0F);
}

TEST_CASE("a shortened name keeps its end, which tells it from others", "[panels][text]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    const std::string name = shortened_name(font, "segment-7", 60.0F);
    CHECK(name.starts_with("se"));
    CHECK(name.ends_with("…7"));
    CHECK(text_width(font, name) <= 60.0F);
    CHECK(shortened_name(font, "crank", 200.0F) == "crank");
}

TEST_CASE("lines of a lesson's text run on, paragraphs stay", "[panels][text]") {
    CHECK(run_on("\none\ntwo\n\nthree\n") == "one two\nthree");
    CHECK(run_on("") == "");
}

}  // namespace jw::panels::test
