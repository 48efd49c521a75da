#include "app/panels/column/matrix_layout.hpp"

#include <catch2/catch.hpp>

#include "app/panels/column/panels.hpp"
#include "tests/app/panels/support.hpp"
#include "tests/app/panels/views.hpp"

namespace jw::panels::test {

namespace {

MatrixView zeros(int joints, int bodies) {
    MatrixView matrix;
    constexpr const char* labels[] = {"s x", "s y", "s z", "p1 x", "p1 y"};
    for (int row = 0; row < 5 * joints; ++row) {
        matrix.rows.push_back({"J" + std::to_string(row / 5), labels[row % 5], false, false});
    }
    constexpr const char* symbols[] = {"x", "y", "z", "ω′x", "ω′y", "ω′z"};
    for (int column = 0; column < 6 * bodies; ++column) {
        matrix.columns.push_back({"B" + std::to_string(column / 6), symbols[column % 6]});
    }
    matrix.values = MatrixX::Zero(5 * joints, 6 * bodies);
    return matrix;
}

}  // namespace

TEST_CASE("cells, labels and marks keep inside the box and apart", "[panels][matrix]") {
    const Surface surface;
    const Canvas canvas = surface.canvas();
    const auto [joints, bodies] = GENERATE(table<int, int>({{0, 1}, {1, 1}, {4, 3}, {7, 7}, {100, 80}}));
    const Box at{780.0F, 100.0F, 480.0F, GENERATE(120.0F, 300.0F, 560.0F)};
    CAPTURE(joints, bodies, at.height);
    const MatrixLayout layout = layout_matrix(canvas, zeros(joints, bodies), at);
    for (const Box& box : {layout.cells, layout.owners, layout.bodies, layout.symbols, layout.marks}) {
        CHECK(with_fringe(at).contains(box));
    }
    CHECK(layout.owners.right() <= layout.primitives.x);
    CHECK(layout.primitives.right() <= layout.components.x);
    CHECK(layout.components.right() <= layout.cells.x);
    CHECK(layout.symbols.bottom() <= layout.cells.y);
    CHECK(layout.cell_width > 0.0F);
    CHECK(layout.cell_height > 0.0F);
}

TEST_CASE("cells tile the matrix in whole pixels", "[panels][matrix]") {
    const Surface surface;
    const MatrixLayout layout =
        layout_matrix(surface.canvas(), zeros(4, 3), {780.0F, 100.0F, 480.0F, 300.0F});
    CHECK(layout.cell_width == std::floor(layout.cell_width));
    CHECK(layout.cell_height == std::floor(layout.cell_height));
    CHECK(layout.cell(19, 17).right() == layout.cells.right());
    CHECK(layout.cell(19, 17).bottom() == layout.cells.bottom());
    CHECK(layout.row(5, 5).y == layout.cell(5, 0).y);
    CHECK(layout.column(6, 6).right() == layout.cell(0, 11).right());
}

TEST_CASE("neighbours with one name share it, but never across joints or bodies", "[panels][matrix]") {
    const MatrixView matrix = zeros(2, 2);
    const auto primitives = row_primitives(matrix);
    REQUIRE(primitives.size() == 4);
    CHECK(primitives[1].name == "p1");
    CHECK(primitives[1].first == 3);
    CHECK(primitives[1].count == 2);
    const auto kinds = column_kinds(matrix);
    REQUIRE(kinds.size() == 4);
    CHECK(kinds[2].name == "r");
    CHECK(kinds[2].first == 6);
    CHECK(kinds[3].name == "ω′");
    CHECK(primitive_of("n1 pair a") == "n1 pair");
    CHECK(component_of("n1 pair a") == "a");
    CHECK(component_of("θ").empty());
}

TEST_CASE("entries are the darker the larger, blue below and orange above zero", "[panels][matrix]") {
    const auto lightness = [](Colour c) { return c.r + c.g + c.b; };
    CHECK(lightness(colour_of_entry(1.0, 1.0)) < lightness(colour_of_entry(0.1, 1.0)));
    CHECK(lightness(colour_of_entry(-1.0, 1.0)) < lightness(colour_of_entry(-0.1, 1.0)));
    CHECK(lightness(colour_of_entry(1e-6, 1.0)) < 3.0F);  // still not white
    CHECK(colour_of_entry(0.5, 1.0).r > colour_of_entry(0.5, 1.0).b);
    CHECK(colour_of_entry(-0.5, 1.0).b > colour_of_entry(-0.5, 1.0).r);
}

TEST_CASE("a zero of the structure is not drawn", "[panels][matrix]") {
    Surface surface;
    const Box box{780.0F, 100.0F, 480.0F, 300.0F};
    MatrixView matrix = zeros(1, 1);
    matrix.values(2, 2) = 1.0;  // the legend is drawn in both
    matrix_panel(surface.canvas(), box, matrix);
    const int without = surface.vertices();
    surface.clear();
    matrix.values(0, 0) = 1e-13;
    matrix_panel(surface.canvas(), box, matrix);
    CHECK(surface.vertices() == without);
    surface.clear();
    matrix.values(0, 0) = 1e-3;
    matrix_panel(surface.canvas(), box, matrix);
    CHECK(surface.vertices() > without);
}

}  // namespace jw::panels::test
