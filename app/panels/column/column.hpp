#pragma once

#include <array>
#include <functional>
#include <vector>

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// A part of the column. It takes the height that it needs, or fills the height that it is given.
struct Block {
    /// Returns the height that it has used.
    std::function<float(const Canvas&, const Box&, Density)> draw;
    bool fills = false;
    std::array<float, 3> least{};  ///< for each density but bare; filling blocks only
    float good = 0.0F;             ///< all filling blocks get it before any gets its `wish`
    float wish = 0.0F;
    int given_up =
        0;  ///< order of removal if there is not enough room: 1 is shown only if there is plenty, 0 stays
};

struct Arrangement {
    Density density = Density::roomy;
    std::vector<Box> boxes;  ///< one per block; height 0 for a block that has nothing to show
};

/// The roomiest density at which everything fits, if necessary without blocks that may be given up. The
/// height that is left goes to the blocks that fill.
Arrangement arrange(const Canvas& canvas, const Box& box, const std::vector<Block>& blocks);

/// The panels for a step of this kind, from the top.
std::vector<Block> blocks_of(const Canvas& canvas, const View& view);

/// Height that a column of this width needs to show everything; `box.height` if that is enough for all
/// panels except those that are shown only if there is plenty of room.
float column_height(const Canvas& canvas, const Box& box, const View& view);

void draw_column(const Canvas& canvas, const Box& box, const View& view);

}  // namespace jw::panels
