#pragma once

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

#include <toml++/toml.h>

/// A lesson file as a TOML tree, for changing and comparing it.
namespace jw {

/// The tree of a text; nothing if it is not TOML.
inline std::optional<toml::table> scene_tree(const std::string& text) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error&) { return std::nullopt; }
}

/// Entry of a list of tables by its `name`, or by its number from 0.
inline std::optional<std::size_t> index_of_entry(const toml::array& list, const std::string& part) {
    for (std::size_t k = 0; k < list.size(); ++k) {
        const toml::table* const table = list[k].as_table();
        const auto name = table != nullptr ? (*table)["name"].value<std::string>() : std::nullopt;
        if (name == part) { return k; }
    }
    const bool number = !part.empty() && part.size() < 6 &&
                        std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
    if (!number) { return std::nullopt; }
    const std::size_t k = std::stoul(part);
    return k < list.size() ? std::optional<std::size_t>(k) : std::nullopt;
}

/// A table as a file.
inline std::string table_text(const toml::table& table) {
    std::ostringstream out;
    out << toml::toml_formatter{table};
    return out.str() + "\n";
}

inline std::string node_text(const toml::node& node) {
    std::ostringstream out;
    node.visit([&](const auto& value) { out << value; });
    return out.str();
}

}  // namespace jw
