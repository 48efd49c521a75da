#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <random>

#include "render/files/image_difference.hpp"

namespace jw::render::test {
namespace {

Image noise(int width, int height, unsigned seed) {
    Image image{width, height, {}};
    std::mt19937 random(seed);
    image.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::uint8_t& byte : image.rgb) { byte = static_cast<std::uint8_t>(random() % 256); }
    return image;
}

void set_pixel(Image& image, int x, int y, std::uint8_t value) {
    const auto at = 3 * static_cast<std::size_t>(y * image.width + x);
    image.rgb[at] = image.rgb[at + 1] = image.rgb[at + 2] = value;
}

/// Size of the largest group, by spreading labels until nothing changes: slow, and not a flood fill.
int patch_by_labels(const PixelMask& mask) {
    std::vector<int> label(mask.marked.size(), 0);
    for (std::size_t k = 0; k < label.size(); ++k) {
        label[k] = mask.marked[k] != 0 ? static_cast<int>(k) + 1 : 0;
    }
    const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * mask.width + x); };
    for (bool grows = true; grows;) {
        grows = false;
        for (int y = 0; y < mask.height; ++y) {
            for (int x = 0; x < mask.width; ++x) {
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int nx = x + dx;
                        const int ny = y + dy;
                        if (nx < 0 || ny < 0 || nx >= mask.width || ny >= mask.height) { continue; }
                        int& here = label[index(x, y)];
                        const int there = label[index(nx, ny)];
                        if (here != 0 && there > here) {
                            here = there;
                            grows = true;
                        }
                    }
                }
            }
        }
    }
    std::map<int, int> sizes;
    int largest = 0;
    for (const int l : label) {
        if (l != 0) { largest = std::max(largest, ++sizes[l]); }
    }
    return largest;
}

/// Structural similarity as the paper writes it, with means first.
double similarity_by_definition(const Image& a, const Image& b) {
    const auto grey = [](const Image& image, int x, int y) {
        const std::uint8_t* const p = image.at(x, y);
        return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
    };
    double sum = 0.0;
    int windows = 0;
    for (int top = 0; top + 8 <= a.height; top += 4) {
        for (int left = 0; left + 8 <= a.width; left += 4) {
            double ma = 0.0;
            double mb = 0.0;
            for (int k = 0; k < 64; ++k) {
                ma += grey(a, left + k % 8, top + k / 8) / 64.0;
                mb += grey(b, left + k % 8, top + k / 8) / 64.0;
            }
            double va = 0.0;
            double vb = 0.0;
            double c = 0.0;
            for (int k = 0; k < 64; ++k) {
                const double da = grey(a, left + k % 8, top + k / 8) - ma;
                const double db = grey(b, left + k % 8, top + k / 8) - mb;
                va += da * da / 64.0;
                vb += db * db / 64.0;
                c += da * db / 64.0;
            }
            sum += (2.0 * ma * mb + 6.5025) * (2.0 * c + 58.5225) /
                   ((ma * ma + mb * mb + 6.5025) * (va + vb + 58.5225));
            ++windows;
        }
    }
    return sum / windows;
}

}  // namespace

TEST_CASE("equal pictures do not differ", "[difference]") {
    const Image image = noise(37, 23, 1);
    const ImageDifference none = difference_of(image, image, 0);
    CHECK(none.largest == 0);
    CHECK(none.pixels == 0);
    CHECK(none.patch == 0);
    CHECK(none.similarity == 1.0);
    CHECK(structural_similarity(image, image) == Approx(1.0));
}

TEST_CASE("a line is a patch, as many single pixels are not", "[difference]") {
    const Image before{40, 30, std::vector<std::uint8_t>(3 * 40 * 30, 200)};
    Image line = before;
    Image dots = before;
    for (int k = 0; k < 12; ++k) {
        set_pixel(line, 5 + k, 5 + k, 100);  // a diagonal touches by corners
        set_pixel(dots, 3 * k, 10, 100);
    }
    CHECK(difference_of(before, line, 8).patch == 12);
    CHECK(difference_of(before, dots, 8).patch == 1);
    CHECK(difference_of(before, line, 8).pixels == 12);
    CHECK(difference_of(before, line, 8).largest == 100);
    CHECK(difference_of(before, line, 100).pixels == 0);
    CHECK(difference_of(before, line, 99).pixels == 12);
}

TEST_CASE("patches are those that labels find, in random masks", "[difference]") {
    for (unsigned seed = 0; seed < 60; ++seed) {
        INFO("seed " << seed);
        std::mt19937 random(seed);
        PixelMask mask(1 + static_cast<int>(random() % 24), 1 + static_cast<int>(random() % 24));
        for (std::uint8_t& m : mask.marked) { m = random() % 10 < seed % 10 ? 1 : 0; }
        CHECK(largest_patch(mask) == patch_by_labels(mask));
    }
}

TEST_CASE("structural similarity is that of its definition", "[difference]") {
    const Image a = noise(48, 40, 3);
    Image b = a;
    CHECK(
        structural_similarity(a, noise(48, 40, 4)) == Approx(similarity_by_definition(a, noise(48, 40, 4))));
    for (std::size_t k = 0; k < b.rgb.size(); k += 7) {
        b.rgb[k] = static_cast<std::uint8_t>(b.rgb[k] ^ 0x0FU);
    }
    CHECK(structural_similarity(a, b) == Approx(similarity_by_definition(a, b)));
    CHECK(structural_similarity(a, b) < 1.0);
}

TEST_CASE("pictures of different sizes are no comparison", "[difference]") {
    CHECK_THROWS_WITH(
        difference_of(noise(4, 4, 1), noise(5, 4, 1), 0),
        "pictures of 4x4 and 5x4 pixels cannot be compared");
}

}  // namespace jw::render::test
