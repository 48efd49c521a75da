#include "app/session/encoding/base64.hpp"

#include <algorithm>
#include <string_view>

namespace jw {

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
        unsigned group = 0;
        for (std::size_t b = 0; b < 3; ++b) { group = (group << 8U) | (b < count ? bytes[k + b] : 0U); }
        for (std::size_t c = 0; c < 4; ++c) {
            text += c <= count ? kLetters[(group >> (18U - 6U * static_cast<unsigned>(c))) & 63U] : '=';
        }
    }
    return text;
}

}  // namespace jw
