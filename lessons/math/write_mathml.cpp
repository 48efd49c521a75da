#include <array>
#include <cstdint>
#include <string_view>

#include "core/numerics/variants.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/math/symbols.hpp"
#include "lessons/math/write_math.hpp"

namespace jw::math {

namespace {

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            default: safe += c;
        }
    }
    return safe;
}

std::string element(std::string_view name, const std::string& inner, std::string_view attributes = {}) {
    return "<" + std::string(name) + std::string(attributes) + ">" + inner + "</" + std::string(name) + ">";
}

/// A range of letters and its bold letters in Unicode: MathML Core has no other way to set bold letters.
struct BoldRun {
    std::uint32_t first;
    std::uint32_t last;
    std::uint32_t bold;
};
constexpr std::array kBold{
    BoldRun{'A', 'Z', 0x1D400},     BoldRun{'a', 'z', 0x1D482},     BoldRun{'0', '9', 0x1D7CE},
    BoldRun{0x391, 0x3A9, 0x1D6A8}, BoldRun{0x3B1, 0x3C9, 0x1D736},
};

std::uint32_t code_point(std::string_view utf8) {
    const auto byte = [&](std::size_t k) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(utf8[k]));
    };
    if (utf8.size() == 1) { return byte(0); }
    return utf8.size() == 2 ? ((byte(0) & 0x1FU) << 6U) | (byte(1) & 0x3FU) : 0;
}

std::string bold(const std::string& utf8) {
    const std::uint32_t c = code_point(utf8);
    for (const BoldRun& run : kBold) {
        if (c >= run.first && c <= run.last) {
            return "&#" + std::to_string(run.bold + (c - run.first)) + ";";
        }
    }
    return escaped(utf8);
}

/// @param first  the sign has no left operand
std::string sign_mathml(const Sign& sign, bool first) {
    if (sign.kind == SignKind::number) {
        return element("mn", sign.alphabet == Alphabet::bold ? bold(sign.utf8) : sign.utf8);
    }
    if (sign.kind == SignKind::letter && sign.alphabet == Alphabet::bold) {
        return element("mi", bold(sign.utf8));
    }
    if (sign.kind == SignKind::letter) {
        const bool upright = sign.alphabet == Alphabet::upright;
        return element("mi", sign.utf8, upright ? " mathvariant=\"normal\"" : "");
    }
    if (sign.kind == SignKind::function) { return element("mi", escaped(sign.utf8)); }
    // MathML would otherwise take it for a difference wherever something precedes it
    const bool prefix = first && sign.kind == SignKind::operation;
    return element("mo", escaped(sign.utf8), prefix ? " form=\"prefix\"" : "");
}

/// Delimiters around an element; an empty one is not drawn.
std::string fenced(std::string_view open, const std::string& inner, std::string_view close) {
    const auto fence = [](std::string_view drawn) {
        return drawn.empty() ? std::string() : element("mo", escaped(drawn), " fence=\"true\"");
    };
    return element("mrow", fence(open) + inner + fence(close));
}

std::string row_mathml(const Row& row);

std::string matrix_mathml(const Matrix& matrix) {
    std::string rows;
    for (const auto& row : matrix.rows) {
        std::string cells;
        for (const Row& cell : row) { cells += element("mtd", row_mathml(cell)); }
        rows += element("mtr", cells);
    }
    const Environment& e = environment_of(matrix.kind);
    return fenced(e.open, element("mtable", rows), e.close);
}

std::string nucleus_mathml(const Node& node, bool first) {
    return std::visit(
        Overloaded{
            [first](const Sign& sign) { return sign_mathml(sign, first); },
            [](const Words& words) { return element("mtext", escaped(words.utf8)); },
            [](const Space& space) { return "<mspace width=\"" + short_number(space.em) + "em\"/>"; },
            [](const Fraction& f) { return element("mfrac", row_mathml(f.above) + row_mathml(f.below)); },
            [](const Root& root) { return element("msqrt", row_mathml(root.inner)); },
            [](const Accent& a) {
                return element(
                    "mover", row_mathml(a.inner) + element("mo", std::string(accent_of(a.kind).over)),
                    " accent=\"true\"");
            },
            [](const Group& g) { return fenced(g.open, row_mathml(g.inner), g.close); },
            [](const Matrix& matrix) { return matrix_mathml(matrix); },
        },
        node.nucleus);
}

std::string node_mathml(const Node& node, bool first) {
    const std::string nucleus = nucleus_mathml(node, first);
    if (node.below.empty() && node.above.empty()) { return nucleus; }
    if (node.above.empty()) { return element("msub", nucleus + row_mathml(node.below)); }
    if (node.below.empty()) { return element("msup", nucleus + row_mathml(node.above)); }
    return element("msubsup", nucleus + row_mathml(node.below) + row_mathml(node.above));
}

/// One element for any number of nodes.
std::string row_mathml(const Row& row) {
    if (row.size() == 1) { return node_mathml(row[0], true); }
    std::string inner;
    bool first = true;
    for (const Node& node : row) {
        inner += node_mathml(node, first);
        first = precedes_operand(node);
    }
    return element("mrow", inner);
}

}  // namespace

std::string write_mathml(const Row& row, bool display) {
    return element(
        "math", row_mathml(row),
        std::string(" xmlns=\"http://www.w3.org/1998/Math/MathML\"") + (display ? " display=\"block\"" : ""));
}

}  // namespace jw::math
