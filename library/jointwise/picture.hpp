#pragma once

#include <cstdint>

#include "jointwise/analysis.hpp"
#include "jointwise/lesson.hpp"

/// Pictures of mechanisms, drawn without a display by OSMesa.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// RGB, 8 bits per channel, top row first, no padding.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// A mechanism at a pose, as large as the picture allows. The same arguments give the same picture.
/// @throws std::runtime_error if there is no OSMesa, or the size is out of range
Image draw(const Mechanism& mechanism, const Pose& pose, int width = 1280, int height = 720);
/// The same with the lesson's shapes and colours, from the lesson's view direction.
Image draw(const Lesson& lesson, const Pose& pose, int width = 1280, int height = 720);

/// The bytes of a PNG file.
std::vector<std::uint8_t> png_of(const Image& image);
/// Writes a PNG file completely or not at all. @throws std::runtime_error
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
