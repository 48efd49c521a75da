#include "app/session/wording/messages.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include <catch2/catch.hpp>

#include "tests/app/messages/catalogue_keys.hpp"
#include "tests/app/messages/in_language.hpp"

namespace jw {

namespace {

const std::map<std::string, std::string>& sources() {
    static const std::map<std::string, std::string> messages = test::messages_of_sources();
    return messages;
}

/// Placeholders of a message, "{0}" and "{1}", once each.
std::set<std::string> placeholders(std::string_view text) {
    std::set<std::string> found;
    for (std::size_t k = text.find('{'); k != std::string_view::npos; k = text.find('{', k + 1)) {
        found.emplace(text.substr(k, text.find('}', k) + 1 - k));
    }
    return found;
}

std::vector<const Language*> translated_languages() {
    std::vector<const Language*> all;
    for (const Language& language : languages()) {
        if (language.messages.size() > 0) { all.push_back(&language); }
    }
    return all;
}

}  // namespace

TEST_CASE("Every message of the sources has a translation in every language", "[messages]") {
    CHECK(sources().size() > 100);  // an expression that finds nothing would pass
    for (const Language* language : translated_languages()) {
        for (const auto& [key, plural] : sources()) {
            CAPTURE(language->tag);
            const char* const found = language->messages.find(key);
            if (found == nullptr || *found == '\0') { FAIL_CHECK("no translation of: " << key); }
        }
    }
}

TEST_CASE("No translation is of a message that the sources no longer have", "[messages]") {
    for (const Language* language : translated_languages()) {
        for (std::size_t k = 1; k < language->messages.size(); ++k) {
            const std::string_view key = language->messages.key(k);
            CAPTURE(language->tag);
            if (!sources().contains(std::string(key.substr(0, key.find('\0'))))) {
                FAIL_CHECK("no source has: " << key);
            }
        }
    }
}

TEST_CASE("No translation is left as fuzzy or obsolete", "[messages]") {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(JW_SOURCE_ROOT "/app/languages")) {
        ++files;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            CAPTURE(entry.path().filename().string(), line);
            const bool fuzzy = line.starts_with("#,") && line.find("fuzzy") != std::string::npos;
            CHECK_FALSE((fuzzy || line.starts_with("#~")));
        }
    }
    CHECK(files > 0);
}

TEST_CASE("Every translation has the arguments of its message", "[messages]") {
    for (const Language* language : translated_languages()) {
        for (const auto& [key, plural] : sources()) {
            const char* const found = language->messages.find(key);
            if (found == nullptr) { continue; }
            CAPTURE(language->tag, key, found);
            CHECK(placeholders(found) == placeholders(plural));
        }
    }
}

TEST_CASE("A message is the English one until a language is set and after it is set back", "[messages]") {
    CHECK(language() == "en");
    CHECK(std::string(tr("Predict, then see.")) == "Predict, then see.");
    CHECK(tr("{0} and {1}", "A", "B") == "A and B");
    {
        const test::InLanguage chinese("zh-Hant");
        CHECK(language() == "zh-Hant");
        CHECK(std::string(tr("Predict, then see.")) != "Predict, then see.");
        CHECK(tr("{0} and {1}", "A", "B") == "A 與 B");
        CHECK_FALSE(set_language("tlh"));
        CHECK(language() == "zh-Hant");
    }
    CHECK(tr("{0} and {1}", "A", "B") == "A and B");
}

TEST_CASE("A count takes the form of its number", "[messages]") {
    CHECK(tr_count(1, "{0} equation", "{0} equations") == "1 equation");
    CHECK(tr_count(0, "{0} equation", "{0} equations") == "0 equations");
    const test::InLanguage chinese("zh-Hant");
    CHECK(tr_count(1, "{0} equation", "{0} equations") == "1 個方程式");
    CHECK(tr_count(3, "{0} equation", "{0} equations") == "3 個方程式");
}

TEST_CASE("A message without a translation and bytes that are no catalogue are English", "[messages]") {
    const test::InLanguage chinese("zh-Hant");
    const char* const unknown = "zzz";
    CHECK(tr(unknown) == unknown);
    constexpr unsigned char junk[] = {1, 2, 3};
    CHECK(MessageCatalogue(junk).find("one") == nullptr);
}

TEST_CASE("A translation that asks for arguments that are not there is not used", "[messages]") {
    // as if the sentence were another one with two arguments
    const test::InLanguage chinese("zh-Hant");
    CHECK(messages::filled("{0} and {1}", "{0} alone", 1, fmt::make_format_args("A")) == "A alone");
}

TEST_CASE("Messages can be read while another thread changes the language", "[messages]") {
    std::thread changing([] {
        for (int k = 0; k < 1000; ++k) { set_language(k % 2 == 0 ? "zh-Hant" : "en"); }
    });
    const std::string english = "A and B";
    for (int k = 0; k < 1000; ++k) {
        const std::string text = tr("{0} and {1}", "A", "B");
        CHECK((text == english || text == "A 與 B"));
    }
    changing.join();
    set_language("en");
}

}  // namespace jw
