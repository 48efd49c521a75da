#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Rank, rows, columns, freedoms, redundant rows and Grübler's count in large figures.
/// @return height taken
float rank_figures(const Canvas& canvas, const Box& box, const RankView& rank);

/// In words: which equations imply a redundant one, the free motions, and warnings.
float rank_words(const Canvas& canvas, const Box& box, const RankView& rank, Density density);

/// Only the warnings: not assembled, nearly singular.
float rank_warnings(const Canvas& canvas, const Box& box, const RankView& rank);

}  // namespace jw::panels
