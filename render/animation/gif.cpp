#include <gif_lib.h>

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "render/animation/colour_table.hpp"
#include "render/animation/gif.hpp"

namespace jw::render {

namespace {

struct FreeTable {
    void operator()(ColorMapObject* table) const { GifFreeMapObject(table); }
};

int append(GifFileType* file, const GifByteType* bytes, int count) {
    auto& all = *static_cast<std::vector<std::uint8_t>*>(file->UserData);
    all.insert(all.end(), bytes, bytes + count);
    return count;
}

class Gif : public Animation {
public:
    using Bytes = std::vector<std::uint8_t>;

    Gif(std::vector<Rgb> colours, Repeat repeat) : repeat_(repeat), table_(std::move(colours)) {}
    ~Gif() override {
        if (file_ != nullptr) { EGifCloseFile(file_, nullptr); }
    }

protected:
    void write(const Image& image, const PixelArea& area, const Image* before, double seconds) override {
        if (before == nullptr) { begin(image.width, image.height); }
        Bytes pixels = indices(image, area, before);
        int ticks = time_.next(seconds, kLeastTicks);
        put_picture(pixels, area, std::min(ticks, kMostTicks));
        // a time that does not fit into two bytes is split; the additional pictures do not change anything
        while ((ticks -= kMostTicks) > 0) {
            put_picture({kUnchanged}, {area.x, area.y, 1, 1}, std::min(ticks, kMostTicks));
        }
    }

    Bytes end() override {
        GifFileType* const file = std::exchange(file_, nullptr);
        int error = 0;
        if (EGifCloseFile(file, &error) != GIF_OK) { fail(error); }
        return std::move(bytes_);
    }

private:
    static constexpr int kTicksPerSecond = 100;
    static constexpr int kLeastTicks = 2;  // browsers show a shorter picture for ten ticks
    static constexpr int kMostTicks = 65535;
    static constexpr int kTableSize = 256;
    static constexpr std::uint8_t kUnchanged = 255;  // index without a colour: the pixel does not change

    [[noreturn]] static void fail(int error) {
        const char* const why = GifErrorString(error);
        throw std::runtime_error(
            "the GIF cannot be made: " + std::string(why == nullptr ? "no reason given" : why));
    }
    void check(int result) const {
        if (result != GIF_OK) { fail(file_->Error); }
    }

    void begin(int width, int height) {
        int error = 0;
        file_ = EGifOpen(&bytes_, append, &error);
        if (file_ == nullptr) { fail(error); }
        EGifSetGifVersion(file_, true);
        const std::unique_ptr<ColorMapObject, FreeTable> table(GifMakeMapObject(kTableSize, nullptr));
        if (!table) { throw std::bad_alloc(); }
        for (std::size_t k = 0; k < table_.colours().size(); ++k) {
            const Rgb& colour = table_.colours()[k];
            table->Colors[k] = {colour[0], colour[1], colour[2]};
        }
        check(EGifPutScreenDesc(file_, width, height, 8, 0, table.get()));
        if (repeat_ == Repeat::once) { return; }
        const std::array<GifByteType, 3> without_end{1, 0, 0};
        check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(file_, without_end.size(), without_end.data()));
        check(EGifPutExtensionTrailer(file_));
    }

    Bytes indices(const Image& image, const PixelArea& area, const Image* before) {
        Bytes pixels;
        pixels.reserve(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < area.x + area.width; ++x) {
                const std::uint8_t* const now = image.at(x, y);
                const bool is_unchanged = before != nullptr && std::equal(now, now + 3, before->at(x, y));
                pixels.push_back(is_unchanged ? kUnchanged : table_.index(now, x, y));
            }
        }
        return pixels;
    }

    void put_picture(Bytes pixels, const PixelArea& area, int ticks) {
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, ticks, kUnchanged};
        std::array<GifByteType, 4> extension{};
        EGifGCBToExtension(&control, extension.data());
        check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, extension.size(), extension.data()));
        check(EGifPutImageDesc(file_, area.x, area.y, area.width, area.height, false, nullptr));
        for (int y = 0; y < area.height; ++y) {
            check(EGifPutLine(
                file_, &pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(area.width)],
                area.width));
        }
    }

    Repeat repeat_;
    ColourTable table_;
    Ticks time_{kTicksPerSecond};
    GifFileType* file_ = nullptr;
    Bytes bytes_;
};

}  // namespace

std::unique_ptr<Animation> make_gif(std::vector<Rgb> colours, Repeat repeat) {
    if (colours.empty() || colours.size() > kMostColoursOfGif) {
        throw std::invalid_argument("a GIF cannot have " + std::to_string(colours.size()) + " colours");
    }
    return std::make_unique<Gif>(std::move(colours), repeat);
}

}  // namespace jw::render
