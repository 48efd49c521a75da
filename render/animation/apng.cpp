#include <algorithm>
#include <span>
#include <string_view>

#include "render/animation/animation.hpp"
#include "render/png.hpp"

namespace jw::render {

namespace {

using PngBytes = std::vector<std::uint8_t>;

constexpr std::size_t kSignature = 8;  // bytes before the first chunk

void put(PngBytes& bytes, std::uint32_t value, int count) {
    for (int k = count - 1; k >= 0; --k) { bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k))); }
}

void put_chunk(PngBytes& file, std::string_view type, std::span<const std::uint8_t> data) {
    put(file, static_cast<std::uint32_t>(data.size()), 4);
    const std::size_t begin = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    put(file, png_checksum(std::span(file).subspan(begin)), 4);
}

/// Data of the first chunk of a type in a PNG of ours, which has one of each.
std::span<const std::uint8_t> chunk_of(const PngBytes& png, std::string_view type) {
    std::span<const std::uint8_t> rest = std::span(png).subspan(kSignature);
    while (true) {
        const std::uint32_t size = png_number(rest);
        const auto name = rest.subspan(4, 4);
        if (std::equal(name.begin(), name.end(), type.begin())) { return rest.subspan(8, size); }
        rest = rest.subspan(12 + size);
    }
}

/// Each picture is compressed as a PNG of its own; its data go into chunks of the one file.
class Apng : public Animation {
public:
    explicit Apng(Repeat repeat) : repeat_(repeat) {}

protected:
    void write(const Image& image, const PixelArea& area, const Image* before, double seconds) override {
        const PngBytes png = encoded(image, area, before);
        if (before == nullptr) {
            is_opaque_ = image.alpha.empty();
            file_.assign(png.begin(), png.begin() + kSignature);
            put_chunk(file_, "IHDR", chunk_of(png, "IHDR"));
            control_ = file_.size();
            put_chunk(file_, "acTL", PngBytes(8));
        }
        int ticks = time_.next(seconds, 1);
        // a time that two bytes cannot hold is that of several equal pictures
        put_picture(png, area, std::min(ticks, kMostTicks));
        while ((ticks -= kMostTicks) > 0) { put_picture(png, area, std::min(ticks, kMostTicks)); }
    }

    PngBytes end() override {
        PngBytes control;
        put(control, pictures_, 4);
        put(control, repeat_ == Repeat::once ? 1 : 0, 4);
        PngBytes chunk;
        put_chunk(chunk, "acTL", control);
        std::copy(chunk.begin(), chunk.end(), file_.begin() + static_cast<std::ptrdiff_t>(control_));
        put_chunk(file_, "IEND", {});
        return std::move(file_);
    }

private:
    /// An opaque picture is drawn over the one before, another one takes its place. All have the same
    /// channels.
    PngBytes encoded(const Image& image, const PixelArea& area, const Image* before) const {
        if (!image.alpha.empty()) { return encode_png(cut_out(image, area)); }
        if (before != nullptr) { return encode_png(changes_within(area, *before, image)); }
        Image first = image;
        first.alpha.assign(image.rgb.size() / 3, 255);
        return encode_png(first);
    }

    static constexpr int kTicksPerSecond = 1000;
    static constexpr int kMostTicks = 65535;  // two bytes

    void put_picture(const PngBytes& png, const PixelArea& area, int ticks) {
        PngBytes frame;
        put(frame, sequence_++, 4);
        for (const int value : {area.width, area.height, area.x, area.y}) {
            put(frame, static_cast<std::uint32_t>(value), 4);
        }
        put(frame, static_cast<std::uint32_t>(ticks), 2);
        put(frame, kTicksPerSecond, 2);
        put(frame, 0, 1);  // stays until the next one
        put(frame, is_opaque_ ? 1 : 0, 1);
        put_chunk(file_, "fcTL", frame);

        const std::span<const std::uint8_t> data = chunk_of(png, "IDAT");
        if (pictures_++ == 0) {
            put_chunk(file_, "IDAT", data);
            return;
        }
        PngBytes numbered;
        put(numbered, sequence_++, 4);
        numbered.insert(numbered.end(), data.begin(), data.end());
        put_chunk(file_, "fdAT", numbered);
    }

    Repeat repeat_;
    bool is_opaque_ = true;
    Ticks time_{kTicksPerSecond};
    PngBytes file_;
    std::size_t control_ = 0;  ///< where the number of pictures is written at the end
    std::uint32_t sequence_ = 0;
    std::uint32_t pictures_ = 0;
};

}  // namespace

std::unique_ptr<Animation> make_apng(Repeat repeat) { return std::make_unique<Apng>(repeat); }

}  // namespace jw::render
