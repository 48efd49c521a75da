#include "app/panels/column/panels.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/formula.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

using Status = EquationRow::Status;

const char* word_of(Status status) {
    if (status == Status::redundant) { return tr("redundant"); }
    return status == Status::dropped ? tr("out") : "";
}

Colour colour_of(Status status) {
    switch (status) {
        case Status::kept: return theme::kInk;
        case Status::dropped: return theme::kFaint;
        case Status::open: return theme::kSoft;
        case Status::redundant: break;
    }
    return theme::kRedundant;
}

void draw_mark(const Canvas& canvas, Point centre, Status status) {
    const float side = canvas.px(9.0F);
    canvas.square(centre, side, colour_of(status), status == Status::kept);
    if (status == Status::redundant) {
        const Box box{std::round(centre.x - 0.5F * side), std::round(centre.y - 0.5F * side), side, side};
        canvas.hatch(box, theme::kRedundant, canvas.px(3.0F));
    }
}

/// "□ x  −0.0123  out"
void draw_component(const Canvas& canvas, const Box& cell, const EquationRow& row, int joint) {
    const ImFont* const font = canvas.fonts().normal;
    const ImFont* const small = canvas.fonts().small;
    const Box place{cell.x - canvas.px(3.0F), cell.y, cell.width, canvas.line_height(font)};
    const Pointable link = row.row >= 0        ? Pointable::row(row.row)
                           : row.equation >= 0 ? Pointable::equation(joint, row.equation)
                                               : Pointable{};
    canvas.spot(place, link);
    if (link && canvas.lit(link)) {
        canvas.fill(place, theme::kSubject, canvas.px(3.0F));
        canvas.outline(place, theme::kSubjectMark, hairline(canvas), canvas.px(3.0F));
    }
    const float middle = cell.y + 0.5F * canvas.line_height(font);
    const Colour text_ink = row.status == Status::dropped ? theme::kSoft : theme::kInk;
    if (row.status != Status::open) { draw_mark(canvas, {cell.x + canvas.px(5.0F), middle}, row.status); }
    canvas.text({cell.x + canvas.px(15.0F), cell.y}, font, text_ink, row.component);

    const float right = cell.x + std::min(canvas.px(98.0F), cell.width - canvas.px(6.0F));
    const std::string value = live_text(row.value);
    canvas.text({right, cell.y}, font, text_ink, value, Align::right);
    const float drop = std::round(font->Ascent) - std::round(small->Ascent);
    const Colour word_ink = row.status == Status::redundant ? theme::kRedundant : theme::kSoft;
    // the word can be left out: the mark says the same
    const char* const word = word_of(row.status);
    const bool fits = right + canvas.px(6.0F) + canvas.text_width(small, word) <= cell.right();
    if (fits) { canvas.text({right + canvas.px(6.0F), cell.y + drop}, small, word_ink, word); }
}

/// "p1 · in m": the owner of the equation, if several owners are shown, and its unit.
std::string aside_of(const EquationGroup& group) {
    const std::string unit =
        group.unit.empty() || group.unit == "-" ? std::string() : tr("in {0}", group.unit);
    return group.owner + (group.owner.empty() || unit.empty() ? "" : " · ") + unit;
}

/// A formula in at most two lines: one that is wider than the column is broken after "≡".
struct FormulaLines {
    Formula first;
    Formula second;  ///< width 0 if one line is enough
};

FormulaLines formula_lines(const FormulaFonts& fonts, const std::string& markup, float width) {
    static const std::string sign = R"(\equiv)";
    FormulaLines lines{layout_formula(markup, fonts), {}};
    const std::size_t at = markup.find(sign);
    if (lines.first.width <= width || at == std::string::npos) { return lines; }
    lines.first = layout_formula(markup.substr(0, at + sign.size()), fonts);
    lines.second = layout_formula(markup.substr(at + sign.size()), fonts);
    return lines;
}

float draw_formula_at(const Canvas& canvas, Point at, const Formula& formula, const EquationGroup& group) {
    const float baseline = at.y + std::ceil(formula.ascent) + canvas.px(1.0F);
    if (group.joint >= 0) { link_formula(canvas, {at.x, baseline}, formula, group.joint); }
    link_symbols(canvas, {at.x, baseline}, formula, scope_of(group));
    draw_formula(canvas, {at.x, baseline}, formula, theme::kInk, true);
    return std::ceil(formula.ascent + formula.descent);
}

float draw_formula_line(const Canvas& canvas, const Box& box, const EquationGroup& group, Density density) {
    const render::Fonts& fonts = canvas.fonts();
    const std::string aside = shortened_name(*fonts.small, aside_of(group), 0.4F * box.width);
    const float unit_room =
        std::max(canvas.px(44.0F), canvas.text_width(fonts.small, aside) + canvas.px(8.0F));
    Formula formula = layout_formula(group.formula, large_formula_fonts(fonts));
    if (density != Density::roomy || formula.width > box.width - unit_room) {
        formula = layout_formula(group.formula, formula_fonts(fonts));
    }
    if (formula.width > box.width - unit_room) {
        formula = layout_formula(group.formula, small_formula_fonts(fonts));
    }
    FormulaLines lines{formula, {}};
    if (formula.width > box.width) {
        lines = formula_lines(small_formula_fonts(fonts), group.formula, box.width);
    }
    float height = draw_formula_at(canvas, {box.x, box.y}, lines.first, group);
    const float baseline = box.y + std::ceil(lines.first.ascent) + canvas.px(1.0F);
    const bool beside = lines.first.width <= box.width - unit_room;
    const float top = beside ? baseline - std::round(fonts.small->Ascent) : box.y + height;
    canvas.text({box.right(), top}, fonts.small, theme::kSoft, aside, Align::right);
    if (!beside && !aside.empty()) { height += canvas.line_height(fonts.small); }
    if (lines.second.width > 0.0F) {
        height += canvas.px(2.0F);
        height += draw_formula_at(canvas, {box.x + canvas.px(10.0F), box.y + height}, lines.second, group);
    }
    return height + canvas.px(density >= Density::tight ? 3.0F : 5.0F);
}

float draw_group(const Canvas& canvas, const Box& box, const EquationGroup& group, Density density) {
    float height = draw_formula_line(canvas, box, group, density);
    const Box cells = below(box, height);
    for (std::size_t k = 0; k < group.rows.size(); ++k) {
        draw_component(canvas, column_of(cells, static_cast<int>(k), 3), group.rows[k], group.joint);
    }
    height += canvas.line_height(canvas.fonts().normal);
    if (group.choice) { height += choice_table(canvas, below(box, height), *group.choice, density); }
    return height;
}

// about the reciprocal of a component that is zero except for rounding
constexpr double kInfinite = 1e12;

/// "|s_x| ▬▬▬▬── 0.816"
void draw_size(const Canvas& canvas, const Box& cell, int component, double size, bool dropped) {
    const ImFont* const small = canvas.fonts().small;
    const Formula name =
        layout_formula(std::string("|s_") + axis_name(component) + "|", small_formula_fonts(canvas.fonts()));
    const float baseline = cell.y + std::round(small->Ascent);
    draw_formula(canvas, {cell.x, baseline}, name, theme::kInk);

    const std::string number = fixed_text(size, 3);
    const float left = cell.x + canvas.px(34.0F);
    // with large text in a narrow column, the bar is short
    const float room = cell.right() - left - canvas.text_width(small, number) - canvas.px(12.0F);
    const float width = std::clamp(room, 0.0F, canvas.px(58.0F));
    const float height = canvas.px(9.0F);
    const float top = std::round(cell.y + 0.5F * (canvas.line_height(small) - height));
    const auto filled = static_cast<float>(std::min(1.0, size)) * width;
    canvas.fill({left, top, width, height}, theme::kShade);
    canvas.fill({left, top, std::round(filled), height}, dropped ? theme::kAccent : theme::kFaint);
    if (width > 0.0F) { canvas.outline({left, top, width, height}, theme::kLine); }
    canvas.text(
        {left + width + canvas.px(width > 0.0F ? 6.0F : 0.0F), cell.y}, small,
        dropped ? theme::kInk : theme::kSoft, number);
}

/// "without x: κ = 1.15"
void draw_condition(const Canvas& canvas, const Box& cell, int component, double condition, bool dropped) {
    const ImFont* const small = canvas.fonts().small;
    const std::string value = "κ = " + (condition > kInfinite ? std::string("∞") : number_text(condition, 3));
    const std::string whole = tr("without {0}: {1}", axis_name(component), value);
    const bool fits = canvas.text_width(small, whole) < cell.width - canvas.px(6.0F);
    canvas.text({cell.x, cell.y}, small, dropped ? theme::kInk : theme::kSoft, fits ? whole : value);
}

}  // namespace

float equations_panel(
    const Canvas& canvas, const Box& box, const std::vector<EquationGroup>& equations, Density density) {
    const bool open = !equations.empty() && !equations.front().rows.empty() &&
                      equations.front().rows.front().status == Status::open;
    float height = heading(
        canvas, box, tr("Equations"), open ? tr("not added yet") : tr("■ kept   □ left out   ▨ redundant"));
    const float gap = canvas.px(at_density(density, 10.0F, 7.0F, 4.0F));
    for (const EquationGroup& group : equations) {
        height += draw_group(canvas, below(box, height), group, density) + gap;
    }
    return height - (equations.empty() ? 0.0F : gap);
}

float choice_table(const Canvas& canvas, const Box& box, const ChoiceView& choice, Density density) {
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    float height = canvas.px(density >= Density::tight ? 1.0F : 4.0F);
    for (int k = 0; k < 3; ++k) {
        const Box cell = column_of({box.x, box.y + height, box.width, 2.0F * line}, k, 3);
        const auto axis = static_cast<std::size_t>(k);
        const bool dropped = choice.dropped == k;
        if (dropped) {
            const float margin = canvas.px(4.0F);
            canvas.fill(
                {cell.x - margin, cell.y - 1.0F, cell.width - margin, 2.0F * line + 2.0F}, theme::kSubject,
                canvas.px(3.0F));
        }
        draw_size(canvas, cell, k, choice.axis_size[axis], dropped);
        draw_condition(
            canvas, {cell.x, cell.y + line, cell.width, line}, k, choice.pair_condition[axis], dropped);
    }
    height += 2.0F * line;
    if (density >= Density::tight) { return height + canvas.px(2.0F); }
    height += canvas.px(5.0F);
    const std::size_t lines = density == Density::roomy ? 5 : 3;
    const Colour ink = choice.switched ? theme::kWarning : theme::kSoft;
    return height + paragraph(canvas, below(box, height), small, ink, choice.reason, lines);
}

}  // namespace jw::panels
