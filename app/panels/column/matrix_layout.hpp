#pragma once

#include <string>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "app/session/view/view.hpp"

/// Places of the cells and labels of a matrix. Nothing is drawn here.
namespace jw::panels {

/// Neighbouring rows or columns with the same name.
struct Span {
    std::string name;
    int first = 0;
    int count = 0;
};

struct MatrixLayout {
    Box cells;  ///< of the whole matrix; height of one empty row if there is none
    float cell_width = 0.0F;
    float cell_height = 0.0F;
    Box owners;                 ///< names of joints, left
    Box primitives;             ///< "p1"
    Box components;             ///< "y"; width 0 if a row is too low for text
    Box bodies;                 ///< names above
    Box symbols;                ///< of columns; height 0 if neither these nor those of groups fit
    bool every_symbol = false;  ///< false: one for each group of columns: r, ω′
    Box marks;                  ///< right of the rows: "=" of redundant rows

    Box cell(int row, int column) const;
    Box row(int first, int count = 1) const;
    Box column(int first, int count = 1) const;
};

/// @param at  gives the top left corner, and the largest width and height
MatrixLayout layout_matrix(const Canvas& canvas, const MatrixView& matrix, const Box& at);

/// Height of the matrix and its header with rows of `cell`, at 720.
float matrix_height(const Canvas& canvas, const MatrixView& matrix, float cell);

std::vector<Span> row_owners(const MatrixView& matrix);
/// Groups of rows within an owner: "s", "p1".
std::vector<Span> row_primitives(const MatrixView& matrix);
std::vector<Span> column_owners(const MatrixView& matrix);
/// Groups of columns within an owner: "r", "p", "ω′", "θ".
std::vector<Span> column_kinds(const MatrixView& matrix);

/// "p1 y" has the primitive "p1" and the component "y"; a label of one word has only a primitive.
std::string primitive_of(const std::string& label);
std::string component_of(const std::string& label);

}  // namespace jw::panels
