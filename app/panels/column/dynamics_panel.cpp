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

/// The block equation of slide 24, and beside it the meaning of M and Q if there is room.
float draw_slide_24(const Canvas& canvas, const Box& box) {
    const Formula equation = layout_formula(
        R"(\begin{bmatrix} \mathbf{M} & \boldsymbol{\Phi}_q^T \\ \boldsymbol{\Phi}_q & \mathbf{0} \end{bmatrix}
           \begin{bmatrix} \ddot{\mathbf{q}} \\ -\boldsymbol{\lambda} \end{bmatrix} =
           \begin{bmatrix} \mathbf{Q} \\ \boldsymbol{\gamma} \end{bmatrix})",
        formula_fonts(canvas.fonts()));
    const float baseline = box.y + std::ceil(equation.ascent);
    draw_formula(canvas, {box.x, baseline}, equation, theme::kInk);
    const float x = box.x + equation.width + canvas.px(18.0F);
    const float height = std::ceil(equation.ascent) + std::ceil(equation.descent);
    float y = box.y + 0.38F * height;
    for (
        const char* const latex :
        {R"(\mathbf{M} = \operatorname{diag}(m \mathbf{I}, \mathbf{J}'))",
         R"(\mathbf{Q} = [\mathbf{f}; \mathbf{n}' - \tilde{\boldsymbol{\omega}}' \mathbf{J}' \boldsymbol{\omega}'])"}) {
        const Formula formula = layout_formula(latex, small_formula_fonts(canvas.fonts()));
        if (x + formula.width <= box.right()) { draw_formula(canvas, {x, y}, formula, theme::kSoft); }
        y += 0.46F * height;
    }
    return height + canvas.px(4.0F);
}

/// A column of M or Q. Its end is a part of the width: in one table with all columns, and in one of two
/// tables, one below the other, for large text in a narrow column of panels.
struct Heading {
    const char* symbol;
    const char* unit;
    float end_in_one;
    float end_in_two;
};
constexpr std::array kHeadings{
    Heading{"m", "kg", 0.12F, 0.25F}, Heading{R"(\mathbf{J}')", tr_later("xx, yy, zz in kg m²"), 0.42F, 1.0F},
    Heading{R"(\mathbf{f})", "N", 0.71F, 0.5F},
    Heading{
        R"(\mathbf{n}' - \tilde{\boldsymbol{\omega}}' \mathbf{J}' \boldsymbol{\omega}')", "N m", 1.0F, 1.0F}};

/// A number with few digits, whatever its size: masses may differ by several powers of ten.
std::string short_number(double value) {
    constexpr double nothing = 1e-12;
    return with_minus_signs(number_text(std::abs(value) < nothing ? 0.0 : value, 3));
}

/// @param nothing  smaller values are rounding, and are shown as 0
void draw_triple(const Canvas& canvas, const Box& cell, const Vec3& v, double nothing = 0.0) {
    const ImFont* const small = canvas.fonts().small;
    for (int k = 0; k < 3; ++k) {
        const Box column = column_of(cell, k, 3);
        const std::string text = shortened(
            *small, short_number(std::abs(v(k)) < nothing ? 0.0 : v(k)), column.width - canvas.px(2.0F));
        canvas.text({column.right(), column.y}, small, theme::kInk, text, Align::right);
    }
}

/// A symbol and its unit, which is left out if there is no room for it.
void draw_head(const Canvas& canvas, const Box& cell, const char* symbol, const char* unit) {
    const ImFont* const small = canvas.fonts().small;
    const Formula formula = layout_formula(symbol, small_formula_fonts(canvas.fonts()));
    const float gap = canvas.px(4.0F);
    const float room = cell.width - formula.width - 2.0F * gap;
    const std::string text = canvas.text_width(small, unit) <= room ? unit : "";
    const float width = text.empty() ? 0.0F : canvas.text_width(small, text) + gap;
    canvas.text({cell.right(), cell.y}, small, theme::kSoft, text, Align::right);
    const float baseline = cell.y + std::round(small->Ascent);
    draw_formula(canvas, {cell.right() - width - formula.width, baseline}, formula, theme::kInk);
}

void draw_cell_of_body(
    const Canvas& canvas, const Box& cell, const DynamicsView::Body& body, std::size_t column,
    double nothing) {
    switch (column) {
        case 0:
            canvas.text(
                {cell.right(), cell.y}, canvas.fonts().small, theme::kInk, short_number(body.mass),
                Align::right);
            return;
        case 1: return draw_triple(canvas, cell, body.J_local.diagonal());
        case 2: return draw_triple(canvas, cell, body.f, nothing);
        default: return draw_triple(canvas, cell, body.n_local, nothing);
    }
}

/// The columns of kHeadings from `first` to `last`, with one row per body.
float draw_table(
    const Canvas& canvas, const Box& box, const DynamicsView& dynamics, std::size_t most, std::size_t first,
    std::size_t last, float Heading::*end) {
    const ImFont* const small = canvas.fonts().small;
    const double nothing = 1e-9 * dynamics.Q.cwiseAbs().maxCoeff();
    const float line = canvas.line_height(small) + canvas.px(2.0F);
    const float name = 0.15F * box.width;
    const auto cell = [&](std::size_t column, float y) {
        const float width = box.width - name;
        const float from = column == first ? 0.0F : kHeadings[column - 1].*end;
        return Box{box.x + name + from * width, y, (kHeadings[column].*end - from) * width, line};
    };
    float y = box.y;
    for (std::size_t k = first; k <= last; ++k) {
        draw_head(canvas, cell(k, y), kHeadings[k].symbol, tr(kHeadings[k].unit));
    }
    y += line;
    for (std::size_t b = 0; b < std::min(most, dynamics.bodies.size()); ++b) {
        const DynamicsView::Body& body = dynamics.bodies[b];
        canvas.text({box.x, y}, small, theme::kInk, shortened_name(*small, body.name, name));
        for (std::size_t k = first; k <= last; ++k) {
            draw_cell_of_body(canvas, cell(k, y), body, k, nothing);
        }
        y += line;
    }
    if (dynamics.bodies.size() > most) {
        const auto more = static_cast<int>(dynamics.bodies.size() - most);
        canvas.text(
            {box.x, y}, small, theme::kSoft, tr_count(more, "and {0} more body", "and {0} more bodies"));
        y += line;
    }
    return y - box.y;
}

/// M and Q, one row per body.
float draw_bodies(const Canvas& canvas, const Box& box, const DynamicsView& dynamics, std::size_t most) {
    const float number = canvas.text_width(canvas.fonts().small, "−0.0123") + canvas.px(2.0F);
    if (0.29F * 0.85F * box.width >= 3.0F * number) {
        return draw_table(canvas, box, dynamics, most, 0, 3, &Heading::end_in_one);
    }
    const float height = draw_table(canvas, box, dynamics, most, 0, 1, &Heading::end_in_two);
    return height + draw_table(canvas, below(box, height), dynamics, most, 2, 3, &Heading::end_in_two);
}

/// "A  s x −1.2, s y 0.4, p1 x (0)": λ of one joint, those of redundant equations in brackets.
std::string multipliers_line(const DynamicsView& dynamics, std::size_t& first) {
    const std::string& owner = dynamics.multipliers[first].owner;
    std::string text = owner + ":";
    for (bool begun = false; first < dynamics.multipliers.size(); ++first, begun = true) {
        const DynamicsView::Multiplier& m = dynamics.multipliers[first];
        if (m.owner != owner) { break; }
        const std::string value = m.left_out ? "(0)" : short_number(m.lambda);
        text += (begun ? ",  " : "  ") + m.row + " " + value;
    }
    return text;
}

float draw_multipliers(const Canvas& canvas, const Box& box, const DynamicsView& dynamics, std::size_t most) {
    if (dynamics.multipliers.empty()) { return 0.0F; }
    const render::Fonts& fonts = canvas.fonts();
    const Formula lambda = layout_formula(R"(\boldsymbol{\lambda})", formula_fonts(fonts));
    draw_formula(canvas, {box.x, box.y + std::round(fonts.small->Ascent)}, lambda, theme::kInk);
    const std::string about = dynamics.unique() ? tr("of the rows of Φq, joint by joint")
                                                : tr("of the rows of Φq; redundant ones in brackets");
    const float left = lambda.width + canvas.px(6.0F);
    canvas.text(
        {box.x + left, box.y}, fonts.small, theme::kSoft, shortened(*fonts.small, about, box.width - left));
    float height = canvas.line_height(fonts.small) + canvas.px(2.0F);
    std::size_t joints = 0;
    for (std::size_t first = 0; first < dynamics.multipliers.size();) {
        if (joints++ == most) {
            canvas.text({box.x, box.y + height}, fonts.small, theme::kSoft, tr("and more joints"));
            return height + canvas.line_height(fonts.small);
        }
        height += paragraph(
            canvas, below(box, height), fonts.small, theme::kInk, multipliers_line(dynamics, first), 2);
    }
    return height;
}

std::string triple_text(const Vec3& v) {
    return "(" + short_number(v.x()) + ", " + short_number(v.y()) + ", " + short_number(v.z()) + ")";
}

float draw_sums(const Canvas& canvas, const Box& box, const DynamicsView& dynamics) {
    const Energy& energy = dynamics.energy;
    const auto joules = [](double value) { return with_minus_signs(number_text(value, 5)) + " J"; };
    const std::string text =
        tr("kinetic {0}  +  potential {1}  =  {2}", joules(energy.kinetic), joules(energy.potential),
           joules(energy.kinetic + energy.potential)) +
        '\n' + tr("momentum {0} kg m/s", triple_text(dynamics.momentum)) + '\n' +
        tr("angular momentum about the origin {0} kg m²/s", triple_text(dynamics.angular_momentum));
    return paragraph(canvas, box, canvas.fonts().small, theme::kInk, text);
}

}  // namespace

float dynamics_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    if (!view.dynamics) { return 0.0F; }
    const DynamicsView& dynamics = *view.dynamics;
    const bool tight = density >= Density::tight;
    const auto most = at_density<std::size_t>(density, 6, 4, 2);
    float height =
        heading(canvas, box, tr("Equations of motion"), tr("(r, ω′), bodies at their centres of mass"));
    const float gap = canvas.px(tight ? 2.0F : 5.0F);
    if (!tight) { height += draw_slide_24(canvas, below(box, height)); }
    height += draw_bodies(canvas, below(box, height), dynamics, most) + gap;
    if (density == Density::bare) { return height; }
    height += draw_multipliers(canvas, below(box, height), dynamics, most) + gap;
    return height + draw_sums(canvas, below(box, height), dynamics);
}

}  // namespace jw::panels
