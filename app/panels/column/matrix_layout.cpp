#include "app/panels/column/matrix_layout.hpp"

#include "app/session/wording/messages.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

namespace jw::panels {

namespace {

// size of cells, at a height of 720 pixels
constexpr float kHighest = 20.0F;
constexpr float kWidest = 46.0F;
constexpr float kEven = 4.0F;      ///< from this size on, a difference of one pixel per cell would be visible
constexpr float kTextRow = 13.0F;  ///< a row of this height has room for its name

constexpr float kWidestOwner = 84.0F;

constexpr const char* kNormalisation = "pᵀp";

template <class NameOf>
std::vector<Span> spans_of(int count, const NameOf& name_of, const std::vector<Span>& within = {}) {
    std::vector<Span> spans;
    for (int k = 0; k < count; ++k) {
        const std::string name = name_of(static_cast<std::size_t>(k));
        const bool starts = std::ranges::any_of(within, [k](const Span& outer) { return outer.first == k; });
        if (spans.empty() || starts || spans.back().name != name) { spans.push_back({name, k, 0}); }
        ++spans.back().count;
    }
    return spans;
}

int rows_of(const MatrixView& matrix) { return static_cast<int>(matrix.rows.size()); }
int columns_of(const MatrixView& matrix) { return static_cast<int>(matrix.columns.size()); }

float widest(const Canvas& canvas, const std::vector<Span>& spans) {
    float width = 0.0F;
    for (const Span& span : spans) {
        width = std::max(width, canvas.text_width(canvas.fonts().small, span.name));
    }
    return width;
}

float label_line(const Canvas& canvas) { return canvas.line_height(canvas.fonts().small); }

/// Height of the names of bodies and symbols, above the cells.
float header_height(const Canvas& canvas) { return 2.0F * label_line(canvas) + canvas.px(2.0F); }

std::string kind_of(const std::string& symbol) {
    if (symbol.starts_with("ω′")) { return "ω′"; }
    if (symbol.starts_with("ω")) { return "ω"; }
    if (symbol.starts_with("e")) { return "p"; }
    return symbol == "θ" ? symbol : "r";
}

bool every_symbol_fits(const Canvas& canvas, const MatrixView& matrix, float cell_width) {
    return std::ranges::all_of(matrix.columns, [&](const MatrixView::Column& column) {
        return canvas.text_width(canvas.fonts().small, column.symbol) + canvas.px(2.0F) <= cell_width;
    });
}

/// Whole pixels, so that all cells are equally large, unless they are tiny.
float even(float size) { return size >= kEven ? std::floor(size) : std::max(size, 0.0F); }

/// Divides the width into labels, cells and marks.
void lay_out_columns(const Canvas& canvas, const MatrixView& matrix, const Box& at, MatrixLayout& layout) {
    const float gap = canvas.px(6.0F);
    const float owners = std::min(canvas.px(kWidestOwner), widest(canvas, row_owners(matrix)));
    const float primitives = widest(canvas, row_primitives(matrix));
    const float components = layout.cell_height >= canvas.px(kTextRow) ? canvas.px(10.0F) : 0.0F;
    const float marks = canvas.px(16.0F);
    layout.owners = {at.x, 0.0F, std::ceil(owners), 0.0F};
    layout.primitives = {layout.owners.right() + gap, 0.0F, std::ceil(primitives), 0.0F};
    layout.components = {layout.primitives.right() + canvas.px(4.0F), 0.0F, components, 0.0F};
    const float left = layout.components.right() + (rows_of(matrix) > 0 ? gap : 0.0F);

    const auto count = static_cast<float>(std::max(1, columns_of(matrix)));
    const float room = at.right() - marks - left;
    layout.cell_width = std::min(even(room / count), canvas.px(kWidest));
    layout.cells.x = left;
    layout.cells.width = layout.cell_width * static_cast<float>(columns_of(matrix));
    layout.marks = {layout.cells.right(), 0.0F, at.right() - layout.cells.right(), 0.0F};
}

void set_vertical(Box& box, float y, float height) {
    box.y = y;
    box.height = height;
}

}  // namespace

Box MatrixLayout::cell(int row, int column) const {
    return {
        cells.x + cell_width * static_cast<float>(column), cells.y + cell_height * static_cast<float>(row),
        cell_width, cell_height};
}

Box MatrixLayout::row(int first, int count) const {
    return {
        cells.x, cells.y + cell_height * static_cast<float>(first), cells.width,
        cell_height * static_cast<float>(count)};
}

Box MatrixLayout::column(int first, int count) const {
    return {
        cells.x + cell_width * static_cast<float>(first), cells.y, cell_width * static_cast<float>(count),
        cells.height};
}

MatrixLayout layout_matrix(const Canvas& canvas, const MatrixView& matrix, const Box& at) {
    MatrixLayout layout;
    const auto rows = static_cast<float>(std::max(1, rows_of(matrix)));
    const float room = at.height - header_height(canvas) - 1.0F;
    layout.cell_height = std::min(even(room / rows), canvas.px(kHighest));
    lay_out_columns(canvas, matrix, at, layout);

    layout.every_symbol = every_symbol_fits(canvas, matrix, layout.cell_width);
    const float line = label_line(canvas);
    set_vertical(layout.bodies, at.y, line);
    set_vertical(layout.symbols, at.y + line, line);
    layout.bodies.x = layout.symbols.x = layout.cells.x;
    layout.bodies.width = layout.symbols.width = at.right() - layout.cells.x;

    const float top = at.y + header_height(canvas);
    const float height = layout.cell_height * rows;
    for (Box* box : {&layout.cells, &layout.owners, &layout.primitives, &layout.components, &layout.marks}) {
        set_vertical(*box, top, height);
    }
    return layout;
}

float matrix_height(const Canvas& canvas, const MatrixView& matrix, float cell) {
    // the frame around the cells takes one pixel more
    return header_height(canvas) + canvas.px(cell) * static_cast<float>(std::max(1, rows_of(matrix))) + 1.0F;
}

std::vector<Span> row_owners(const MatrixView& matrix) {
    return spans_of(rows_of(matrix), [&](std::size_t k) {
        const MatrixView::Row& row = matrix.rows[k];
        // in normalisation rows, the columns show which body is meant
        return row.label == kNormalisation ? std::string(tr("norms")) : row.owner;
    });
}

std::vector<Span> row_primitives(const MatrixView& matrix) {
    return spans_of(
        rows_of(matrix), [&](std::size_t k) { return primitive_of(matrix.rows[k].label); },
        row_owners(matrix));
}

std::vector<Span> column_owners(const MatrixView& matrix) {
    return spans_of(columns_of(matrix), [&](std::size_t k) { return matrix.columns[k].owner; });
}

std::vector<Span> column_kinds(const MatrixView& matrix) {
    return spans_of(
        columns_of(matrix), [&](std::size_t k) { return kind_of(matrix.columns[k].symbol); },
        column_owners(matrix));
}

std::string primitive_of(const std::string& label) { return label.substr(0, label.rfind(' ')); }

std::string component_of(const std::string& label) {
    const std::size_t space = label.rfind(' ');
    return space == std::string::npos ? std::string() : label.substr(space + 1);
}

}  // namespace jw::panels
