#pragma once

#include <fmt/core.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/wording/message_catalogue.hpp"
#include "lessons/text/text.hpp"

/// The program's own sentences in the language of the reader.
///
/// The English sentence is the key of its translations (app/languages/TAG.po). Arguments are numbered in
/// braces, {0}, {1}, so that a translation may have them in another order. A message is a whole sentence, or
/// a part that means the same everywhere: sentences are not assembled from grammatical pieces.
///
/// Words that are also read as input stay English: names of joint types, quantities and experiments,
/// commands, keys of JSON.
namespace jw {

struct Language {
    const char* tag;   ///< "zh-Hant", as in `--language` and in the names of files
    const char* name;  ///< in the language itself
    MessageCatalogue messages;
};

/// English, which needs no translations, then the others.
std::span<const Language> languages();

/// Makes the language with that tag the language of all messages from now on, in all threads. Texts that were
/// made before stay as they are.
/// @return false, with nothing changed, if there is none
bool set_language(std::string_view tag);
/// Tag of the present language.
std::string_view language();

/// The message in the present language; lives as long as the program if `english` does.
const char* tr(const char* english);

/// A message that is translated only when it is read, since the language may change until then.
struct Message {
    std::string english;  ///< with {0}, {1} for its arguments; "{0}" for the words of an author
    std::vector<std::string> arguments;  ///< as they are shown

    friend bool operator==(const Message&, const Message&) = default;
};
std::string tr(const Message& message);

namespace messages {

/// The translation of `key`, or else `english`, with the arguments put in. A translation that asks for
/// missing arguments is not used.
std::string filled(
    std::string_view key, std::string_view english, int count, const fmt::format_args& arguments);

inline std::string_view view_of(fmt::string_view text) { return {text.data(), text.size()}; }

}  // namespace messages

/// The message with its arguments; those of the English message are checked at compile time.
template <class... Arguments>
requires(sizeof...(Arguments) > 0) std::string
    tr(fmt::format_string<const Arguments&...> english, const Arguments&... arguments) {
    const std::string_view text = messages::view_of(english);
    return messages::filled(text, text, 1, fmt::make_format_args(arguments...));
}

/// A message about `count` things; {0} is the count, {1} and so on are the other arguments.
template <class... Arguments>
std::string tr_count(
    int count, fmt::format_string<const int&, const Arguments&...> one,
    fmt::format_string<const int&, const Arguments&...> several, const Arguments&... arguments) {
    const std::string_view key = messages::view_of(one);
    return messages::filled(
        key, count == 1 ? key : messages::view_of(several), count,
        fmt::make_format_args(count, arguments...));
}

}  // namespace jw
