#include "app/session/wording/messages.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>

#include "app/languages/zh-Hant.hpp"
#include "app/session/wording/message_catalogue.hpp"

namespace jw {

namespace {

constexpr std::array kLanguages{
    Language{"en", "English", MessageCatalogue({})},
    Language{"zh-Hant", "繁體中文", MessageCatalogue(languages_data::kZhHant)},
};

std::atomic<const Language*> present_language{kLanguages.data()};

const char* translation_of(std::string_view english, int count) {
    const Language* const present = present_language.load(std::memory_order_acquire);
    return present == kLanguages.data() ? nullptr : present->messages.find(english, count);
}

// https://www.gnu.org/software/gettext/manual/html_node/MO-Files.html
constexpr std::uint32_t kMagic = 0x950412de;
constexpr std::size_t kHeaderSize = 28;
constexpr std::size_t kCountAt = 8;
constexpr std::size_t kKeysAt = 12;
constexpr std::size_t kTranslationsAt = 16;
constexpr std::size_t kEntrySize = 8;  // length and offset of a text

std::string_view first_form(std::string_view text) { return text.substr(0, text.find('\0')); }

}  // namespace

std::span<const Language> languages() { return kLanguages; }

bool set_language(std::string_view tag) {
    const auto found = std::ranges::find(kLanguages, tag, &Language::tag);
    if (found == kLanguages.end()) { return false; }
    present_language.store(&*found, std::memory_order_release);
    return true;
}

std::string_view language() { return present_language.load(std::memory_order_acquire)->tag; }

const char* tr(const char* english) {
    const char* const translated = translation_of(english, 1);
    return translated != nullptr ? translated : english;
}

std::string tr(const Message& message) {
    fmt::dynamic_format_arg_store<fmt::format_context> arguments;
    for (const std::string& argument : message.arguments) { arguments.push_back(argument); }
    return messages::filled(message.english, message.english, 1, arguments);
}

std::string messages::filled(
    std::string_view key, std::string_view english, int count, const fmt::format_args& arguments) {
    if (const char* const translated = translation_of(key, count)) {
        try {
            return fmt::vformat(translated, arguments);
        } catch (const fmt::format_error&) {
            // a mistake in a translation: the reader gets the English sentence
        }
    }
    return fmt::vformat(fmt::string_view(english.data(), english.size()), arguments);
}

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
