#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/image.hpp"

/// Pictures one after the other in one file.
namespace jw::render {

/// Rectangle of whole pixels.
struct PixelArea {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// The smallest rectangle outside of which two pictures of one size are equal; nothing if they are equal.
std::optional<PixelArea> changed_area(const Image& before, const Image& now);

/// The part of a picture within `area`, which must lie inside.
Image cut_out(const Image& image, const PixelArea& area);

/// The part of an opaque picture within `area`, as a picture that is drawn over the one before: what has not
/// changed is transparent, so hardly anything is stored of it.
Image changes_within(const PixelArea& area, const Image& before, const Image& now);

/// Lengths of time in whole ticks. What is rounded off one is added to the next, so that the sum of many is
/// right to half a tick.
class Ticks {
public:
    explicit Ticks(double per_second) : per_second_(per_second) {}

    /// Ticks of the next `seconds`, at least `least` of them.
    int next(double seconds, int least) {
        told_ += seconds * per_second_;
        const long long until = std::max(given_ + least, std::llround(told_));
        const auto ticks = static_cast<int>(until - given_);
        given_ = until;
        return ticks;
    }

private:
    double per_second_;
    double told_ = 0.0;
    long long given_ = 0;
};

/// A file of pictures that is written one picture at a time. Only what has changed since the picture before
/// is in it, and a picture that is equal to the one before prolongs that one.
class Animation {
public:
    Animation() = default;
    virtual ~Animation() = default;
    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;

    /// Shows `image` for that time [s]. All pictures must have the size of the first.
    /// @throws std::invalid_argument for a picture of another size
    void add(Image image, double seconds);
    /// The whole file, after the last picture. @throws std::invalid_argument if there was none
    std::vector<std::uint8_t> finish();

protected:
    /// @param area    outside of which nothing has changed
    /// @param before  absent for the first picture
    virtual void write(const Image& image, const PixelArea& area, const Image* before, double seconds) = 0;
    virtual std::vector<std::uint8_t> end() = 0;

private:
    void write_waiting();

    std::optional<Image> shown_;    ///< before the one that waits
    std::optional<Image> waiting_;  ///< until it is known how long it is shown
    double seconds_ = 0.0;
};

/// A file repeats its pictures without end, or shows them once.
enum class Repeat : bool { once, without_end };

/// Animated PNG: all colours as they are. The same pictures give the same bytes.
std::unique_ptr<Animation> make_apng(Repeat repeat);

}  // namespace jw::render
