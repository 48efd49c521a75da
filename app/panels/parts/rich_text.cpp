#include "app/panels/parts/rich_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"

namespace jw::panels {

namespace {

constexpr float kBetweenLines = 2.0F;  ///< pixels at 720, around formulas that are higher than text
constexpr float kAroundDisplay = 5.0F;
constexpr float kDisplayIndent = 1.5F;
constexpr float kBesideCode = 0.2F;  ///< of the size of the font, on each side

// between Chinese and a formula, a line may break as between Chinese and a Latin letter
constexpr char32_t kFormula = U'x';

/// Pieces that stay on one line, and whether a space is before them.
struct Chunk {
    std::vector<RichPiece> pieces;  ///< x from the left end of the chunk
    float width = 0.0F;
    bool space_before = false;
    bool new_line = false;  ///< a paragraph begins
    bool own_line = false;  ///< a displayed formula
};

/// Splits words and formulas into chunks.
class Chunks {
public:
    Chunks(const render::Fonts& fonts, const ImFont& font) : fonts_(&fonts), font_(&font) {}

    void add_words(const std::string& words) {
        std::size_t at = 0;
        while (at < words.size()) {
            const bool space = words[at] == ' ' || words[at] == '\n';
            if (space) {
                pending_space_ = true;
                pending_line_ = pending_line_ || words[at] == '\n';
                ++at;
                continue;
            }
            const std::size_t end = std::min(words.find_first_of(" \n", at), words.size());
            const std::string word = with_minus_signs(std::string_view(words).substr(at, end - at));
            for (const std::string_view part : parts_to_break(word)) { put_words(part); }
            at = end;
        }
    }

    /// Adds code, which is not broken into lines.
    void add_code(const std::string& code) {
        const float beside = std::round(kBesideCode * font_->FontSize);
        RichPiece piece;
        piece.words = code;
        piece.shade = text_width(*font_, code) + 2.0F * beside;
        put(piece, piece.shade, kFormula, kFormula);
    }

    void add_formula(const math::Row& row, float width) {
        const FormulaFonts fonts = formulas();
        Formula whole = layout_formula(row, fonts);
        if (whole.width <= width) { return put_formula(std::move(whole)); }
        // broken before relations
        math::Row part;
        for (const math::Node& node : row) {
            if (is_kind(node, math::SignKind::relation) && !part.empty()) {
                put_formula(layout_formula(std::exchange(part, {}), fonts));
                pending_space_ = true;
            }
            part.push_back(node);
        }
        put_formula(layout_formula(part, fonts));
    }

    void add_display(const math::Row& row, float width) {
        FormulaFonts fonts = formulas();
        Formula whole = layout_formula(row, fonts, MathStyle::display);
        if (whole.width > width) {
            add_formula(row, width);
            return;
        }
        pending_space_ = true;
        put_formula(std::move(whole));
        chunks_.back().own_line = true;
        pending_space_ = true;
        after_display_ = true;
    }

    std::vector<Chunk> take() { return std::move(chunks_); }

private:
    FormulaFonts formulas() const { return formula_fonts_beside(*fonts_, *font_); }

    void put_words(std::string_view part) {
        const std::u32string characters = from_utf8(part);
        RichPiece piece;
        piece.words = part;
        put(std::move(piece), text_width(*font_, part), characters.front(), characters.back());
    }

    void put_formula(Formula formula) {
        RichPiece piece;
        const float width = formula.width;
        piece.formula = std::move(formula);
        put(std::move(piece), width, kFormula, kFormula);
    }

    void put(RichPiece piece, float width, char32_t first, char32_t last) {
        // a line may also break here without a space
        if (chunks_.empty() || pending_space_ || after_display_ || may_break_between(last_, first)) {
            chunks_.push_back({{}, 0.0F, pending_space_, pending_line_, false});
        }
        last_ = last;
        pending_space_ = false;
        pending_line_ = false;
        after_display_ = false;
        Chunk& chunk = chunks_.back();
        piece.x = chunk.width;
        chunk.width += width;
        chunk.pieces.push_back(std::move(piece));
    }

    const render::Fonts* fonts_;
    const ImFont* font_;
    std::vector<Chunk> chunks_;
    char32_t last_ = U' ';  ///< last character before the next piece
    bool pending_space_ = false;
    bool pending_line_ = false;
    bool after_display_ = false;
};

void grow(RichLine& line, const ImFont& font) {
    const float up = std::round(font.Ascent);
    line.ascent = up;
    line.descent = font.FontSize - up;
    for (const RichPiece& piece : line.pieces) {
        if (!piece.words.empty()) { continue; }
        const float air = (line.display ? kAroundDisplay : kBetweenLines) * font.FontSize / 16.0F;
        line.ascent = std::max(line.ascent, std::ceil(piece.formula.ascent + air));
        line.descent = std::max(line.descent, std::ceil(piece.formula.descent + air));
    }
}

void append(RichLine& line, Chunk& chunk, float x) {
    for (RichPiece& piece : chunk.pieces) {
        piece.x += x;
        line.pieces.push_back(std::move(piece));
    }
    line.width = x + chunk.width;
}

std::vector<RichLine> broken(std::vector<Chunk> chunks, const ImFont& font, float width) {
    const float space = font.GetCharAdvance(' ');
    std::vector<RichLine> lines;
    bool fresh = true;
    for (Chunk& chunk : chunks) {
        const float gap = chunk.space_before && !fresh ? space : 0.0F;
        const bool fits = !fresh && !chunk.new_line && lines.back().width + gap + chunk.width <= width;
        if (!fits || chunk.own_line) { lines.emplace_back(); }
        float x = fits && !chunk.own_line ? lines.back().width + gap : 0.0F;
        if (chunk.own_line) {
            x = std::min(kDisplayIndent * font.FontSize, std::max(0.0F, width - chunk.width));
        }
        lines.back().display = chunk.own_line;
        fresh = chunk.own_line;
        append(lines.back(), chunk, x);
    }
    return lines;
}

constexpr float kPadding = 8.0F;
constexpr float kBetweenTipLines = 3.0F;
constexpr float kOff = 10.0F;         ///< distance from the subject of the tip
constexpr float kWidestTip = 640.0F;  ///< at 720

/// The first lines, as many as fit, and their size.
struct TipLines {
    std::vector<RichText> lines;
    float width = 0.0F;
    float height = 0.0F;
};

TipLines lines_in(const Canvas& canvas, const std::vector<std::string>& lines, float width, float height) {
    TipLines laid;
    for (const std::string& line : lines) {
        RichText text = layout_rich(canvas.fonts(), *canvas.fonts().small, with_minus_signs(line), width);
        const float gap = laid.lines.empty() ? 0.0F : canvas.px(kBetweenTipLines);
        if (text.width() > width || laid.height + gap + text.height > height) { continue; }
        laid.height += gap + text.height;
        laid.width = std::max(laid.width, std::ceil(text.width()));
        laid.lines.push_back(std::move(text));
    }
    return laid;
}

/// Place below the subject of the tip, else above it, else anywhere in `within`.
Box placed(const TipPlace& place, float width, float height, float off) {
    Box box{place.beside.x, place.beside.bottom() + off, width, height};
    if (box.bottom() > place.within.bottom()) {
        const float above = place.beside.y - off - height;
        box.y = above >= place.within.y ? above : place.within.bottom() - height;
    }
    box.x = std::max(place.within.x, std::min(box.x, place.within.right() - width));
    box.y = std::max(place.within.y, box.y);
    return box;
}

}  // namespace

RichText layout_rich(const render::Fonts& fonts, const ImFont& font, std::string_view text, float width) {
    Chunks chunks(fonts, font);
    for (const math::TextPart& part : math::text_parts(text).parts) {
        switch (part.kind) {
            case math::TextPart::Kind::words: chunks.add_words(part.words); break;
            case math::TextPart::Kind::code: chunks.add_code(part.words); break;
            case math::TextPart::Kind::formula: chunks.add_formula(part.row, width); break;
            case math::TextPart::Kind::display: chunks.add_display(part.row, width); break;
        }
    }
    RichText rich;
    rich.lines = broken(chunks.take(), font, width);
    for (RichLine& line : rich.lines) {
        grow(line, font);
        rich.height += line.ascent + line.descent;
    }
    return rich;
}

RichText layout_rich_to(
    const render::Fonts& fonts, const ImFont& font, std::string_view text, float width, float height) {
    RichText rich = layout_rich(fonts, font, text, width);
    if (rich.height <= height) { return rich; }
    for (const std::size_t end : sentence_ends(text)) {
        RichText fewer = layout_rich(fonts, font, std::string(text.substr(0, end)) + " …", width);
        if (fewer.height <= height) { return fewer; }
    }
    while (!rich.lines.empty() && rich.height > height) {
        rich.height -= rich.lines.back().ascent + rich.lines.back().descent;
        rich.lines.pop_back();
    }
    return rich;
}

namespace {

/// @param at  top of the line, left end of the piece
void draw_words(
    const Canvas& canvas, Point at, const ImFont* font, const Colour& colour, const RichPiece& piece) {
    float x = std::round(at.x);
    if (piece.shade > 0.0F) {
        const float rounding = std::round(kBesideCode * font->FontSize);
        canvas.fill({x, at.y, piece.shade, canvas.line_height(font)}, theme::kShade, rounding);
        x += rounding;
    }
    canvas.text({x, at.y}, font, colour, piece.words);
}

}  // namespace

void draw_rich(
    const Canvas& canvas, Point top_left, const ImFont* font, Colour colour, const RichText& text) {
    float y = top_left.y;
    for (const RichLine& line : text.lines) {
        const float baseline = y + line.ascent;
        for (const RichPiece& piece : line.pieces) {
            if (piece.words.empty()) {
                link_symbols(canvas, {top_left.x + piece.x, baseline}, piece.formula);
                draw_formula(canvas, {top_left.x + piece.x, baseline}, piece.formula, colour, true);
            } else {
                draw_words(
                    canvas, {top_left.x + piece.x, baseline - std::round(font->Ascent)}, font, colour, piece);
            }
        }
        y += line.ascent + line.descent;
    }
}

Box draw_tip(const Canvas& canvas, const TipPlace& place, const std::vector<std::string>& lines) {
    const float padding = canvas.px(kPadding);
    const float widest = std::min(canvas.px(kWidestTip), place.within.width - 2.0F * padding);
    const TipLines laid = lines_in(canvas, lines, widest, place.within.height - 2.0F * padding);
    if (laid.lines.empty()) { return {}; }
    const Box box = placed(place, laid.width + 2.0F * padding, laid.height + 2.0F * padding, canvas.px(kOff));
    sheet(canvas, box, theme::kWhite, theme::kLine);
    float y = box.y + padding;
    for (const RichText& text : laid.lines) {
        draw_rich(canvas, {box.x + padding, y}, canvas.fonts().small, theme::kInk, text);
        y += text.height + canvas.px(kBetweenTipLines);
    }
    return box;
}

}  // namespace jw::panels
