#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "render/animation/animation.hpp"
#include "render/animation/colour_table.hpp"
#include "render/animation/gif.hpp"
#include "render/files/png.hpp"
#include "render/files/png_chunks.hpp"
#include "render/files/png_reader.hpp"

namespace jw::render::test {
namespace {

Image filled(int width, int height, const Rgb& colour) {
    Image image{width, height, {}};
    for (int n = 0; n < width * height; ++n) {
        image.rgb.insert(image.rgb.end(), colour.begin(), colour.end());
    }
    return image;
}

std::uint8_t& channel(Image& image, int x, int y, int c) {
    return image.rgb
        [3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(x)) +
         static_cast<std::size_t>(c)];
}

/// Picture from the darkest to the lightest colour of a sky that is as pale as the program's.
Image gradient(int width, int height) {
    Image image = filled(width, height, {0, 0, 0});
    for (int y = 0; y < height; ++y) {
        const double share = static_cast<double>(y) / (height - 1);
        for (int x = 0; x < width; ++x) {
            channel(image, x, y, 0) = static_cast<std::uint8_t>(std::lround(233 + 18 * share));
            channel(image, x, y, 1) = static_cast<std::uint8_t>(std::lround(238 + 12 * share));
            channel(image, x, y, 2) = static_cast<std::uint8_t>(std::lround(243 + 4 * share));
        }
    }
    return image;
}

/// Number in an animation's bytes, as PNG writes it.
std::uint32_t at(const std::vector<std::uint8_t>& bytes, std::size_t place) {
    return png_number(std::span(bytes).subspan(place));
}

/// Pictures of an APNG read by its specification alone: each control chunk places the picture behind it.
struct ReadFrame {
    Image image;
    double seconds = 0.0;
};

std::vector<std::uint8_t> chunk(const std::string& type, std::vector<std::uint8_t> data) {
    std::vector<std::uint8_t> bytes(type.begin(), type.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    const std::uint32_t sum = png_checksum(bytes);
    std::vector<std::uint8_t> all;
    for (int k = 3; k >= 0; --k) { all.push_back(static_cast<std::uint8_t>(data.size() >> (8 * k))); }
    all.insert(all.end(), bytes.begin(), bytes.end());
    for (int k = 3; k >= 0; --k) { all.push_back(static_cast<std::uint8_t>(sum >> (8 * k))); }
    return all;
}

std::vector<ReadFrame> read_apng(const std::vector<std::uint8_t>& file) {
    REQUIRE(is_whole_png(file));
    std::vector<ReadFrame> frames;
    std::vector<std::uint8_t> header;
    std::array<int, 4> area{};
    double seconds = 0.0;
    std::uint32_t sequence = 0;
    std::uint32_t promised = 0;
    bool is_over = false;
    for (std::size_t place = 8; place < file.size();) {
        const std::size_t size = at(file, place);
        const std::string type(file.begin() + long(place) + 4, file.begin() + long(place) + 8);
        const std::vector<std::uint8_t> data(
            file.begin() + long(place) + 8, file.begin() + long(place) + 8 + long(size));
        place += size + 12;
        if (type == "IHDR") { header = data; }
        if (type == "acTL") { promised = at(data, 0); }
        if (type == "fcTL") {
            CHECK(at(data, 0) == sequence++);
            for (std::size_t k = 0; k < 4; ++k) { area[k] = static_cast<int>(at(data, 4 + 4 * k)); }
            seconds = (data[20] * 256 + data[21]) / double(data[22] * 256 + data[23]);
            CHECK(data[24] == 0);
            is_over = data[25] == 1;
        }
        if (type != "IDAT" && type != "fdAT") { continue; }
        std::vector<std::uint8_t> pixels = data;
        if (type == "fdAT") {
            CHECK(at(data, 0) == sequence++);
            pixels.erase(pixels.begin(), pixels.begin() + 4);
        }
        std::vector<std::uint8_t> own = header;
        for (std::size_t k = 0; k < 4; ++k) {
            own[k] = static_cast<std::uint8_t>(area[0] >> (8 * (3 - k)));
            own[4 + k] = static_cast<std::uint8_t>(area[1] >> (8 * (3 - k)));
        }
        std::vector<std::uint8_t> png(file.begin(), file.begin() + 8);
        for (const auto& part : {chunk("IHDR", own), chunk("IDAT", pixels), chunk("IEND", {})}) {
            png.insert(png.end(), part.begin(), part.end());
        }
        const Image part = decode_png(png, "part", Alpha::kept);
        Image image = frames.empty() ? part : frames.back().image;
        for (int y = 0; y < part.height; ++y) {
            for (int x = 0; x < part.width; ++x) {
                const std::uint8_t alpha = part.alpha[static_cast<std::size_t>(y * part.width + x)];
                // drawn over: alpha is either 0 or 255 here
                if (is_over && alpha == 0) { continue; }
                for (int c = 0; c < 3; ++c) {
                    channel(image, area[2] + x, area[3] + y, c) = part.at(x, y)[c];
                }
                image.alpha[static_cast<std::size_t>((area[3] + y) * image.width + area[2] + x)] = alpha;
            }
        }
        frames.push_back({image, seconds});
    }
    CHECK(frames.size() == promised);
    return frames;
}

}  // namespace

TEST_CASE("the changed area is the smallest that holds every changed pixel", "[render][animation]") {
    std::mt19937 random(3);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint32_t>(n)); };
    const Image before = filled(17, 11, {9, 9, 9});
    CHECK_FALSE(changed_area(before, before));
    for (int sample = 0; sample < 500; ++sample) {
        Image now = before;
        int left = 99, right = -1, top = 99, bottom = -1;
        for (int k = 0; k <= below(5); ++k) {
            const int x = below(17), y = below(11);
            channel(now, x, y, below(3)) = 200;
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
        const PixelArea area = changed_area(before, now).value();
        CHECK(
            std::array{area.x, area.y, area.width, area.height} ==
            std::array{left, top, right - left + 1, bottom - top + 1});
    }
}

TEST_CASE("ticks of many lengths add up to the length of all", "[render][animation]") {
    for (const double per_second : {100.0, 29.97, 1000.0}) {
        Ticks ticks(per_second);
        double told = 0.0;
        long long given = 0;
        std::mt19937 random(5);
        for (int k = 0; k < 3000; ++k) {
            const double seconds = 1e-4 * static_cast<double>(random() % 20000);
            told += seconds;
            given += ticks.next(seconds, 0);
            REQUIRE(std::abs(static_cast<double>(given) - told * per_second) <= 0.5 + 1e-6);
        }
    }
    Ticks ticks(100.0);
    CHECK(ticks.next(0.001, 2) == 2);
    CHECK(ticks.next(0.029, 2) == 2);  // the surplus of the first is taken off, as far as 2 allows
    CHECK(ticks.next(1.0, 2) == 99);
}

TEST_CASE("an animated PNG holds every picture as it was, and its time", "[render][animation]") {
    const bool is_opaque = GENERATE(true, false);
    std::mt19937 random(8);
    std::vector<Image> pictures{gradient(40, 30)};
    if (!is_opaque) { pictures[0].alpha.assign(1200, 255); }
    for (int k = 0; k < 12; ++k) {
        Image next = pictures.back();
        const int x = static_cast<int>(random() % 30), y = static_cast<int>(random() % 20);
        for (int n = 0; n < 10; ++n) {
            channel(next, x + n, y + n % 7, n % 3) = static_cast<std::uint8_t>(random());
            if (!is_opaque) {
                next.alpha[static_cast<std::size_t>(y * 40 + x + n)] = static_cast<std::uint8_t>(random());
            }
        }
        pictures.push_back(next);
    }
    const auto animation = make_apng(Repeat::without_end);
    for (const Image& picture : pictures) {
        animation->add(picture, 0.02);
        animation->add(picture, 0.0133);
    }
    const std::vector<ReadFrame> read = read_apng(animation->finish());
    REQUIRE(read.size() == pictures.size());
    double seconds = 0.0;
    for (std::size_t k = 0; k < read.size(); ++k) {
        Image expected = pictures[k];
        if (is_opaque) { expected.alpha.assign(1200, 255); }
        CHECK(read[k].image == expected);
        seconds += read[k].seconds;
    }
    CHECK(seconds == Approx(13 * 0.0333).margin(0.0006));
}

TEST_CASE("a picture that is shown for minutes keeps its time", "[render][animation]") {
    const auto animation = make_apng(Repeat::once);
    animation->add(filled(3, 2, {1, 2, 3}), 100.0);
    double seconds = 0.0;
    for (const ReadFrame& frame : read_apng(animation->finish())) { seconds += frame.seconds; }
    CHECK(seconds == Approx(100.0));
}

TEST_CASE("pictures of two sizes are no animation, and neither is none", "[render][animation]") {
    const auto animation = make_apng(Repeat::once);
    CHECK_THROWS_AS(animation->finish(), std::invalid_argument);
    animation->add(filled(3, 2, {1, 2, 3}), 1.0);
    CHECK_THROWS_AS(animation->add(filled(2, 3, {1, 2, 3}), 1.0), std::invalid_argument);
}

TEST_CASE("colours of flat areas are kept as they are", "[render][animation]") {
    Image picture = gradient(200, 200);
    std::mt19937 random(2);
    // shades of a body, many more than fit into the colour table
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            channel(picture, x, y, 0) = static_cast<std::uint8_t>(random() % 256);
            channel(picture, x, y, 1) = static_cast<std::uint8_t>(random() % 128);
        }
    }
    const std::vector<Rgb> flat{{0x1D, 0x62, 0xA8}, {0xFB, 0xF0, 0xD2}, {0xF3, 0xF2, 0xEE}};
    for (std::size_t k = 0; k < flat.size(); ++k) {
        for (int x = 100; x < 200; ++x) {
            for (int c = 0; c < 3; ++c) { channel(picture, x, 150 + int(k), c) = flat[k][std::size_t(c)]; }
        }
    }
    ColourCensus census;
    census.add(picture);
    const std::vector<Rgb> colours = census.choose(kMostColoursOfGif);
    CHECK(colours.size() <= kMostColoursOfGif);
    CHECK(colours.size() > 200);
    for (const Rgb& colour : flat) { CHECK(std::ranges::find(colours, colour) != colours.end()); }
}

TEST_CASE("a gradient in few colours keeps its mean everywhere", "[render][animation]") {
    const Image picture = gradient(64, 256);
    ColourCensus census;
    census.add(picture);
    // far fewer colours than the gradient has: those between two of the table are mixed from them
    ColourTable table(census.choose(6));
    REQUIRE(table.colours().size() <= 6);
    int areas = 0;
    for (int top = 0; top < 256; top += 4) {
        // each colour has its own pattern: where two colours meet, parts of two patterns meet
        if (!std::equal(picture.at(0, top), picture.at(0, top) + 3, picture.at(0, top + 3))) { continue; }
        ++areas;
        for (int left = 0; left < 64; left += 4) {
            std::array<double, 3> off{};
            for (int y = top; y < top + 4; ++y) {
                for (int x = left; x < left + 4; ++x) {
                    const std::uint8_t* const rgb = picture.at(x, y);
                    const Rgb& shown = table.colours()[table.index(rgb, x, y)];
                    for (std::size_t c = 0; c < 3; ++c) { off[c] += (shown[c] - rgb[c]) / 16.0; }
                }
            }
            // the gradient and the six are rounded to levels, so they are off one line by half a level each;
            // the ends of the gradient lie beyond the first and the last by half of 3 levels
            const bool is_end = top < 24 || top >= 232;
            const double seen =
                std::sqrt((2.0 * off[0] * off[0] + 4.0 * off[1] * off[1] + 3.0 * off[2] * off[2]) / 9.0);
            CHECK(seen <= (is_end ? 2.0 : 1.0));
        }
    }
    CHECK(areas > 30);
}

TEST_CASE("a file of a picture that is cut off or changed anywhere is not whole", "[render][png]") {
    const std::vector<std::uint8_t> png = encode_png(gradient(9, 7));
    REQUIRE(is_whole_png(png));
    for (std::size_t k = 0; k < png.size(); ++k) {
        CHECK_FALSE(is_whole_png(std::span(png).first(k)));
        std::vector<std::uint8_t> changed = png;
        changed[k] ^= 0x10U;
        CHECK_FALSE(is_whole_png(changed));
    }
}

}  // namespace jw::render::test
