#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/files/image.hpp"

/// Pictures as PNG files; the same picture gives the same bytes.
namespace jw::render {

/// Encodes pictures one after the other and keeps its memory, which fits the largest of them. The same
/// picture gives the same bytes on every machine with the same libdeflate.
class PngEncoder {
public:
    PngEncoder();
    ~PngEncoder();
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    /// A PNG file, with an alpha channel if the picture has one; valid until the next call.
    /// @throws std::invalid_argument if the picture is empty or its size does not match its data.
    const std::vector<std::uint8_t>& encode(const Image& image);

private:
    struct Room;
    std::unique_ptr<Room> room_;
};

/// Encodes one picture as `PngEncoder` does.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Version of libdeflate, "1.14": bytes of pictures depend on it.
std::string libdeflate_version();

}  // namespace jw::render
