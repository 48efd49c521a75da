#include "app/panels/column/panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/formula.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr float kNamePart = 0.13F;
constexpr float kColumnGap = 8.0F;  ///< between two vectors

struct Symbol {
    const char* latex;  ///< empty: nothing in this column
    const char* unit;
};

float row_height(const Canvas& canvas) { return canvas.line_height(canvas.fonts().small) + canvas.px(2.0F); }

/// Value, rate and acceleration of a quantity, with their units.
std::array<std::string, 3> numbers_of(const QuantityMotion& quantity, int decimals) {
    const bool plain = quantity.unit == "-";
    const std::string unit = quantity.unit == "deg" ? "°" : (plain ? "" : " " + quantity.unit);
    const std::string per = plain ? " 1" : unit;
    const int least = quantity.unit == "deg" ? decimals - 2 : decimals;
    return {
        column_text(quantity.value, std::max(1, least)) + unit,
        column_text(quantity.rate, std::max(1, least)) + per + "/s",
        column_text(quantity.acceleration, std::max(1, least)) + per + "/s²"};
}

/// Layout of the quantities. Large text in a narrow column gets fewer decimals, then two lines each.
struct QuantityStyle {
    int decimals = 4;
    bool two_lines = false;
};

constexpr float kQuantityName = 0.34F;  // of the width
constexpr float kQuantityEnds[] = {0.57F, 0.78F, 1.0F};
constexpr float kQuantityEndsAlone[] = {0.32F, 0.64F, 1.0F};

bool fits(const Canvas& canvas, float width, const QuantityMotion& quantity, const QuantityStyle& style) {
    const auto& ends = style.two_lines ? kQuantityEndsAlone : kQuantityEnds;
    float from = style.two_lines ? 0.0F : kQuantityName;
    const auto numbers = numbers_of(quantity, style.decimals);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string text = with_minus_signs(numbers[k]);
        if (canvas.text_width(canvas.fonts().small, text) + canvas.px(10.0F) > (ends[k] - from) * width) {
            return false;
        }
        from = ends[k];
    }
    return true;
}

QuantityStyle quantity_style(
    const Canvas& canvas, float width, const std::vector<QuantityMotion>& quantities) {
    for (const bool two_lines : {false, true}) {
        for (int decimals = 4; decimals >= 2; --decimals) {
            const QuantityStyle style{decimals, two_lines};
            const auto fit = [&](const QuantityMotion& q) { return fits(canvas, width, q, style); };
            if (std::ranges::all_of(quantities, fit)) { return style; }
        }
    }
    return {2, true};
}

void draw_quantity(
    const Canvas& canvas, const Box& row, const QuantityMotion& quantity, const QuantityStyle& style) {
    const ImFont* const small = canvas.fonts().small;
    canvas.square(
        {row.x + canvas.px(5.0F), row.y + 0.5F * canvas.line_height(small)}, canvas.px(8.0F), theme::kAccent,
        quantity.driven);
    const float left = row.x + canvas.px(16.0F);
    const float room = (style.two_lines ? 1.0F : kQuantityName) * row.width - canvas.px(16.0F);
    canvas.text({left, row.y}, small, theme::kInk, shortened(*small, quantity.name, room));
    const auto numbers = numbers_of(quantity, style.decimals);
    const auto& ends = style.two_lines ? kQuantityEndsAlone : kQuantityEnds;
    const float y = row.y + (style.two_lines ? canvas.line_height(small) : 0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
        canvas.text({row.x + ends[k] * row.width, y}, small, theme::kInk, numbers[k], Align::right);
    }
}

/// Numbers side by side, each right-aligned in its own column.
template <class Vector>
void draw_numbers(const Canvas& canvas, const Box& cell, const Vector& v, int decimals) {
    const int count = static_cast<int>(v.size());
    // columns are narrow: one more figure before the point means one less after it
    if (v.cwiseAbs().maxCoeff() >= 10.0) { --decimals; }
    const auto width_with = [&](int places) {
        return canvas.text_width(canvas.fonts().small, with_minus_signs(fixed_text(-0.5, places)));
    };
    const float room = column_of(cell, 0, count).width - canvas.px(2.0F);
    while (decimals > 1 && width_with(decimals) > room) { --decimals; }
    for (int k = 0; k < count; ++k) {
        const Box column = column_of(cell, k, count);
        canvas.text(
            {column.right(), column.y}, canvas.fonts().small, theme::kInk, column_text(v(k), decimals),
            Align::right);
    }
}

/// Draws a symbol and its unit over the columns of a vector, with a line below.
void draw_symbol(const Canvas& canvas, const Box& cell, const Symbol& symbol) {
    if (*symbol.latex == '\0') { return; }
    const ImFont* const small = canvas.fonts().small;
    const Formula formula = layout_formula(symbol.latex, formula_fonts(canvas.fonts()));
    const float gap = canvas.px(6.0F);
    const float width = formula.width + gap + canvas.text_width(small, symbol.unit);
    const float left = std::round(cell.x + 0.5F * (cell.width - width + canvas.px(kColumnGap)));
    const float baseline = cell.y + canvas.px(3.0F) + std::round(small->Ascent);
    draw_formula(canvas, {left, baseline}, formula, theme::kInk);
    canvas.text({left + formula.width + gap, cell.y + canvas.px(3.0F)}, small, theme::kSoft, symbol.unit);
    const float start = cell.x + canvas.px(kColumnGap);
    canvas.fill({start, cell.bottom() - 1.0F, cell.right() - start, hairline(canvas)}, theme::kLine);
}

Box name_cell(const Box& row) { return {row.x, row.y, kNamePart * row.width, row.height}; }

/// Cell of a vector in a row. Of three vectors, the first one, r, gets more width, because its numbers have
/// one more figure; of two, r and p, it gets three sevenths.
Box vector_cell(const Box& row, int index, int count) {
    const float name = kNamePart * row.width;
    const float width = row.width - name;
    const float first = (count == 3 ? 0.36F : 3.0F / 7.0F) * width;
    if (index == 0) { return {row.x + name, row.y, first, row.height}; }
    return column_of({row.x + name + first, row.y, width - first, row.height}, index - 1, count - 1);
}

void draw_name(const Canvas& canvas, const Box& row, const std::string& name) {
    const ImFont* const small = canvas.fonts().small;
    const Box cell = name_cell(row);
    canvas.text({cell.x, cell.y}, small, theme::kInk, shortened_name(*small, name, cell.width));
}

/// Vectors of every body, one row per body; `vectors_of` draws them.
template <class VectorsOf>
float table(
    const Canvas& canvas, const Box& box, const std::vector<BodyMotion>& bodies,
    const std::vector<Symbol>& symbols, std::size_t most, const VectorsOf& vectors_of) {
    const float line = row_height(canvas);
    const int count = static_cast<int>(symbols.size());
    Box row{box.x, box.y, box.width, line + canvas.px(5.0F)};
    for (int k = 0; k < count; ++k) {
        draw_symbol(canvas, vector_cell(row, k, count), symbols[static_cast<std::size_t>(k)]);
    }
    row.y += row.height + canvas.px(2.0F);
    row.height = line;
    for (std::size_t b = 0; b < std::min(most, bodies.size()); ++b) {
        draw_name(canvas, row, bodies[b].body);
        vectors_of(row, bodies[b]);
        row.y += line;
    }
    if (bodies.size() > most) {
        const std::string more =
            tr_count(static_cast<int>(bodies.size() - most), "and {0} more body", "and {0} more bodies");
        canvas.text({row.x, row.y}, canvas.fonts().small, theme::kSoft, more);
        row.y += line;
    }
    return row.y - box.y;
}

}  // namespace

float quantities_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    if (view.quantities.empty()) { return 0.0F; }
    float height = heading(canvas, box, tr("Joints"), tr("■ driven   □ follows"));
    const auto most = at_density<std::size_t>(density, 8, 6, 4);
    const float line = row_height(canvas);
    const QuantityStyle style = quantity_style(canvas, box.width, view.quantities);
    for (std::size_t k = 0; k < std::min(most, view.quantities.size()); ++k) {
        draw_quantity(canvas, {box.x, box.y + height, box.width, line}, view.quantities[k], style);
        height += style.two_lines ? 2.0F * line : line;
    }
    if (view.quantities.size() > most) {
        const std::string more = tr("and {0} more", view.quantities.size() - most);
        canvas.text({box.x, box.y + height}, canvas.fonts().small, theme::kSoft, more);
        height += line;
    }
    if (!view.velocity_note.empty()) {
        const Box rest{box.x, box.y + height + canvas.px(3.0F), box.width, 0.0F};
        height += canvas.px(3.0F) +
                  paragraph(canvas, rest, canvas.fonts().small, theme::kWarning, view.velocity_note, 3);
    }
    return height;
}

float bodies_motion_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    if (view.bodies.empty()) { return 0.0F; }
    float height = heading(canvas, box, tr("Bodies"), tr("x, y, z in the global frame"));
    height += table(
        canvas, below(box, height), view.bodies,
        {{"\\mathbf{r}", "m"}, {"\\dot{\\mathbf{r}}", "m/s"}, {"\\boldsymbol{\\omega}", "rad/s"}},
        at_density<std::size_t>(density, 14, 8, 5), [&](const Box& row, const BodyMotion& body) {
            draw_numbers(canvas, vector_cell(row, 0, 3), body.r, 3);
            draw_numbers(canvas, vector_cell(row, 1, 3), body.r_dot, 2);
            draw_numbers(canvas, vector_cell(row, 2, 3), body.omega, 2);
        });
    if (density != Density::roomy) { return height; }
    height += canvas.px(4.0F);
    return height +
           table(
               canvas, below(box, height), view.bodies,
               {{"", ""}, {"\\ddot{\\mathbf{r}}", "m/s²"}, {"\\dot{\\boldsymbol{\\omega}}", "rad/s²"}},
               at_density<std::size_t>(density, 14, 8, 5), [&](const Box& row, const BodyMotion& body) {
                   draw_numbers(canvas, vector_cell(row, 1, 3), body.r_ddot, 2);
                   draw_numbers(canvas, vector_cell(row, 2, 3), body.omega_dot, 2);
               });
}

float coordinates_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    if (view.bodies.empty()) { return 0.0F; }
    const float height = heading(canvas, box, tr("Coordinates q"), tr("where the bodies start"));
    return height + table(
                        canvas, below(box, height), view.bodies,
                        {{"\\mathbf{r}", tr("x, y, z in m")}, {"\\mathbf{p}", "e₀, e₁, e₂, e₃"}},
                        at_density<std::size_t>(density, 28, 16, 10),
                        [&](const Box& row, const BodyMotion& body) {
                            draw_numbers(canvas, vector_cell(row, 0, 2), body.r, 3);
                            draw_numbers(canvas, vector_cell(row, 1, 2), body.p, 3);
                        });
}

}  // namespace jw::panels
