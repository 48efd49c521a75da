#include <algorithm>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/text_table.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/format/key.hpp"

namespace jw {

namespace {

/// A table of a lesson, at a place where it can be.
struct KeyPage {
    std::string path;        ///< "joint", "body.shape"; "lesson" for the lesson itself
    std::string heading;     ///< as in a file: "[[joint]]", "[body.rotation]"
    std::string_view about;  ///< a line
    const KeyTable* table = nullptr;
};

constexpr const char* kHeadOfKeys =
    "# Keys of a lesson\n\n"
    "Written by `./dev golden` from `jointwise keys --format markdown`; do not edit. The texts are in\n"
    "`lessons/format`.\n\n"
    "Every table of a lesson file with all its keys. `[table]` is written once, `[[table]]` once for each "
    "entry.\n"
    "[writing-a-lesson.md](writing-a-lesson.md) says how the tables work together. A text for people can "
    "be repeated in\n"
    "another language: in a table that is named by the tag of that language, such as `[joint.zh-Hant]`.\n";

/// A key with all its spellings.
struct KeyLine {
    std::vector<std::string> names;
    std::string value;
    std::string about;
    bool required = false;
};

std::string counted_text(const Key& key, const std::string& of_what) {
    if (key.least > 0 && key.least == key.most) { return std::to_string(key.least) + ' ' + of_what; }
    if (key.most > 0) {
        return std::to_string(key.least) + " to " + std::to_string(key.most) + ' ' + of_what;
    }
    return key.least > 0 ? std::to_string(key.least) + " or more " + of_what : "a list of " + of_what;
}

/// "[[joint]]", "[body.rotation]".
std::string heading_of(const std::string& path, const Key& key) {
    return key.kind == KeyKind::tables ? "[[" + path + "]]" : '[' + path + ']';
}

std::string path_below(const KeyPage& page, std::string_view key) {
    return (page.table == &key_tables().front() ? "" : page.path + '.') + std::string(key);
}

/// "table [torque.table], with the keys of [force.table]".
std::string table_text(const std::vector<KeyPage>& all, const KeyPage& page, const Key& key) {
    const std::string heading = heading_of(path_below(page, key.name), key);
    const KeyPage& first = *std::ranges::find(all, &key_table(key.table), &KeyPage::table);
    return (key.kind == KeyKind::tables ? "tables " : "table ") + heading +
           (first.heading == heading ? "" : ", with the keys of " + first.heading);
}

std::string value_of(const std::vector<KeyPage>& all, const KeyPage& page, const Key& key) {
    switch (key.kind) {
        case KeyKind::text:
            return key.words == nullptr ? "text" : "text, or one of " + comma_list(key.words());
        case KeyKind::words: return "text, with formulas between dollar signs";
        case KeyKind::plain_words: return "text";
        case KeyKind::formula: return "formula";
        case KeyKind::word: return "one of " + comma_list(key.words());
        case KeyKind::number: return "number";
        case KeyKind::positive: return "number above 0";
        case KeyKind::not_negative: return "number, 0 or more";
        case KeyKind::whole_number:
            if (key.least == key.most) { return std::to_string(key.least); }
            return "whole number from " + std::to_string(key.least) + " to " + std::to_string(key.most);
        case KeyKind::flag: return "true or false";
        case KeyKind::vector: return "three numbers";
        case KeyKind::direction: return "three numbers, not all 0";
        case KeyKind::numbers: return counted_text(key, "numbers");
        case KeyKind::vectors: return counted_text(key, "vectors of three numbers");
        case KeyKind::tensor: return "three or six numbers, or three rows of three";
        case KeyKind::list_of_words:
        case KeyKind::texts: return counted_text(key, "texts");
        case KeyKind::table:
        case KeyKind::tables: return table_text(all, page, key);
        case KeyKind::any: break;
    }
    return "depends on the key that is changed";
}

std::vector<KeyLine> lines_of(const std::vector<KeyPage>& all, const KeyPage& page) {
    std::vector<KeyLine> lines;
    const Key* last = nullptr;
    for (const SpelledKey& spelled : spelled_keys(*page.table)) {
        if (spelled.key != last) {
            lines.push_back({{}, value_of(all, page, *spelled.key), "", spelled.key->required});
        }
        last = spelled.key;
        lines.back().names.push_back(spelled.name);
        lines.back().about = spelled.about;
    }
    return lines;
}

/// Names as code of Markdown.
std::string as_code(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) { all += (all.empty() ? "`" : ", `") + name + '`'; }
    return all;
}

std::string note_of(const KeyTable& table) { return table.exactly_one ? "Exactly one of these keys." : ""; }

/// The table at "torque.table"; nothing if none can be there.
std::optional<KeyPage> key_page(const std::string& path) {
    KeyPage page{"lesson", "The lesson itself", "keys at the beginning of the file", &key_tables().front()};
    if (path == page.path) { return page; }
    std::istringstream names(path);
    for (std::string name; std::getline(names, name, '.');) {
        const Key* key = find_key(*page.table, name);
        if (key == nullptr || key->table.empty()) { return std::nullopt; }
        const std::string here = path_below(page, name);
        page = {here, heading_of(here, *key), key->about, &key_table(key->table)};
    }
    return page;
}

/// All tables, each at its first place, after the one that contains it.
std::vector<KeyPage> key_pages() {
    std::vector<KeyPage> pages{*key_page("lesson")};
    for (std::size_t k = 0; k < pages.size(); ++k) {
        for (const Key& key : pages[k].table->keys) {
            if (key.table.empty()) { continue; }
            const KeyTable* table = &key_table(key.table);
            if (std::ranges::find(pages, table, &KeyPage::table) != pages.end()) { continue; }
            const std::string path = path_below(pages[k], key.name);
            pages.push_back({path, heading_of(path, key), key.about, table});
        }
    }
    return pages;
}

/// Paths of all tables with a line about each.
void write_key_list(const std::vector<KeyPage>& all, std::ostream& out) {
    std::size_t width = 0;
    for (const KeyPage& page : all) { width = std::max(width, page.path.size()); }
    for (const KeyPage& page : all) {
        out << page.path << std::string(width + 2 - page.path.size(), ' ') << page.about << '\n';
    }
}

/// The page about a table, for a terminal.
void write_key_page(const std::vector<KeyPage>& all, const KeyPage& page, std::ostream& out) {
    out << page.heading << ": " << page.about << '\n';
    for (const KeyLine& line : lines_of(all, page)) {
        out << "\n  " << comma_list(line.names) << (line.required ? " (required)" : "") << '\n'
            << "      " << line.about << "\n      " << line.value << '\n';
    }
    if (!note_of(*page.table).empty()) { out << "\n  " << note_of(*page.table) << '\n'; }
}

/// Pages as Markdown; all of them are docs/keys.md.
void write_keys_markdown(
    const std::vector<KeyPage>& all, const std::vector<KeyPage>& wanted, std::ostream& out) {
    out << kHeadOfKeys;
    for (const KeyPage& page : wanted) {
        const bool is_lesson = page.table == all.front().table;
        out << "\n## " << (is_lesson ? page.heading : '`' + page.heading + '`') << "\n\n"
            << page.about << "\n\n| key | value | meaning |\n| --- | --- | --- |\n";
        for (const KeyLine& line : lines_of(all, page)) {
            out << "| " << as_code(line.names) << (line.required ? ", required" : "") << " | "
                << markdown_cell(line.value) << " | " << markdown_cell(line.about) << " |\n";
        }
        if (!note_of(*page.table).empty()) { out << '\n' << note_of(*page.table) << '\n'; }
    }
}

/// Pages as JSON (docs/command-line.md).
void write_keys_json(const std::vector<KeyPage>& all, const std::vector<KeyPage>& wanted, std::ostream& out) {
    Json document = Json::array();
    for (const KeyPage& page : wanted) {
        Json keys = Json::array();
        for (const KeyLine& line : lines_of(all, page)) {
            keys.push_back(
                {{"names", line.names},
                 {"value", line.value},
                 {"about", line.about},
                 {"required", line.required}});
        }
        document.push_back(
            {{"path", page.path},
             {"about", page.about},
             {"exactly_one", page.table->exactly_one},
             {"keys", keys}});
    }
    out << json_document({{"format", "jointwise keys"}, {"version", kJsonVersion}, {"tables", document}});
}

struct KeysOptions {
    std::string table;  ///< as typed; empty: all
    std::string format;
};

/// "joint" from "[[joint]]".
std::string without_brackets(std::string typed) {
    std::erase_if(typed, [](char c) { return c == '[' || c == ']'; });
    return typed;
}

KeyPage wanted_page(const std::vector<KeyPage>& all, const std::string& typed) {
    const std::string path = without_brackets(typed);
    if (const std::optional<KeyPage> page = key_page(path)) { return *page; }
    std::vector<std::string> paths;
    for (const KeyPage& page : all) { paths.push_back(page.path); }
    const std::string hint = did_you_mean(path, paths);
    throw bad_input(
        "no table " + in_quotes(typed) + " in a lesson; expected a table such as 'joint' or 'body.shape'",
        hint.empty() ? "'jointwise keys' lists them" : hint);
}

Exit show_keys(const KeysOptions& options, const Streams& streams) {
    const std::vector<KeyPage> all = key_pages();
    const std::vector<KeyPage> wanted =
        options.table.empty() ? all : std::vector{wanted_page(all, options.table)};
    if (options.format == "json") {
        write_keys_json(all, wanted, streams.out);
    } else if (options.format == "markdown") {
        write_keys_markdown(all, wanted, streams.out);
    } else if (options.table.empty()) {
        write_key_list(all, streams.out);
    } else {
        write_key_page(all, wanted.front(), streams.out);
    }
    return Exit::done;
}

}  // namespace

void add_keys(const CommandLine& line) {
    auto [command, options] = add_command<KeysOptions>(
        line, "keys", "show the keys of a lesson's tables, with their values", show_keys,
        "Example: jointwise keys joint");
    add_value(
        command, "TABLE", options.table, "", "table such as joint or body.shape; without it, all are listed");
    add_format_option(command, options.format, {"text", "markdown", "json"});
}

}  // namespace jw
