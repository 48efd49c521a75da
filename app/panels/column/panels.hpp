#pragma once

#include <array>
#include <functional>
#include <vector>

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

/// The panels of the column. Each returns the height that it has used.
namespace jw::panels {

/// The equations as on paper, with the value of every component: a filled square for a kept one, a hollow
/// square with a grey value for one that is left out, a hatched square for a redundant one.
float equations_panel(
    const Canvas& canvas, const Box& box, const std::vector<EquationGroup>& equations, Density density);

/// Reasons for the choice of rows, in three columns under the components: the size of each component of s,
/// and the condition number of the two equations without it.
float choice_table(const Canvas& canvas, const Box& box, const ChoiceView& choice, Density density);

/// Φq as a coloured matrix: blue below 0, orange above 0, blank for 0. The rows of the step are highlighted;
/// redundant rows are hatched and marked "=".
float matrix_panel(const Canvas& canvas, const Box& box, const MatrixView& matrix);
/// @param cell  height of a row, at 720
float matrix_panel_height(const Canvas& canvas, const MatrixView& matrix, float cell);
/// Colour of an entry; `largest` is the largest size in the matrix. The colour depends on the square root of
/// the size, so that a tenth of the largest is still visible.
Colour colour_of_entry(double value, double largest);

/// Newton-Raphson, one line per iteration. The last one is that of the step, and is highlighted. Earlier ones
/// are left out if there is not enough room.
float newton_panel(const Canvas& canvas, const Box& box, const View& view, Density density);

/// Rank, rows, columns, freedoms, redundant rows and Grübler's count in large figures.
float rank_figures(const Canvas& canvas, const Box& box, const View& view, Density density);
/// In words: which equations imply a redundant one, the free motions, and warnings.
float rank_words(const Canvas& canvas, const Box& box, const View& view, Density density);
/// Only the warnings: not assembled, nearly singular.
float rank_warnings(const Canvas& canvas, const Box& box, const View& view, Density density);

/// Angles and displacements of joints with their rates; driven ones are marked.
float quantities_panel(const Canvas& canvas, const Box& box, const View& view, Density density);
/// r, ṙ and ω of every body, in columns of constant width; accelerations too if there is room.
float bodies_motion_panel(const Canvas& canvas, const Box& box, const View& view, Density density);
/// r and p of every body: the start of the free bodies.
float coordinates_panel(const Canvas& canvas, const Box& box, const View& view, Density density);
/// The equations of motion of slide 24 with their numbers: M and Q of each body, λ of each joint, energies
/// and momenta.
float dynamics_panel(const Canvas& canvas, const Box& box, const View& view, Density density);

// ---- small plots over powers of ten, without names of curves and without mouse actions ----------

/// Singular values, largest first: those below the threshold count as zero, and are hollow.
void singular_values_plot(const Canvas& canvas, const Box& box, const RankView& rank);
/// ‖Φ‖ of every iteration; the last one is that of the step.
void convergence_plot(const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows);

// ---- the whole column ---------------------------------------------------------------------------

/// A part of the column. It takes the height that it needs, or fills the height that it is given.
struct Block {
    /// Returns the height that it has used.
    std::function<float(const Canvas&, const Box&, Density)> draw;
    bool fills = false;
    std::array<float, 3> least{};  ///< for each density but bare; filling blocks only
    float good = 0.0F;             ///< all filling blocks get it before any gets its `wish`
    float wish = 0.0F;
    int given_up = 0;  ///< order of removal for want of room: 1 needs plenty of it, 0 stays
};

struct Arrangement {
    Density density = Density::roomy;
    std::vector<Box> boxes;  ///< one per block; height 0 for a block that has nothing to show
};

/// The density with the most space at which everything fits, without the optional blocks if necessary. Blocks
/// that can grow share the remaining height.
Arrangement arrange(const Canvas& canvas, const Box& box, const std::vector<Block>& blocks);

/// The panels for a step of this kind, from the top.
std::vector<Block> blocks_of(const Canvas& canvas, const View& view);

/// Height that a column of this width needs to show everything; `box.height` if that is enough for all
/// panels except those that are shown only if there is plenty of room.
float column_height(const Canvas& canvas, const Box& box, const View& view);

void draw_column(const Canvas& canvas, const Box& box, const View& view);

}  // namespace jw::panels
