#pragma once

#include <string>
#include <utility>
#include <vector>

/// The keys of lesson files as data, from which the schema for editors is made. A test compares them with
/// what the reader asks for (lessons/asked_keys.hpp): names, types, words and ranges.
namespace jw {

/// Type of a key's value, by the access of `Fields` that reads it.
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
    tensor,  ///< three or six numbers, or three rows of three
    texts,
    table,
    tables,  ///< a list of tables, or one
    any,     ///< read elsewhere
};

/// A key of a table.
struct Key {
    std::string name;
    KeyKind kind = KeyKind::text;
    std::string about;  ///< a line for the editor
    bool required = false;
    std::vector<std::string> words = {};  ///< of a word; of a text those that mean something of their own
    std::string pattern = {};             ///< of a text that is none of the words, a regular expression
    std::string table = {};               ///< the KeyTable of a table or of tables
    int least = 0;                        ///< of a whole number, or of the entries of a list
    int most = 0;                         ///< likewise; 0 for a list: no limit
};

/// True for keys that a subtable named by a language may have too.
constexpr bool is_translated(KeyKind kind) {
    return kind == KeyKind::words || kind == KeyKind::plain_words || kind == KeyKind::list_of_words;
}

/// All keys of one kind of table.
struct KeyTable {
    std::string name;
    std::vector<Key> keys;
    bool exactly_one = false;  ///< of its keys is there
};

/// Every kind of table of a lesson; the first is the lesson itself.
std::vector<KeyTable> key_tables();

/// Parts of that list.
void add_scene_tables(std::vector<KeyTable>& tables);
void add_motion_tables(std::vector<KeyTable>& tables);
void add_claim_tables(std::vector<KeyTable>& tables);

// ways to say a key
inline Key required(Key key) {
    key.required = true;
    return key;
}
inline Key word_key(std::string name, std::string about, std::vector<std::string> words) {
    return {std::move(name), KeyKind::word, std::move(about), false, std::move(words)};
}
inline Key table_key(std::string name, KeyKind kind, std::string about, std::string table) {
    return {std::move(name), kind, std::move(about), false, {}, {}, std::move(table)};
}
inline Key counted_key(std::string name, KeyKind kind, std::string about, int least, int most) {
    return {std::move(name), kind, std::move(about), false, {}, {}, {}, least, most};
}
/// The key with "_deg" and with "_rad" before `per`.
inline void add_angle(
    std::vector<Key>& keys, const std::string& name, KeyKind kind, const std::string& about,
    const std::string& per = {}) {
    keys.push_back({name + "_deg" + per, kind, about});
    keys.push_back({name + "_rad" + per, kind, about});
}

}  // namespace jw
