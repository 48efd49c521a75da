#include "app/session/wording/message_catalogue.hpp"

namespace jw {

namespace {

// https://www.gnu.org/software/gettext/manual/html_node/MO-Files.html
constexpr std::uint32_t kMagic = 0x950412de;
constexpr std::size_t kHeaderSize = 28;
constexpr std::size_t kCountAt = 8;
constexpr std::size_t kKeysAt = 12;
constexpr std::size_t kTranslationsAt = 16;
constexpr std::size_t kEntrySize = 8;  // length and offset of a text

std::string_view first_form(std::string_view text) { return text.substr(0, text.find('\0')); }

}  // namespace

const char* MessageCatalogue::find(std::string_view english, int count) const {
    std::size_t first = 0;
    std::size_t end = size();
    while (first < end) {
        const std::size_t middle = first + (end - first) / 2;
        const int order = first_form(key(middle)).compare(english);
        if (order == 0) {
            const std::string_view found = translation(middle);
            const std::size_t second = found.find('\0');
            if (count == 1 || second == std::string_view::npos) { return found.data(); }
            return found.data() + second + 1;
        }
        (order < 0 ? first : end) = order < 0 ? middle + 1 : middle;
    }
    return nullptr;
}

std::size_t MessageCatalogue::size() const {
    if (bytes_.size() < kHeaderSize || number(0) != kMagic) { return 0; }
    return number(kCountAt);
}

std::string_view MessageCatalogue::key(std::size_t index) const { return text(number(kKeysAt), index); }

std::string_view MessageCatalogue::translation(std::size_t index) const {
    return text(number(kTranslationsAt), index);
}

std::uint32_t MessageCatalogue::number(std::size_t offset) const {
    std::uint32_t value = 0;
    for (std::size_t k = 4; k-- > 0;) { value = value << 8U | bytes_[offset + k]; }
    return value;
}

std::string_view MessageCatalogue::text(std::size_t table, std::size_t index) const {
    const std::size_t entry = table + kEntrySize * index;
    return {reinterpret_cast<const char*>(bytes_.data()) + number(entry + 4), number(entry)};
}

}  // namespace jw
