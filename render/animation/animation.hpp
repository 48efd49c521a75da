#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "render/files/image.hpp"

/// Files that contain a sequence of pictures.
namespace jw::render {

/// Rectangle of whole pixels.
struct PixelArea {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// The smallest rectangle outside of which two pictures of the same size are equal; nothing if they are
/// equal.
std::optional<PixelArea> changed_area(const Image& before, const Image& now);

/// The part of a picture within `area`, which must lie inside.
Image cut_out(const Image& image, const PixelArea& area);

/// The part of an opaque picture within `area`, to be drawn over the previous picture: unchanged pixels are
/// transparent, so they take almost no space in the file.
Image changes_within(const PixelArea& area, const Image& before, const Image& now);

/// Converts lengths of time to whole ticks. The rounding error of each length is added to the next one, so
/// that the sum of many is right to half a tick.
class Ticks {
public:
    explicit Ticks(double per_second) : per_second_(per_second) {}

    /// Ticks of the next `seconds`, but at least `least`.
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

/// A file of pictures that is written one picture at a time. It stores only what has changed since the
/// previous picture; if a picture is equal to the previous one, the previous one is shown for longer.
class Animation {
public:
    Animation() = default;
    virtual ~Animation() = default;
    Animation(const Animation&) = delete;
    Animation& operator=(const Animation&) = delete;

    /// Shows `image` for this time [s]. All pictures must have the size of the first.
    /// @throws std::invalid_argument for a picture of another size
    void add(Image image, double seconds);
    /// The whole file, after the last picture. @throws std::invalid_argument if there was no picture
    std::vector<std::uint8_t> finish();

protected:
    /// @param area    nothing has changed outside of it
    /// @param before  absent for the first picture
    virtual void write(const Image& image, const PixelArea& area, const Image* before, double seconds) = 0;
    virtual std::vector<std::uint8_t> end() = 0;

private:
    void write_waiting();

    std::optional<Image> shown_;    ///< the picture before the one that waits
    std::optional<Image> waiting_;  ///< waits until its time on the screen is known
    double seconds_ = 0.0;
};

/// Whether a file repeats its pictures without end or shows them once.
enum class Repeat : bool { once, without_end };

/// Animated PNG, with all colours unchanged. The same pictures give the same bytes.
std::unique_ptr<Animation> make_apng(Repeat repeat);

}  // namespace jw::render
