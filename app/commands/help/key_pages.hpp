#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "lessons/format/key.hpp"

/// Pages about the keys of a lesson's tables, in several formats. All is made from lessons/format.
namespace jw {

/// A table of a lesson, at a place where it may stand.
struct KeyPage {
    std::string path;        ///< "joint", "body.shape"; "lesson" for the lesson itself
    std::string heading;     ///< as in a file: "[[joint]]", "[body.rotation]"
    std::string_view about;  ///< a line
    const KeyTable* table = nullptr;
};

/// All tables, each at its first place, behind the one that contains it.
std::vector<KeyPage> key_pages();
/// The table at "torque.table"; nothing if none may stand there.
std::optional<KeyPage> key_page(const std::string& path);

/// Paths of all tables with a line about each.
void write_key_list(const std::vector<KeyPage>& all, std::ostream& out);
/// The page about a table, for a terminal.
void write_key_page(const std::vector<KeyPage>& all, const KeyPage& page, std::ostream& out);
/// Pages as Markdown; all of them are docs/keys.md.
void write_keys_markdown(
    const std::vector<KeyPage>& all, const std::vector<KeyPage>& wanted, std::ostream& out);
/// Pages as JSON (docs/command-line.md).
void write_keys_json(const std::vector<KeyPage>& all, const std::vector<KeyPage>& wanted, std::ostream& out);

}  // namespace jw
