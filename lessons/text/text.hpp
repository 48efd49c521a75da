#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

/// Texts for people in several languages, and language tags: BCP 47, as far as a text needs them.
namespace jw {

/// A text with its translations. As a string, it is the text that is shown: the one in the language of the
/// lesson until `show` is called.
class Text : public std::string {
public:
    /// By language tag: "zh-Hant".
    using Translations = std::map<std::string, std::string, std::less<>>;

    Text() = default;
    // implicit: a string can be used wherever a text is expected
    Text(std::string own) : std::string(std::move(own)) {}
    Text(const char* own) : std::string(own) {}

    /// The text in the language of the lesson.
    const std::string& own() const { return own_ ? *own_ : *this; }
    const Translations& translations() const { return translations_; }
    void translate(std::string tag, std::string text) {
        translations_.insert_or_assign(std::move(tag), std::move(text));
    }

    /// Shows the text in the language `tag`, or in the nearest wider one that it has ("zh-Hant" for
    /// "zh-Hant-TW"), or else in that of the lesson. An empty tag means the language of the lesson.
    void show(std::string_view tag);
    /// Removes the line feeds at the end of the text, in every language.
    void drop_line_feeds();

private:
    std::optional<std::string> own_;  ///< set while another language is shown
    Translations translations_;
};

/// True if both are the same in every language, independent of the one that is shown.
bool same_in_all_languages(const Text& a, const Text& b);

/// True for a language of two or three letters with, at most, a script, a region and variants, each in the
/// case that the standard recommends: "de", "pt-BR", "zh-Hant", "zh-Hant-TW", "de-CH-1996".
/// @source RFC 5646, sections 2.1 and 2.1.1
bool is_language_tag(std::string_view text);

/// The tag that was probably meant: another case, or underscores between its parts; empty if there is none.
std::string meant_language_tag(std::string_view text);

/// Marks a text of a table as a message that is translated where it is shown
/// (app/session/wording/messages.hpp).
constexpr const char* tr_later(const char* english) { return english; }

}  // namespace jw
