#pragma once

#include <string>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "app/session/try/session.hpp"

/// Finds what the pointer is over and the tip beside it.
namespace jw::host {

/// In the panels; of a cell of the matrix, its row and its column.
struct Pointed {
    Pointable row;
    Pointable column;
    Pointable other;
    Pointable symbol;  ///< of a formula, beside what else it is

    Pointable first() const { return other ? other : (symbol ? symbol : (row ? row : column)); }
};

Pointed pointed_at(const std::vector<panels::HotSpot>& spots, panels::Point mouse);

/// Lines with formulas between dollar signs; none where there is nothing to say.
/// @param link  what the pointer is over outside of the matrix
std::vector<std::string> tip_of(const Session& session, const Pointed& pointed, const Pointable& link);

}  // namespace jw::host
