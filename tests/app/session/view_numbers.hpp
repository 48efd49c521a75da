#pragma once

#include <sstream>
#include <string>

#include "app/session/view/view.hpp"

namespace jw::test {

/// Newton table and singular values of a view, every number in full.
inline std::string numbers_of(const View& view) {
    std::ostringstream out;
    out << std::hexfloat;
    for (const NewtonRow& row : view.newton) {
        out << row.iteration << ' ' << row.phi_norm << ' ' << row.largest_row << ' ' << row.largest_value;
        if (row.stepped) {
            out << ' ' << row.delta_norm << ' ' << row.turn_deg << ' ' << row.fraction << ' ' << row.rank;
        }
        out << ' ' << row.note << '\n';
    }
    for (const double value : view.rank.singular_values) { out << value << ' '; }
    out << view.rank.threshold << '\n';
    return out.str();
}

}  // namespace jw::test
