#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/image.hpp"

/// Few colours in the place of many.
namespace jw::render {

using Rgb = std::array<std::uint8_t, 3>;

/// Counts the colours of pictures, to choose those that stand for all of them.
class ColourCensus {
public:
    void add(const Image& image);

    /// At most `most` colours. Flat areas (paper, boxes, the pale ones among them) keep their very colour;
    /// the others are the middles of what is near them. The same pictures give the same colours.
    std::vector<Rgb> choose(int most) const;

private:
    std::unordered_map<std::uint32_t, std::uint64_t> counts_;  ///< pixels of each colour 0xRRGGBB
    std::uint64_t pixels_ = 0;
};

/// Colours of a picture that has few. A colour that is not among them is mixed of some that are, in a pattern
/// of 4 x 4 pixels that depends on the place alone: what does not move between two pictures stays as it is.
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
    std::uint32_t last_ = 0xFFFFFFFF;  ///< colours come in runs
    const Pattern* last_pattern_ = nullptr;
};

}  // namespace jw::render
