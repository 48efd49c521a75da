#include "app/panels/column/panels.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/column/matrix_layout.hpp"
#include "app/panels/parts/formula.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

// rounding of products of sines and cosines; smaller entries are structural zeros
constexpr double kBlank = 1e-12;

std::string name_of(CoordinateChoice choice) {
    switch (choice) {
        case CoordinateChoice::true_euler_parameters: return tr("in (r, p)");
        case CoordinateChoice::modified_euler_parameters: return tr("in (r, p), modified");
        case CoordinateChoice::omega_local: return tr("in (r, ω′)");
        case CoordinateChoice::omega_global: break;
    }
    return tr("in (r, ω)");
}

double largest_of(const MatrixView& matrix) {
    return matrix.values.size() == 0 ? 0.0 : matrix.values.cwiseAbs().maxCoeff();
}

/// "−1 ▮▮▯▮▮ 1" at the right end of the heading.
/// @param room  width beside the title; if it is too small, there is no legend
void draw_legend(const Canvas& canvas, const Box& box, double largest, float room) {
    const ImFont* const small = canvas.fonts().small;
    const std::string high = number_text(largest, 2);
    const float around = canvas.text_width(small, high + "−" + high) + canvas.px(22.0F);
    const float width = std::min(canvas.px(72.0F), room - around);
    if (width < canvas.px(24.0F)) { return; }
    const float right = box.right() - canvas.text_width(small, high) - canvas.px(5.0F);
    const float top = box.y + canvas.px(5.0F);
    constexpr int steps = 24;
    for (int k = 0; k < steps; ++k) {
        const double value = largest * (2.0 * (k + 0.5) / steps - 1.0);
        const Box step = column_of({right - width, top, width, canvas.px(9.0F)}, k, steps);
        canvas.fill(step, colour_of_entry(value, largest));
    }
    canvas.outline({right - width, top, width, canvas.px(9.0F)}, theme::kLine);
    const float y = box.y + canvas.px(2.0F);
    canvas.text({box.right(), y}, small, theme::kSoft, high, Align::right);
    canvas.text({right - width - canvas.px(5.0F), y}, small, theme::kSoft, "-" + high, Align::right);
}

void draw_rows_background(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    canvas.fill(layout.cells, theme::kWhite);
    for (std::size_t k = 0; k < matrix.rows.size(); ++k) {
        if (!matrix.rows[k].subject) { continue; }
        const Box row = layout.row(static_cast<int>(k));
        const float left = layout.owners.x - canvas.px(6.0F);
        canvas.fill({left, row.y, layout.cells.right() - left, row.height}, theme::kSubject);
        canvas.fill({left, row.y, canvas.px(3.0F), row.height}, theme::kSubjectMark);
    }
}

/// Draws the shade of redundant rows; call it before the entries are drawn, which keep their colours.
void draw_redundant_rows(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    for (std::size_t k = 0; k < matrix.rows.size(); ++k) {
        if (!matrix.rows[k].redundant) { continue; }
        const Box row = layout.row(static_cast<int>(k));
        canvas.fill(row, theme::kRedundantShade);
        canvas.hatch(row, render::with_alpha(theme::kRedundant, 0.6F), canvas.px(6.0F));
    }
}

void draw_entry(const Canvas& canvas, const Box& cell, double value, double largest) {
    if (std::abs(value) < kBlank) { return; }
    const Colour colour = colour_of_entry(value, largest);
    canvas.fill(cell, colour);
    // two decimals, if they fit and are not zero
    if (std::abs(value) < 0.005 || cell.width < canvas.px(36.0F) || cell.height < canvas.px(14.0F)) {
        return;
    }
    const ImFont* const small = canvas.fonts().small;
    const std::string text = fixed_text(value, 2);
    const bool dark = std::abs(value) > 0.35 * largest;
    const float top = cell.y + 0.5F * (cell.height - canvas.line_height(small));
    canvas.text({cell.centre().x, top}, small, dark ? theme::kWhite : theme::kInk, text, Align::centre);
}

void draw_entries(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    const double largest = largest_of(matrix);
    for (Eigen::Index i = 0; i < matrix.values.rows(); ++i) {
        for (Eigen::Index j = 0; j < matrix.values.cols(); ++j) {
            const Box cell = layout.cell(static_cast<int>(i), static_cast<int>(j));
            draw_entry(canvas, cell, matrix.values(i, j), largest);
        }
    }
}

void draw_grid(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    const Box& cells = layout.cells;
    const Colour fine = render::with_alpha(theme::kLine, 0.7F);
    const auto rows = static_cast<int>(matrix.rows.size());
    const auto columns = static_cast<int>(matrix.columns.size());
    const float hair = hairline(canvas);
    for (int k = 1; k < rows && layout.cell_height > canvas.px(6.0F); ++k) {
        canvas.fill({cells.x, layout.row(k).y, cells.width, 1.0F}, fine);
    }
    for (int k = 1; k < columns && layout.cell_width > canvas.px(4.0F); ++k) {
        canvas.fill({layout.column(k).x, cells.y, 1.0F, cells.height}, fine);
    }
    const float text_height = canvas.fonts().small->FontSize;
    float height_above = 0.0F;
    for (const Span& span : row_owners(matrix)) {
        const Box its_rows = layout.row(span.first, span.count);
        // names that are closer than a line of text leave no room for a separating line
        const bool among_names = std::min(its_rows.height, height_above) >= text_height;
        const float left = among_names ? layout.owners.x : cells.x;
        if (span.first > 0) { canvas.fill({left, its_rows.y, cells.right() - left, hair}, theme::kFaint); }
        height_above = its_rows.height;
    }
    for (const Span& span : column_owners(matrix)) {
        if (span.first > 0) {
            canvas.fill(
                {layout.column(span.first).x, layout.bodies.y, hair, cells.bottom() - layout.bodies.y},
                theme::kFaint);
        }
    }
    canvas.outline(
        {cells.x - 1.0F, cells.y - 1.0F, cells.width + 2.0F, cells.height + 2.0F}, theme::kSoft, hair);
}

/// Names down the left side, each in the middle of its rows. A name that would touch another is left out.
class RowNames {
public:
    RowNames(const Canvas& canvas, const Box& where, Colour colour)
        : canvas_(canvas), where_(where), colour_(colour), free_from_(where.y - canvas.px(4.0F)) {}

    void draw(const Box& rows, std::string_view name) {
        const ImFont* const small = canvas_.fonts().small;
        const float inked =
            0.88F * small->FontSize;  // from the top of capitals to the foot of p, with a small gap
        if (rows.centre().y - 0.5F * inked < free_from_) { return; }
        const float top = std::round(rows.centre().y - 0.5F * canvas_.line_height(small));
        canvas_.text({where_.x, top}, small, colour_, shortened_name(*small, name, where_.width + 1.0F));
        free_from_ = rows.centre().y + 0.5F * inked;
    }

private:
    const Canvas& canvas_;
    Box where_;
    Colour colour_;
    float free_from_;
};

void draw_row_names(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    RowNames owners(canvas, layout.owners, theme::kInk);
    for (const Span& span : row_owners(matrix)) {
        owners.draw(layout.row(span.first, span.count), span.name);
    }
    RowNames primitives(canvas, layout.primitives, theme::kSoft);
    for (const Span& span : row_primitives(matrix)) {
        primitives.draw(layout.row(span.first, span.count), span.name);
    }
    if (layout.components.width <= 0.0F) { return; }
    RowNames components(canvas, layout.components, theme::kSoft);
    for (std::size_t k = 0; k < matrix.rows.size(); ++k) {
        components.draw(layout.row(static_cast<int>(k)), component_of(matrix.rows[k].label));
    }
}

void draw_column_names(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    const ImFont* const small = canvas.fonts().small;
    const auto centred = [&](const Box& columns, float y, float room, Colour colour, std::string_view name) {
        canvas.text(
            {columns.centre().x, y}, small, colour, shortened_name(*small, name, room), Align::centre);
    };
    const float least = canvas.text_width(small, "nn…n");
    for (const Span& span : column_owners(matrix)) {
        const Box columns = layout.column(span.first, span.count);
        const bool last = span.first + span.count == static_cast<int>(matrix.columns.size());
        const float room = columns.width - canvas.px(3.0F);
        if (last && canvas.text_width(small, span.name) > room) {
            // there is room beyond the last column
            const float more = layout.marks.right() - columns.x - canvas.px(3.0F);
            canvas.text(
                {columns.x + canvas.px(3.0F), layout.bodies.y}, small, theme::kInk,
                shortened_name(*small, span.name, more));
        } else if (room >= std::min(least, canvas.text_width(small, span.name))) {
            // a name of one letter and dots would be useless
            centred(columns, layout.bodies.y, room, theme::kInk, span.name);
        }
    }
    if (layout.every_symbol) {
        for (std::size_t k = 0; k < matrix.columns.size(); ++k) {
            const Box column = layout.column(static_cast<int>(k));
            centred(column, layout.symbols.y, 2.0F * column.width, theme::kSoft, matrix.columns[k].symbol);
        }
        return;
    }
    for (const Span& span : column_kinds(matrix)) {
        const Box columns = layout.column(span.first, span.count);
        centred(columns, layout.symbols.y, columns.width + canvas.px(6.0F), theme::kSoft, span.name);
    }
}

/// Lets rows and columns be pointed at, and frames those that belong to the object under the pointer.
void link_matrix(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    const float thick = std::max(1.0F, canvas.px(2.0F));
    const auto columns = static_cast<int>(matrix.columns.size());
    const auto rows = static_cast<int>(matrix.rows.size());
    // highlighted neighbours share one frame
    const auto mark = [&](int count, const auto& pointable_of, const auto& box_of) {
        for (int k = 0; k < count; ++k) { canvas.spot(box_of(k, 1), pointable_of(k)); }
        for (int k = 0; k < count;) {
            int end = k;
            while (end < count && canvas.lit(pointable_of(end))) { ++end; }
            if (end > k) { canvas.outline(box_of(k, end - k), theme::kSubjectMark, thick, canvas.px(2.0F)); }
            k = end + 1;
        }
    };
    mark(columns, &Pointable::column, [&](int first, int count) {
        const Box column = layout.column(first, count);
        return Box{column.x, layout.bodies.y, column.width, layout.cells.bottom() - layout.bodies.y};
    });
    mark(rows, &Pointable::row, [&](int first, int count) {
        const Box row = layout.row(first, count);
        return Box{layout.owners.x, row.y, layout.cells.right() - layout.owners.x, row.height};
    });
}

void draw_redundant_marks(const Canvas& canvas, const MatrixView& matrix, const MatrixLayout& layout) {
    for (std::size_t k = 0; k < matrix.rows.size(); ++k) {
        if (!matrix.rows[k].redundant) { continue; }
        const Box row = layout.row(static_cast<int>(k));
        // "=" as two bars, as high as the row allows
        const float bar = std::max(1.0F, std::round(0.12F * row.height));
        const float left = layout.marks.x + canvas.px(5.0F);
        const float middle = std::round(row.centre().y);
        canvas.fill({left, middle - std::round(1.5F * bar), canvas.px(9.0F), bar}, theme::kRedundant);
        canvas.fill({left, middle + std::round(0.5F * bar), canvas.px(9.0F), bar}, theme::kRedundant);
    }
}

}  // namespace

Colour colour_of_entry(double value, double largest) {
    if (largest <= 0.0) { return theme::kWhite; }
    // the smallest nonzero entry still has a tint
    constexpr float faintest = 0.12F;
    const auto strength = static_cast<float>(std::sqrt(std::min(1.0, std::abs(value) / largest)));
    const Colour hue = value < 0.0 ? theme::kNegative : theme::kPositive;
    return render::mix(theme::kWhite, hue, faintest + (1.0F - faintest) * strength);
}

float matrix_panel(const Canvas& canvas, const Box& box, const MatrixView& matrix) {
    const std::string title = name_of(matrix.choice) + "   " + std::to_string(matrix.rows.size()) + " × " +
                              std::to_string(matrix.columns.size());
    const float top = heading(canvas, box, "\\boldsymbol{\\Phi}_q", title, {});
    const double largest = largest_of(matrix);
    const float room = box.width - canvas.px(4.0F) - canvas.text_width(canvas.fonts().bold, title) -
                       layout_formula("\\boldsymbol{\\Phi}_q", formula_fonts(canvas.fonts())).width;
    if (largest > 0.0) { draw_legend(canvas, box, largest, room); }

    const Box rest{box.x, box.y + top, box.width, box.height - top};
    const MatrixLayout layout = layout_matrix(canvas, matrix, rest);
    draw_rows_background(canvas, matrix, layout);
    draw_redundant_rows(canvas, matrix, layout);
    draw_entries(canvas, matrix, layout);
    draw_grid(canvas, matrix, layout);
    draw_redundant_marks(canvas, matrix, layout);
    draw_row_names(canvas, matrix, layout);
    draw_column_names(canvas, matrix, layout);
    link_matrix(canvas, matrix, layout);
    if (matrix.rows.empty()) {
        const ImFont* const small = canvas.fonts().small;
        const float y = layout.cells.centre().y - 0.5F * canvas.line_height(small);
        canvas.text({layout.cells.centre().x, y}, small, theme::kSoft, tr("no equations yet"), Align::centre);
    }
    return layout.cells.bottom() - box.y;
}

float matrix_panel_height(const Canvas& canvas, const MatrixView& matrix, float cell) {
    return heading_height(canvas) + matrix_height(canvas, matrix, cell);
}

}  // namespace jw::panels
