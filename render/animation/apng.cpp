#include <algorithm>
#include <span>
#include <string_view>

#include "render/animation/animation.hpp"
#include "render/files/png.hpp"
#include "render/files/png_chunks.hpp"

namespace jw::render {

namespace {

using PngBytes = std::vector<std::uint8_t>;

/// Data of the first chunk of a type in a PNG of this program, which has one of each type.
std::span<const std::uint8_t> chunk_of(const PngBytes& png, std::string_view type) {
    PngChunks chunks(png);
    std::optional<PngChunk> chunk = chunks.next();
    while (chunk && chunk->type != type) { chunk = chunks.next(); }
    return chunk.value().data;
}

/// Compresses each picture as a separate PNG; the data of all of them go into the chunks of one file.
class Apng : public Animation {
public:
    explicit Apng(Repeat repeat) : repeat_(repeat) {}

protected:
    void write(const Image& image, const PixelArea& area, const Image* before, double seconds) override {
        const PngBytes png = encoded(image, area, before);
        if (before == nullptr) {
            is_opaque_ = image.alpha.empty();
            constexpr std::ptrdiff_t signature = 8;
            file_.assign(png.begin(), png.begin() + signature);
            append_png_chunk(file_, "IHDR", chunk_of(png, "IHDR"));
            control_ = file_.size();
            append_png_chunk(file_, "acTL", PngBytes(8));
        }
        int ticks = time_.next(seconds, 1);
        // a time that does not fit into two bytes is split between several equal pictures
        put_picture(png, area, std::min(ticks, kMostTicks));
        while ((ticks -= kMostTicks) > 0) { put_picture(png, area, std::min(ticks, kMostTicks)); }
    }

    PngBytes end() override {
        PngBytes control;
        append_png_number(control, pictures_);
        append_png_number(control, repeat_ == Repeat::once ? 1 : 0);
        PngBytes chunk;
        append_png_chunk(chunk, "acTL", control);
        std::copy(chunk.begin(), chunk.end(), file_.begin() + static_cast<std::ptrdiff_t>(control_));
        append_png_chunk(file_, "IEND", {});
        return std::move(file_);
    }

private:
    /// An opaque picture is drawn over the previous one; any other picture replaces it. All have the same
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
        append_png_number(frame, sequence_++);
        for (const int value : {area.width, area.height, area.x, area.y}) {
            append_png_number(frame, static_cast<std::uint32_t>(value));
        }
        append_png_number(frame, static_cast<std::uint32_t>(ticks), 2);
        append_png_number(frame, kTicksPerSecond, 2);
        append_png_number(frame, 0, 1);  // the picture stays until the next one
        append_png_number(frame, is_opaque_ ? 1 : 0, 1);
        append_png_chunk(file_, "fcTL", frame);

        const std::span<const std::uint8_t> data = chunk_of(png, "IDAT");
        if (pictures_++ == 0) {
            append_png_chunk(file_, "IDAT", data);
            return;
        }
        PngBytes numbered;
        append_png_number(numbered, sequence_++);
        numbered.insert(numbered.end(), data.begin(), data.end());
        append_png_chunk(file_, "fdAT", numbered);
    }

    Repeat repeat_;
    bool is_opaque_ = true;
    Ticks time_{kTicksPerSecond};
    PngBytes file_;
    std::size_t control_ = 0;  ///< place at which the number of pictures is written at the end
    std::uint32_t sequence_ = 0;
    std::uint32_t pictures_ = 0;
};

}  // namespace

std::unique_ptr<Animation> make_apng(Repeat repeat) { return std::make_unique<Apng>(repeat); }

}  // namespace jw::render
