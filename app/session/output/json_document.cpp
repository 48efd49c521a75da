#include "app/session/output/json.hpp"

namespace jw {

namespace {

/// Number of bytes of a control character U+007F to U+009F at `at`; 0 for anything else.
std::size_t control_at(const std::string& text, std::size_t at) {
    if (text[at] == '\x7f') { return 1; }
    if (text[at] != '\xC2' || at + 1 == text.size()) { return 0; }
    return static_cast<unsigned char>(text[at + 1]) < 0xA0U ? 2 : 0;
}

std::string escaped_control(char last_byte) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(last_byte);
    return {'\\', 'u', '0', '0', kDigits[code >> 4U], kDigits[code & 15U]};
}

}  // namespace

std::string json_document(const Json& json, int indent) {
    const std::string text = json.dump(indent, ' ', false, Json::error_handler_t::replace);
    std::string shown;
    shown.reserve(text.size() + 1);
    // outside of strings, JSON is ASCII without control characters
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t bytes = control_at(text, at);
        if (bytes == 0) {
            shown += text[at];
            continue;
        }
        at += bytes - 1;
        shown += escaped_control(text[at]);
    }
    return shown + "\n";
}

}  // namespace jw
