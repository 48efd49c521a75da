#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render/files/image.hpp"

/// Difference between two pictures of the same size, in measures that detect different things.
namespace jw::render {

/// Marked pixels of a picture, top row first.
struct PixelMask {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> marked;  ///< 1 or 0

    PixelMask(int columns, int rows);
    std::uint8_t& at(int x, int y) { return marked[index(x, y)]; }
    bool at(int x, int y) const { return marked[index(x, y)] != 0; }
    int count() const;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Number of pixels in the largest group of marked pixels that touch by an edge or a corner. Rounding changes
/// single pixels in different places; a line or a digit is a group.
int largest_patch(const PixelMask& mask);

struct ImageDifference {
    int largest = 0;          ///< largest difference of a channel, of 255
    int pixels = 0;           ///< number of pixels that differ by more than the level
    double share = 0.0;       ///< the same, as a share of all pixels
    int patch = 0;            ///< size of the largest group of them
    double similarity = 1.0;  ///< structural similarity, 1 for equal pictures
};

/// @param level  of 255: a pixel differs if one of its channels differs by more than this
/// @throws std::invalid_argument if the sizes differ
ImageDifference difference_of(const Image& a, const Image& b, int level);

/// The pixels that differ by more than `level`.
PixelMask differing(const Image& a, const Image& b, int level);

/// Mean structural similarity of the luminance over windows of 8 x 8 pixels, every four pixels.
/// @source Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to structural
///         similarity", IEEE Trans. Image Processing 13 (2004), eq. 13, with C1 = (0.01 · 255)²,
///         C2 = (0.03 · 255)²
double structural_similarity(const Image& a, const Image& b);

/// `base` in pale grey, with the marked pixels in red, to show where they are.
Image marked_picture(const Image& base, const PixelMask& mask);

}  // namespace jw::render
