#include "app/commands/options/size_option.hpp"

#include <optional>
#include <regex>

#include "app/commands/program/command.hpp"

namespace jw {

namespace {

std::string text_of(PixelSize size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

bool fits(PixelSize size, PixelSize smallest, PixelSize largest) {
    return size.width >= smallest.width && size.height >= smallest.height && size.width <= largest.width &&
           size.height <= largest.height;
}

std::optional<PixelSize> read_size(const std::string& text) {
    static const std::regex form("([0-9]{1,5})x([0-9]{1,5})");
    std::smatch match;
    if (!std::regex_match(text, match, form)) { return std::nullopt; }
    return PixelSize{std::stoi(match[1]), std::stoi(match[2])};
}

[[noreturn]] void refuse_size(
    const std::string& text, PixelSize smallest, PixelSize largest, const std::string& or_else) {
    throw bad_input(
        "--size '" + text + "'; expected WIDTHxHEIGHT in pixels from " + text_of(smallest) + " to " +
        text_of(largest) + or_else + ", for example 1920x1080");
}

PixelSize turned(PixelSize size) { return {size.height, size.width}; }

}  // namespace

PixelSize size_option(const std::string& text, PixelSize smallest, PixelSize largest) {
    const std::optional<PixelSize> size = read_size(text);
    if (!size || !fits(*size, smallest, largest)) { refuse_size(text, smallest, largest, ""); }
    return *size;
}

PixelSize size_option_either_way(const std::string& text, PixelSize smallest, PixelSize largest) {
    const std::optional<PixelSize> size = read_size(text);
    if (!size || (!fits(*size, smallest, largest) && !fits(turned(*size), smallest, largest))) {
        refuse_size(text, smallest, largest, ", or turned");
    }
    return *size;
}

}  // namespace jw
