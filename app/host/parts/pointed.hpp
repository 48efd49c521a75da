#pragma once

#include <string>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "app/session/try/session.hpp"

/// Finds the object under the pointer, and the tip for it.
namespace jw::host {

/// Object under the pointer in the panels; for a cell of the matrix, its row and its column.
struct Pointed {
    Pointable row;
    Pointable column;
    Pointable other;
    Pointable symbol;  ///< of a formula, in addition to the others

    Pointable first() const { return other ? other : (symbol ? symbol : (row ? row : column)); }
};

Pointed pointed_at(const std::vector<panels::HotSpot>& spots, panels::Point mouse);

/// Lines of the tip, with formulas between dollar signs; none if there is no tip.
/// @param link  object under the pointer outside of the matrix
std::vector<std::string> tip_of(const Session& session, const Pointed& pointed, const Pointable& link);

}  // namespace jw::host
