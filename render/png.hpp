#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/image.hpp"

/// Pictures as PNG files, byte-deterministic.
namespace jw::render {

/// Encodes pictures one after the other in memory that it keeps: that of the largest. The same picture gives
/// the same bytes on every machine with the same libdeflate.
class PngEncoder {
public:
    PngEncoder();
    ~PngEncoder();
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    /// A PNG file, with an alpha channel where the picture has one; there until the next one.
    /// @throws std::invalid_argument if the picture is empty or its size and its data disagree.
    const std::vector<std::uint8_t>& encode(const Image& image);

private:
    struct Room;
    std::unique_ptr<Room> room_;
};

/// Encodes one picture as `PngEncoder` does.
std::vector<std::uint8_t> encode_png(const Image& image);

/// "1.14": bytes of pictures depend on it.
std::string libdeflate_version();

}  // namespace jw::render
