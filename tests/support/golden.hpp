#pragma once

#include <string>

#include "render/png.hpp"

/// Pictures that were looked at. `./dev golden` draws them anew; look at each before it is committed.
///
/// Golden images are equal byte for byte on one machine (frames_test.cpp). Across machines the software
/// rasteriser may round differently at edges, by its vector width, so: on average less than half a grey level
/// of 255, and at most 0.5 % of the pixels more than 24 levels away. A moved label, a wrong digit or a
/// missing line is far beyond that.
namespace jw::test {

struct Difference {
    double mean = 0.0;  ///< grey levels
    double far = 0.0;   ///< part of the pixels

    bool is_of_rounding() const;
};
/// @param a, b  of the same size
Difference difference_of(const render::Image& a, const render::Image& b);

/// True where golden pictures are drawn anew instead of compared.
bool draws_goldens();

/// Checks that the picture is the golden one, or draws that anew.
/// @param file  below the root of the sources
void compare_with_golden(const std::string& file, const render::Image& now);

}  // namespace jw::test
