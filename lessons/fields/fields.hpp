#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "core/numerics/linear.hpp"
#include "lessons/diagnostics/problems.hpp"
#include "lessons/format/key.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/text/text.hpp"
#include "lessons/typed/typed.hpp"

/// Typed access to a TOML table. Collects mistakes instead of throwing.
namespace jw {

/// Longest list that is read: a longer list is an error, so that reading does not take a long time.
inline constexpr std::size_t kLongestList = 10000;
/// Longest text, in bytes.
inline constexpr std::size_t kLongestText = 20000;
/// A shorter vector is not a direction: normalising it would amplify rounding.
inline constexpr double kShortestDirection = 1e-9;

/// A number and the characters that stand for it.
struct TypedText {
    double value = 0.0;
    std::string text;
    SourceSpan span;
};

/// "a table", "a number", ...: for messages.
std::string kind_of(const toml::node& node);

/// One table. Keys that are read are remembered; `finish` reports the others as unknown.
///
/// Accesses throw std::logic_error for keys that the format (lessons/format) does not describe, or describes
/// with another type. They do not throw in a table that the format does not describe.
class Fields {
public:
    Fields(
        const toml::table& table, std::string what, Problems& problems, const KeyTable* described = nullptr)
        : table_(&table), described_(described), what_(std::move(what)), problems_(&problems) {}

    bool has(std::string_view key) {
        check_described(key);
        return find(key) != nullptr;
    }
    /// Place of the table's header, or of a key's value.
    SourceSpan span() const { return span_of(table_->source()); }
    SourceSpan span(std::string_view key) const;
    Problems& problems() const { return *problems_; }
    /// Reports a mistake.
    void report(Code code, const SourceSpan& at, std::string message, std::string hint = {}) const {
        problems_->add(code, at, std::move(message), std::move(hint));
    }
    /// Place of a byte of the text under `key`.
    SourceSpan place_in(std::string_view key, std::size_t at) const;
    /// Name of the table in messages: "joint", "joint 'hinge'".
    const std::string& what() const { return what_; }
    void call(std::string what) { what_ = std::move(what); }

    // absent keys give nothing; wrong ones give nothing and a diagnostic
    IfGiven<std::string> text(std::string_view key);
    /// Words for people, with formulas between dollar signs (docs/mathematics.md), in every language in which
    /// the table has them (below). Reports formulas that cannot be read.
    ///
    /// A subtable named by a language tag, as [zh-Hant], has the same keys with the same words in that
    /// language.
    IfGiven<Text> words(std::string_view key, Audience audience = Audience::students);
    /// Words without formulas.
    IfGiven<Text> plain_words(std::string_view key);
    /// A list of words; in each language it has the same number of entries.
    IfGiven<std::vector<Text>> list_of_words(std::string_view key);
    /// A formula without dollar signs.
    IfGiven<std::string> formula(std::string_view key);
    IfGiven<double> number(std::string_view key);
    IfGiven<double> positive(std::string_view key);
    IfGiven<double> not_negative(std::string_view key);
    IfGiven<int> integer(std::string_view key, int least, int most);
    /// An integer in the range that the format describes.
    IfGiven<int> integer(std::string_view key);
    IfGiven<bool> flag(std::string_view key);
    IfGiven<Vec3> vector(std::string_view key);
    /// A list of vectors, as many as the format describes.
    IfGiven<std::vector<Vec3>> vectors(std::string_view key);
    /// A vector that is not zero.
    IfGiven<Vec3> direction(std::string_view key);
    /// `count` numbers, or any number of them up to `most`. @param expected  for the message, if given
    IfGiven<std::vector<double>> numbers(
        std::string_view key, std::size_t count = 0, std::size_t most = kLongestList,
        std::string_view expected = {});
    /// Three rows of three numbers.
    IfGiven<Mat3> matrix(std::string_view key);
    /// True if the entries of a list are lists themselves.
    bool is_nested(std::string_view key);
    IfGiven<std::vector<Located<std::string>>> texts(std::string_view key);
    std::optional<Fields> table(std::string_view key);
    /// A list of tables, or one table as a list of one.
    std::vector<Fields> tables(std::string_view key, std::size_t most = kLongestList);
    /// Index of the text among `words`.
    std::optional<std::size_t> word(std::string_view key, const std::vector<std::string>& words);
    /// Index of the text among the words that the format describes.
    std::optional<std::size_t> word(std::string_view key);
    /// The value that the word under `key` stands for.
    template <class E, std::size_t N>
    std::optional<E> word(std::string_view key, const std::array<EnumWord<E>, N>& table) {
        const auto found = word(key, words_of(table));
        return found ? std::optional<E>(table[*found].value) : std::nullopt;
    }

    /// A number under `key` + "_deg" or `key` + "_rad" [rad].
    IfGiven<double> angle(std::string_view key);

    /// The numbers under a key as they were typed; none if it is not there.
    std::vector<TypedText> typed_numbers(std::string_view key) const;

    /// The value as it stands in the file, for copying; nothing if the key is not there.
    const toml::node* raw(std::string_view key) {
        check_described(key);
        return find(key);
    }

    /// Reports that `key` must be given.
    void missing(std::string_view key, std::string_view expected);
    /// Reports a key that is not present; a key with a wrong value is present.
    void require(std::string_view key, std::string_view expected);
    /// The same, with the expected value that the format describes.
    void require(std::string_view key);
    /// True if at most one of the keys is present; otherwise reports them.
    bool at_most_one(const std::vector<std::string>& keys);
    /// Reports unknown keys.
    void finish();

private:
    const toml::node* find(std::string_view key);
    /// A text that can be shown, without carriage returns; reports any other value.
    IfGiven<std::string> text_in(const toml::node& node, const std::string& what);
    IfGiven<Text> words_in(std::string_view key, bool has_formulas, Audience audience);
    /// The entries of a list of texts; reports any other value. @param expected  of the list, "a list of
    /// names"
    IfGiven<std::vector<Located<std::string>>> texts_in(
        const toml::node& node, const std::string& what, std::string_view expected);
    /// Subtables named by language tags.
    std::vector<std::pair<std::string, const toml::table*>> languages() const;
    /// Reports formulas of words that cannot be read.
    void check_formulas(const Located<std::string>& words);
    /// Keeps the text for checks of all texts (ReadResult::texts).
    void record(std::string_view key, const SourceSpan& span, const Text& text, Audience audience);
    /// Reports keys of a language that are not words of this table, and words that exist only in that
    /// language.
    void finish_language(const std::string& tag, const toml::table& table);
    /// True for a subtable that was meant as a language; reports what is wrong with its name.
    bool is_misnamed_language(const toml::key& key, const toml::node& node);
    /// The key as the format describes it; nullptr in a table that it does not describe.
    /// @param kinds  the key must have one of them; empty: any
    /// @throws std::logic_error if the format does not describe the key in this way
    const Key* check_described(std::string_view key, std::initializer_list<KeyKind> kinds = {}) const;
    /// A number of this kind. @param expected  for the message: "above 0"
    IfGiven<double> number_that(
        std::string_view key, KeyKind kind, bool (*fits)(double), const char* expected);
    /// Entries of a list and how messages name them: "row", "" and " rows" around their number.
    struct EntryWords {
        std::string one;
        std::string before;
        std::string after;
    };
    /// A list of `least` to `most` vectors.
    IfGiven<std::vector<Vec3>> vectors_in(
        std::string_view key, int least, int most, const EntryWords& words, const std::string& expected);
    /// The table under a key of this table, or in the list under that key.
    Fields below(const toml::table& table, std::string_view key) const;
    /// A key that has not been read and probably means `key`: misspelt, or with another unit or none.
    const toml::key* meant_as(std::string_view key) const;
    /// True if an unknown key means one that `expected` names in quotes: `finish` reports that key.
    bool has_instead_of(std::string_view expected) const;
    void wrong_type(std::string_view key, const toml::node& node, std::string_view expected);
    std::optional<double> number_in(const toml::node& node, const std::string& what);
    IfGiven<std::vector<double>> list_in(
        const toml::node& node, const std::string& what, std::size_t count, std::size_t most = kLongestList,
        std::string_view expected = {});

    const toml::table* table_;
    const KeyTable* described_;
    std::string what_;
    Problems* problems_;
    std::set<std::string, std::less<>> known_;
    std::set<std::string, std::less<>> told_;   ///< unknown keys that have been reported already
    std::set<std::string, std::less<>> words_;  ///< keys read as words: a language may have them
};

/// The table in the bytes of a file; reports why if there is none. A byte order mark is removed from
/// `source`, and bytes that are not UTF-8 are replaced, so that it can be shown.
std::optional<toml::table> parse_toml(std::string& source, Problems& problems);

/// Reads a file: `take` gets its table, if it is TOML, and the list for its mistakes.
template <class Take>
void read_toml(FileRead& read, std::string source, std::string file_name, Take&& take) {
    read.source = std::move(source);
    Problems problems(std::move(file_name), read.source);
    if (auto table = parse_toml(read.source, problems)) { take(*table, problems); }
    read.diagnostics = problems.take();
    read.texts = std::move(problems.texts());
}

}  // namespace jw
