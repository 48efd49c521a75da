#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

/// Texts for people in several languages.
namespace jw {

/// A text: as a string it is what is shown, and it keeps what it is in other languages. Texts are in the
/// language of their lesson until `show` is called.
class Text : public std::string {
public:
    /// By language tag: "zh-Hant".
    using Translations = std::map<std::string, std::string, std::less<>>;

    Text() = default;
    // as good as a string wherever one is written down
    Text(std::string own) : std::string(std::move(own)) {}
    Text(const char* own) : std::string(own) {}

    /// In the language of the lesson.
    const std::string& own() const { return own_ ? *own_ : *this; }
    const Translations& translations() const { return translations_; }
    void translate(std::string tag, std::string text) {
        translations_.insert_or_assign(std::move(tag), std::move(text));
    }

    /// Shows the text in the language `tag`, or in the nearest wider one that it is known in ("zh-Hant" for
    /// "zh-Hant-TW"), else in that of the lesson, as for the empty tag.
    void show(std::string_view tag);
    /// Without line feeds at its end, in every language.
    void drop_line_feeds();

private:
    std::optional<std::string> own_;  ///< there while another language is shown
    Translations translations_;
};

/// True if they are the same in every language, whichever is shown.
bool same_in_all_languages(const Text& a, const Text& b);

}  // namespace jw
