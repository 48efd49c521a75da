#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/files/image.hpp"

/// Replaces many colours by a few.
namespace jw::render {

using Rgb = std::array<std::uint8_t, 3>;

/// Counts the colours of pictures, in order to choose those that represent all of them.
class ColourCensus {
public:
    void add(const Image& image);

    /// At most `most` colours. Flat areas (paper, boxes, also pale ones) keep their exact colour; the other
    /// colours are the means of those near them. The same pictures give the same colours.
    std::vector<Rgb> choose(int most) const;

private:
    std::unordered_map<std::uint32_t, std::uint64_t> counts_;  ///< pixels of each colour 0xRRGGBB
    std::uint64_t pixels_ = 0;
};

/// Maps a picture to a few colours. Any other colour is mixed from these in a pattern of 4 x 4 pixels that
/// depends only on the place, so parts that do not move between two pictures do not change.
class ColourTable {
public:
    /// @param colours  1 to 255
    explicit ColourTable(std::vector<Rgb> colours);

    const std::vector<Rgb>& colours() const { return colours_; }

    /// Index of the colour for a pixel at column `x` and row `y` of the picture.
    std::uint8_t index(const std::uint8_t* rgb, int x, int y);

private:
    using Pattern = std::array<std::uint8_t, 16>;  ///< indices, darkest first

    Pattern mixed(const Rgb& colour) const;
    int nearest(const std::array<int, 3>& colour) const;

    std::vector<Rgb> colours_;
    std::vector<int> luminance_;
    std::unordered_map<std::uint32_t, Pattern> patterns_;
    std::uint32_t last_ = 0xFFFFFFFF;  ///< the same colour often comes several times in a row
    const Pattern* last_pattern_ = nullptr;
};

}  // namespace jw::render
