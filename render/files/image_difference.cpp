#include "render/files/image_difference.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace jw::render {

namespace {

constexpr int kWindow = 8;
constexpr int kStride = 4;
constexpr double kC1 = (0.01 * 255.0) * (0.01 * 255.0);
constexpr double kC2 = (0.03 * 255.0) * (0.03 * 255.0);
constexpr std::array<std::uint8_t, 3> kMark{220, 30, 20};

void check_sizes(const Image& a, const Image& b) {
    if (a.width == b.width && a.height == b.height) { return; }
    const auto size = [](const Image& image) {
        return std::to_string(image.width) + "x" + std::to_string(image.height);
    };
    throw std::invalid_argument("pictures of " + size(a) + " and " + size(b) + " pixels cannot be compared");
}

int distance_of(const std::uint8_t* a, const std::uint8_t* b) {
    int largest = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        largest = std::max(largest, std::abs(int{a[channel]} - int{b[channel]}));
    }
    return largest;
}

/// Luminance of ITU-R BT.601, 0 to 255.
double luminance(const std::uint8_t* rgb) { return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]; }

double similarity_of_window(const Image& a, const Image& b, int left, int top, int columns, int rows) {
    double sum_a = 0.0;
    double sum_b = 0.0;
    double squares_a = 0.0;
    double squares_b = 0.0;
    double products = 0.0;
    for (int y = top; y < top + rows; ++y) {
        for (int x = left; x < left + columns; ++x) {
            const double p = luminance(a.at(x, y));
            const double q = luminance(b.at(x, y));
            sum_a += p;
            sum_b += q;
            squares_a += p * p;
            squares_b += q * q;
            products += p * q;
        }
    }
    const double n = static_cast<double>(columns) * rows;
    const double mean_a = sum_a / n;
    const double mean_b = sum_b / n;
    const double variance_a = squares_a / n - mean_a * mean_a;
    const double variance_b = squares_b / n - mean_b * mean_b;
    const double covariance = products / n - mean_a * mean_b;
    return (2.0 * mean_a * mean_b + kC1) * (2.0 * covariance + kC2) /
           ((mean_a * mean_a + mean_b * mean_b + kC1) * (variance_a + variance_b + kC2));
}

/// Removes the group around a marked pixel from `left`. @return its size
int take_group(PixelMask& left, int x, int y) {
    std::vector<std::pair<int, int>> waiting{{x, y}};
    left.at(x, y) = 0;
    int count = 0;
    while (!waiting.empty()) {
        const auto [px, py] = waiting.back();
        waiting.pop_back();
        ++count;
        for (int ny = std::max(py - 1, 0); ny <= std::min(py + 1, left.height - 1); ++ny) {
            for (int nx = std::max(px - 1, 0); nx <= std::min(px + 1, left.width - 1); ++nx) {
                if (left.at(nx, ny) == 0) { continue; }
                left.at(nx, ny) = 0;
                waiting.emplace_back(nx, ny);
            }
        }
    }
    return count;
}

}  // namespace

PixelMask::PixelMask(int columns, int rows)
    : width(columns),
      height(rows),
      marked(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {}

int PixelMask::count() const { return static_cast<int>(std::ranges::count(marked, 1)); }

int largest_patch(const PixelMask& mask) {
    PixelMask left = mask;
    int largest = 0;
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            if (left.at(x, y) != 0) { largest = std::max(largest, take_group(left, x, y)); }
        }
    }
    return largest;
}

PixelMask differing(const Image& a, const Image& b, int level) {
    check_sizes(a, b);
    PixelMask mask(a.width, a.height);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) { mask.at(x, y) = distance_of(a.at(x, y), b.at(x, y)) > level; }
    }
    return mask;
}

double structural_similarity(const Image& a, const Image& b) {
    check_sizes(a, b);
    double sum = 0.0;
    double windows = 0.0;
    const int columns = std::min(kWindow, a.width);
    const int rows = std::min(kWindow, a.height);
    for (int top = 0; top + rows <= a.height; top += kStride) {
        for (int left = 0; left + columns <= a.width; left += kStride) {
            sum += similarity_of_window(a, b, left, top, columns, rows);
            windows += 1.0;
        }
    }
    return windows > 0.0 ? sum / windows : 1.0;
}

ImageDifference difference_of(const Image& a, const Image& b, int level) {
    check_sizes(a, b);
    ImageDifference difference;
    if (a == b) { return difference; }
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            difference.largest = std::max(difference.largest, distance_of(a.at(x, y), b.at(x, y)));
        }
    }
    const PixelMask mask = differing(a, b, level);
    difference.pixels = mask.count();
    difference.share = static_cast<double>(difference.pixels) / static_cast<double>(mask.marked.size());
    difference.patch = largest_patch(mask);
    difference.similarity = structural_similarity(a, b);
    return difference;
}

Image marked_picture(const Image& base, const PixelMask& mask) {
    Image picture = base;
    for (int y = 0; y < base.height; ++y) {
        for (int x = 0; x < base.width; ++x) {
            std::uint8_t* const pixel = &picture.rgb[3 * base.place(x, y)];
            const auto pale = static_cast<std::uint8_t>(160.0 + 0.37 * luminance(base.at(x, y)));
            for (std::size_t channel = 0; channel < 3; ++channel) {
                pixel[channel] = mask.at(x, y) ? kMark[channel] : pale;
            }
        }
    }
    return picture;
}

}  // namespace jw::render
