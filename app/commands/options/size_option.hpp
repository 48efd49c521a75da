#pragma once

#include <string>

/// --size WIDTHxHEIGHT.
namespace jw {

struct PixelSize {
    int width = 0;
    int height = 0;
};

/// @throws CommandError if the text is not a size, or the size is not between the limits
PixelSize size_option(const std::string& text, PixelSize smallest, PixelSize largest);

/// Size of a picture that may be higher than wide: then the limits are swapped.
PixelSize size_option_either_way(const std::string& text, PixelSize smallest, PixelSize largest);

}  // namespace jw
