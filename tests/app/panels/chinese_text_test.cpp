#include <catch2/catch.hpp>

#include <random>

#include <imgui.h>

#include "app/panels/parts/rich_text.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/session/wording/text_width.hpp"
#include "tests/app/panels/support.hpp"

namespace jw::panels::test {

namespace {

constexpr std::u32string_view kNeverFirst = U"，。、：；？！」）";
constexpr std::u32string_view kNeverLast = U"「（";

/// A mixture of Chinese, Latin words, marks and, where wanted, formulas; no mark that opens stands before one
/// that closes, as in sentences.
std::string mixture(unsigned seed, bool formulas) {
    static const std::vector<std::string> chinese{"剛", "體", "拘", "束", "方", "程",
                                                  "式", "的", "自", "由", "度"};
    static const std::vector<std::string> latin{" Newton ", " -0.5 ", " p1 ", "θ", " hinge"};
    static const std::vector<std::string> marks{"，", "。", "、", "：", "？", "）", "」"};
    std::mt19937 random(seed);
    const auto one_of = [&](const std::vector<std::string>& list) { return list[random() % list.size()]; };
    std::string text;
    for (int k = 0; k < 60; ++k) {
        switch (random() % 8) {
            case 0: text += one_of(latin); break;
            case 1: text += one_of(chinese) + one_of(marks); break;
            case 2: text += (random() % 2 == 0 ? "「" : "（") + one_of(chinese); break;
            case 3:
                text += formulas ? (random() % 2 == 0 ? "$\\Phi_q$" : " $d_0 = 1$ ") : one_of(chinese);
                break;
            default: text += one_of(chinese);
        }
    }
    return text;
}

bool may_begin(const std::string& line) {
    return kNeverFirst.find(from_utf8(line).front()) == std::u32string_view::npos;
}
bool may_end(const std::string& line) {
    return kNeverLast.find(from_utf8(line).back()) == std::u32string_view::npos;
}
std::string without_spaces(std::string text) {
    std::erase(text, ' ');
    std::erase(text, '\n');
    return text;
}

}  // namespace

TEST_CASE(
    "Lines of Chinese fit, lose nothing, and neither begin nor end with the wrong mark",
    "[panels][chinese]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const std::string text = mixture(seed, false);
        // wide enough for the longest part that does not break
        const float width = 150.0F + 20.0F * static_cast<float>(seed % 12);
        CAPTURE(seed, text, width);
        std::string joined;
        for (const std::string& line : wrapped(font, text, width)) {
            CHECK(text_width(font, line) <= width);
            CHECK(may_begin(line));
            CHECK(may_end(line));
            joined += line;
        }
        CHECK(without_spaces(joined) == without_spaces(with_minus_signs(text)));
    }
}

TEST_CASE("Lines of Chinese with formulas fit, lose nothing, and break where they may", "[panels][chinese]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const std::string text = mixture(seed, true);
        const float width = 200.0F + 20.0F * static_cast<float>(seed % 12);
        CAPTURE(seed, text, width);
        std::string words;
        for (const RichLine& line : layout_rich(surface.fonts(), font, text, width).lines) {
            CHECK(line.width <= width);
            REQUIRE_FALSE(line.pieces.empty());
            const RichPiece& first = line.pieces.front();
            const RichPiece& last = line.pieces.back();
            CHECK((first.words.empty() || may_begin(first.words)));
            CHECK((last.words.empty() || may_end(last.words)));
            for (const RichPiece& piece : line.pieces) { words += piece.words; }
        }
        std::string expected;
        for (const math::TextPart& part : math::text_parts(text).parts) {
            if (part.kind == math::TextPart::Kind::words) { expected += with_minus_signs(part.words); }
        }
        CHECK(without_spaces(words) == without_spaces(expected));
    }
}

TEST_CASE(
    "Lines in a terminal count two columns for Chinese, and break where they may", "[panels][chinese]") {
    CHECK(displayed_width("剛體 p1，") == 9);
    CHECK(displayed_width("Φq′ e\u0301") == 5);
    CHECK(padded("剛體", 6) == "剛體  ");
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const std::string text = mixture(seed, false);
        const int width = 20 + static_cast<int>(seed % 30);
        CAPTURE(seed, text, width);
        std::string lines = jw::wrapped(text, width, 0);
        CHECK(without_spaces(lines) == without_spaces(text));
        for (std::size_t at = 0; at < lines.size();) {
            const std::size_t end = std::min(lines.find('\n', at), lines.size());
            const std::string line = lines.substr(at, end - at);
            CHECK(displayed_width(line) <= width);
            CHECK(may_begin(line));
            CHECK(may_end(line));
            at = end + 1;
        }
    }
}

TEST_CASE("A long Chinese text is cut at the end of a sentence", "[panels][chinese]") {
    const Surface surface;
    const ImFont& font = *surface.fonts().normal;
    const std::string text = "第一句。第二句很長很長很長很長很長很長很長很長。";
    const std::vector<std::string> lines = wrapped_to(font, text, text_width(font, "第一句。第二 …"), 1);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0] == "第一句。 …");
}

}  // namespace jw::panels::test
