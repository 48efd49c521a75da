#include "app/commands/size_option.hpp"

#include <regex>

#include "app/commands/command.hpp"

namespace jw {

namespace {

std::string text_of(PixelSize size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

bool fits(PixelSize size, PixelSize smallest, PixelSize largest) {
    return size.width >= smallest.width && size.height >= smallest.height && size.width <= largest.width &&
           size.height <= largest.height;
}

}  // namespace

PixelSize size_option(const std::string& text, PixelSize smallest, PixelSize largest) {
    static const std::regex form("([0-9]{1,5})x([0-9]{1,5})");
    std::smatch match;
    if (std::regex_match(text, match, form)) {
        const PixelSize size{std::stoi(match[1]), std::stoi(match[2])};
        if (fits(size, smallest, largest)) { return size; }
    }
    throw CommandError(
        Exit::bad_input, "jointwise: error: --size '" + text + "'; expected WIDTHxHEIGHT in pixels from " +
                             text_of(smallest) + " to " + text_of(largest) + ", for example 1920x1080");
}

}  // namespace jw
