#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/numerics/linear.hpp"

/// Keys of the tables of a lesson file as data: type, unit, range and words.
namespace jw {

/// Type of a key's value: one for each way in which `Fields` reads it.
enum class KeyKind {
    text,
    words,          ///< text for people, with formulas between dollar signs
    plain_words,    ///< text for people without formulas
    list_of_words,  ///< several texts for people
    formula,        ///< a formula without dollar signs
    word,           ///< one of a few words
    number,
    positive,
    not_negative,
    whole_number,
    flag,
    vector,     ///< three numbers
    direction,  ///< three numbers, not all zero
    numbers,
    vectors,  ///< a list of vectors, three numbers each
    tensor,   ///< three or six numbers, or three rows of three
    texts,
    table,
    tables,  ///< a list of tables, or one table
    any,     ///< read elsewhere
};

/// True for keys that a subtable named by a language may have too.
constexpr bool is_translated(KeyKind kind) {
    return kind == KeyKind::words || kind == KeyKind::plain_words || kind == KeyKind::list_of_words;
}

/// How the name of a key gives its unit.
enum class Spelling {
    plain,             ///< not in the name
    angle,             ///< _deg or _rad
    angular_velocity,  ///< _deg_per_s or _rad_per_s
    any,               ///< plain, or as an angle, its rate or its acceleration
};

/// A key of a table.
struct Key {
    std::string_view name;
    KeyKind kind = KeyKind::text;
    std::string_view about;      ///< a line for the editor; the unit is inserted before ; or : or at the end
    std::string_view unit = {};  ///< of its numbers, where it is not in the name
    Spelling spelling = Spelling::plain;
    bool required = false;
    std::string_view expected = {};  ///< of a required key: what the message about its absence expects
    std::vector<std::string> (*words)() =
        nullptr;                    ///< for a word: the words; for a text: those with a special meaning
    std::string_view pattern = {};  ///< for a text that is not one of the words: a regular expression
    std::string_view table = {};    ///< name of the KeyTable of a table or of tables
    int least = 0;                  ///< of a whole number, or of the entries of a list
    int most = 0;                   ///< likewise; 0 for a list: no limit
};

/// All keys of one kind of table.
struct KeyTable {
    std::string_view name;
    std::span<const Key> keys;
    bool exactly_one = false;  ///< exactly one of its keys must be present
};

/// Every kind of table of a lesson; the first is the lesson itself.
std::span<const KeyTable> key_tables();
/// The table of that name. @throws std::logic_error if there is none
const KeyTable& key_table(std::string_view name);
/// The key that has the spelling `name`; nullptr if there is none.
const Key* find_key(const KeyTable& table, std::string_view name);

/// Ending of a key's name, and the unit that it stands for.
struct UnitEnding {
    std::string_view text;
    std::string_view unit;
};
/// Endings of a spelling; the empty one is that of the plain name.
std::span<const UnitEnding> endings_of(Spelling spelling);

/// A name that authors try instead of a key: a symbol of the book, a word of another program.
struct OtherName {
    std::string_view tried;
    std::string_view meant;  ///< a key, without the unit at its end
};

std::span<const OtherName> other_names();

/// The key that an author who typed `tried` meant; empty if it is not among `keys`.
std::string key_meant_by(std::string_view tried, std::span<const std::string> keys);

/// A key as it may stand in a file.
struct SpelledKey {
    std::string name;
    std::string about;
    std::string unit;
    const Key* key = nullptr;
};
/// All spellings of the keys of a table, in its order.
std::vector<SpelledKey> spelled_keys(const KeyTable& table);

/// Unit of the numbers under a key, none if it has no unit or is in no table.
/// @param path keys that lead there, with names or numbers of entries: "body.crank.shape.0.rod.radius"
std::string unit_of_key(std::string_view path);

// functions that make keys
constexpr Key required(Key key, std::string_view expected = {}) {
    key.required = true;
    key.expected = expected;
    return key;
}
constexpr Key spelled(Key key, Spelling spelling) {
    key.spelling = spelling;
    return key;
}
constexpr Key one_of(std::string_view name, std::string_view about, std::vector<std::string> (*words)()) {
    return {.name = name, .kind = KeyKind::word, .about = about, .words = words};
}
constexpr Key in_table(std::string_view name, KeyKind kind, std::string_view about, std::string_view table) {
    return {.name = name, .kind = kind, .about = about, .table = table};
}
constexpr Key counted(std::string_view name, KeyKind kind, std::string_view about, int least, int most) {
    return {.name = name, .kind = kind, .about = about, .least = least, .most = most};
}

/// The words of a list of entries: their `word`, their `name`, or themselves.
template <const auto& entries>
std::vector<std::string> words_in() {
    std::vector<std::string> words;
    for (const auto& entry : entries) {
        if constexpr (requires { entry.word; }) {
            words.emplace_back(entry.word);
        } else if constexpr (requires { entry.name; }) {
            words.emplace_back(entry.name);
        } else {
            words.emplace_back(entry);
        }
    }
    return words;
}

/// Lists of keys or of tables, joined to one list.
template <class T, std::size_t... N>
constexpr auto joined(const std::array<T, N>&... lists) {
    std::array<T, (N + ...)> all{};
    auto next = all.begin();
    ((next = std::ranges::copy(lists, next).out), ...);
    return all;
}

// keys whose values are members of a struct: one line describes, reads and writes each of them

/// A member of any type that a key can have.
using MemberRef = std::variant<bool*, int*, double*, Vec3*, std::optional<double>*, std::optional<Vec3>*>;

/// A key of a table and the member of a T that it fills. An absent key means the value of the member in T{}.
template <class T>
struct MemberKey {
    Key key;
    std::variant<
        bool T::*, int T::*, double T::*, Vec3 T::*, std::optional<double> T::*, std::optional<Vec3> T::*>
        member;

    MemberRef of(T& value) const {
        return std::visit([&](auto pointer) { return MemberRef(&(value.*pointer)); }, member);
    }
};

/// The keys without their members, for the table that they are in.
template <class T, std::size_t N>
constexpr std::array<Key, N> keys_in(const std::array<MemberKey<T>, N>& keyed) {
    std::array<Key, N> keys{};
    std::ranges::transform(keyed, keys.begin(), &MemberKey<T>::key);
    return keys;
}

}  // namespace jw
