#include "app/session/wording/messages.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>

#include "app/languages/zh-Hant.hpp"

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

}  // namespace jw
