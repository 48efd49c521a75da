#include "app/commands/options/frame_range.hpp"

#include <charconv>
#include <optional>

#include "app/commands/program/command.hpp"

namespace jw {

namespace {

CommandError bad_range(const std::string& text, int frames) {
    return CommandError(
        Exit::bad_input, "jointwise: error: --frames '" + text +
                             "'; expected A:B, A:, :B or A with numbers from 0 to " +
                             std::to_string(frames - 1) + ", the frames of this lesson");
}

std::optional<int> number_of(const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) { return std::nullopt; }
    return number;
}

}  // namespace

FrameRange frame_range(const std::string& text, int frames) {
    const std::size_t colon = text.find(':');
    const std::string from = text.substr(0, colon);
    const std::string to = colon == std::string::npos ? from : text.substr(colon + 1);
    if (from.empty() && to.empty()) { throw bad_range(text, frames); }
    const std::optional<int> first = from.empty() ? 0 : number_of(from);
    const std::optional<int> last = to.empty() ? frames - 1 : number_of(to);
    if (!first || !last || *first < 0 || *last < *first || *last >= frames) { throw bad_range(text, frames); }
    return {*first, *last};
}

}  // namespace jw
