#include "lessons/diagnostics/codes.hpp"

#include <algorithm>

namespace jw {

namespace {

constexpr std::string_view kPrefix = "JW";

// codes are looked up by enumerator and listed by number
constexpr bool codes_are_in_order() {
    for (std::size_t k = 0; k < kCodes.size(); ++k) {
        if (kCodes[k].code != static_cast<Code>(k)) { return false; }
        if (k > 0 && kCodes[k].printed <= kCodes[k - 1].printed) { return false; }
    }
    return kCodes.size() == static_cast<std::size_t>(Code::exercise_variant) + 1;
}
static_assert(codes_are_in_order());

bool begins_with_prefix(std::string_view text) {
    return text.size() > kPrefix.size() && (text[0] == 'J' || text[0] == 'j') &&
           (text[1] == 'W' || text[1] == 'w');
}

}  // namespace

std::optional<Code> read_code(std::string_view text) {
    if (begins_with_prefix(text)) { text.remove_prefix(kPrefix.size()); }
    const auto* const found = std::ranges::find_if(
        kCodes, [&](const CodeEntry& entry) { return entry.printed.substr(kPrefix.size()) == text; });
    return found != kCodes.end() ? std::optional<Code>(found->code) : std::nullopt;
}

}  // namespace jw
