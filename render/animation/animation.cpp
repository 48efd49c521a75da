#include "render/animation/animation.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace jw::render {

namespace {

bool are_equal(const Image& a, const Image& b, int x, int y, int count) {
    const std::size_t at = a.place(x, y);
    const auto pixels = static_cast<std::size_t>(count);
    return std::equal(&a.rgb[3 * at], &a.rgb[3 * at] + 3 * pixels, &b.rgb[3 * at]) &&
           (a.alpha.empty() || std::equal(&a.alpha[at], &a.alpha[at] + pixels, &b.alpha[at]));
}

void check_size(const Image& image, const Image& first) {
    if (image.width == first.width && image.height == first.height &&
        image.alpha.empty() == first.alpha.empty()) {
        return;
    }
    throw std::invalid_argument(
        "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
        " pixels cannot follow one of " + std::to_string(first.width) + " x " + std::to_string(first.height));
}

}  // namespace

std::optional<PixelArea> changed_area(const Image& before, const Image& now) {
    int top = 0;
    while (top < now.height && are_equal(before, now, 0, top, now.width)) { ++top; }
    if (top == now.height) { return std::nullopt; }
    int bottom = now.height;
    while (are_equal(before, now, 0, bottom - 1, now.width)) { --bottom; }
    int left = now.width;
    int right = 0;
    for (int y = top; y < bottom; ++y) {
        // looks only at pixels that would make the rectangle wider
        int x = 0;
        while (x < left && are_equal(before, now, x, y, 1)) { ++x; }
        left = std::min(left, x);
        x = now.width;
        while (x > right && are_equal(before, now, x - 1, y, 1)) { --x; }
        right = std::max(right, x);
    }
    return PixelArea{left, top, right - left, bottom - top};
}

Image cut_out(const Image& image, const PixelArea& area) {
    Image part{area.width, area.height, {}, {}};
    for (int y = area.y; y < area.y + area.height; ++y) {
        const auto at = static_cast<std::ptrdiff_t>(image.place(area.x, y));
        const auto row = image.rgb.begin() + 3 * at;
        part.rgb.insert(part.rgb.end(), row, row + 3 * area.width);
        if (image.alpha.empty()) { continue; }
        part.alpha.insert(part.alpha.end(), image.alpha.begin() + at, image.alpha.begin() + at + area.width);
    }
    return part;
}

Image changes_within(const PixelArea& area, const Image& before, const Image& now) {
    Image changes = cut_out(now, area);
    changes.alpha.assign(changes.rgb.size() / 3, 255);
    for (int y = 0; y < area.height; ++y) {
        for (int x = 0; x < area.width; ++x) {
            if (!are_equal(before, now, area.x + x, area.y + y, 1)) { continue; }
            const std::size_t at = changes.place(x, y);
            std::fill_n(&changes.rgb[3 * at], 3, std::uint8_t{0});
            changes.alpha[at] = 0;
        }
    }
    return changes;
}

void Animation::add(Image image, double seconds) {
    if (waiting_) {
        check_size(image, *waiting_);
        if (image == *waiting_) {
            seconds_ += seconds;
            return;
        }
        write_waiting();
    }
    waiting_ = std::move(image);
    seconds_ = seconds;
}

void Animation::write_waiting() {
    if (!shown_) {
        write(*waiting_, {0, 0, waiting_->width, waiting_->height}, nullptr, seconds_);
    } else {
        // the two differ: `add` shows the previous picture for longer if the next one is equal
        const PixelArea area = changed_area(*shown_, *waiting_).value();
        write(*waiting_, area, &*shown_, seconds_);
    }
    shown_ = std::move(waiting_);
    waiting_.reset();
}

std::vector<std::uint8_t> Animation::finish() {
    if (!waiting_) { throw std::invalid_argument("an animation needs a picture"); }
    write_waiting();
    return end();
}

}  // namespace jw::render
