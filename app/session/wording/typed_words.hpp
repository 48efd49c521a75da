#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/numerics/linear.hpp"

/// Sentences that people type, read from left to right.
namespace jw {

/// Error that says what is wrong with a sentence and what was expected; a hint has its own line.
class Unreadable : public std::runtime_error {
public:
    explicit Unreadable(const std::string& message, const std::string& hint = {})
        : std::runtime_error(hint.empty() ? message : message + "\nhint: " + hint) {}
};

class Words {
public:
    /// Words are separated by blanks; several words in double quotes are one.
    /// @throws Unreadable for a quote that is not closed
    explicit Words(std::string_view text);

    bool done() const { return next_ == words_.size(); }
    /// The next word, empty at the end.
    std::string_view peek() const;
    /// All that is left, joined by blanks.
    std::string rest() const;

    /// Skips `phrase`, one or several words, if it comes next.
    bool take(std::string_view phrase);
    /// The name from `names` that comes next, the longest one if several do; names may have blanks.
    /// @param kind  kind of part that is named, for messages: "joint"
    /// @return its index
    /// @throws Unreadable if there is none
    std::size_t name(const std::vector<std::string>& names, const std::string& kind);
    /// Index of the word that is all of the remaining text.
    std::size_t last_word(const std::vector<std::string>& words, const std::string& kind);
    /// @throws Unreadable if the next word is not a finite number of at most 1e9 in size
    double number(const std::string& what);
    /// The next word or words in quotes, as they are. @throws Unreadable at the end
    std::string text(const std::string& what);
    /// Three numbers [m, or without a unit].
    Vec3 vector(const std::string& what);
    int integer(const std::string& what);
    /// @throws Unreadable if something is left
    void finish() const;

private:
    struct Word {
        std::string text;
        bool quoted = false;
    };
    std::string joined(std::size_t count) const;
    std::string guess(const std::vector<std::string>& names) const;

    std::vector<Word> words_;
    std::size_t next_ = 0;
};

/// A name as it is written in a sentence: in quotes if it has blanks, or could be taken for the beginning of
/// another name.
std::string quoted_name(const std::string& name, const std::vector<std::string>& names);

}  // namespace jw
