#include "tests/support/golden.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/atomic_file.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {

namespace {

constexpr double kMeanDifference = 0.5;
constexpr int kFarLevels = 24;
constexpr double kFarPixels = 0.005;

}  // namespace

bool Difference::is_of_rounding() const { return mean < kMeanDifference && far < kFarPixels; }

Difference difference_of(const render::Image& a, const render::Image& b) {
    Difference difference;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            int largest = 0;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const int d = std::abs(int(a.at(x, y)[channel]) - int(b.at(x, y)[channel]));
                difference.mean += d / 3.0;
                largest = std::max(largest, d);
            }
            difference.far += largest > kFarLevels ? 1.0 : 0.0;
        }
    }
    const double pixels = static_cast<double>(a.width) * a.height;
    return {difference.mean / pixels, difference.far / pixels};
}

bool draws_goldens() { return std::getenv("JW_REGENERATE_GOLDEN") != nullptr; }

void compare_with_golden(const std::string& file, const render::Image& now) {
    const std::string path = std::string(JW_SOURCE_ROOT) + "/" + file;
    if (draws_goldens()) {
        render::write_file_atomically(path, render::encode_png(now));
        return;
    }
    const render::Image then = read_png(path);
    REQUIRE(now.width == then.width);
    REQUIRE(now.height == then.height);
    const Difference difference = difference_of(now, then);
    INFO(file << ": mean " << difference.mean << " levels, far " << 100.0 * difference.far << " %");
    CHECK(difference.is_of_rounding());
}

}  // namespace jw::test
