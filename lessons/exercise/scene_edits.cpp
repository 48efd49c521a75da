#include "lessons/exercise/scene_edits.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "lessons/exercise/scene_nodes.hpp"
#include "lessons/text/text.hpp"
#include "lessons/text/utf8.hpp"

namespace jw {

namespace {

/// Byte offsets in a text by line and column, both from 1; columns count characters.
class Places {
public:
    explicit Places(const std::string& text) : text_(&text) {
        starts_.push_back(0);
        for (std::size_t k = 0; k < text.size(); ++k) {
            if (text[k] == '\n') { starts_.push_back(k + 1); }
        }
    }
    std::size_t line(std::size_t number) const {
        return number - 1 < starts_.size() ? starts_[number - 1] : text_->size();
    }
    std::size_t byte(const toml::source_position& at) const {
        std::size_t k = line(at.line);
        for (std::size_t column = 1; column < at.column && k < text_->size(); ++column) {
            ++k;
            while (k < text_->size() && !starts_character((*text_)[k])) { ++k; }
        }
        return k;
    }

private:
    const std::string* text_;
    std::vector<std::size_t> starts_;
};

std::vector<std::string> parts_of(const std::string& key) {
    std::vector<std::string> parts(1);
    for (const char c : key) {
        if (c == '.') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

toml::node* child_of(toml::node& node, const std::string& part) {
    if (toml::table* const table = node.as_table()) { return table->get(part); }
    toml::array* const list = node.as_array();
    const auto k = list != nullptr ? index_of_entry(*list, part) : std::nullopt;
    return k ? list->get(*k) : nullptr;
}

toml::node* node_at(toml::table& root, const std::vector<std::string>& parts) {
    toml::node* node = &root;
    for (const std::string& part : parts) {
        node = child_of(*node, part);
        if (node == nullptr) { return nullptr; }
    }
    return node;
}

/// Lines at which tables with a header of their own begin.
void collect_headers(const toml::node& node, std::set<std::size_t>& lines) {
    if (const toml::table* const table = node.as_table()) {
        if (!table->is_inline() && table->source().begin.line > 0) {
            lines.insert(table->source().begin.line);
        }
        for (const auto& [key, value] : *table) { collect_headers(value, lines); }
    } else if (const toml::array* const list = node.as_array()) {
        for (const toml::node& entry : *list) {
            if (entry.is_table()) { collect_headers(entry, lines); }
        }
    }
}

std::set<std::size_t> headers_of(const toml::table& root) {
    std::set<std::size_t> lines;
    for (const auto& [key, value] : root) { collect_headers(value, lines); }
    return lines;
}

/// Removes the tables that begin at `lines` from the text.
std::string without_headers(
    const std::string& text, const std::set<std::size_t>& all, const std::set<std::size_t>& lines) {
    const Places places(text);
    std::string kept;
    std::size_t from = 0;
    for (const std::size_t line : lines) {
        const auto next = all.upper_bound(line);
        const std::size_t begin = places.line(line);
        if (begin > from) { kept += text.substr(from, begin - from); }
        from = std::max(from, next == all.end() ? text.size() : places.line(*next));
    }
    return kept + text.substr(std::min(from, text.size()));
}

std::string remove_node(
    const std::string& text, const toml::table& root, const toml::node& node, const toml::node& parent,
    const std::string& key) {
    const toml::table* const table = node.as_table();
    if (table != nullptr && !table->is_inline()) {
        return without_headers(text, headers_of(root), {node.source().begin.line});
    }
    const toml::table* const around = parent.as_table();
    if (around == nullptr || around->is_inline()) { return {}; }
    const Places places(text);
    const auto entry = around->find(key);
    std::string changed = text;
    const std::size_t from = places.line(entry->first.source().begin.line);
    const std::size_t to = places.line(node.source().end.line + 1);
    return changed.erase(from, to - from);
}

/// Adds a new key after the header of its table.
std::string add_key(
    const std::string& text, const toml::node& parent, const SceneEdit& edit, const std::string& key) {
    const toml::table* const table = parent.as_table();
    if (table == nullptr || table->is_inline() || table->source().begin.line == 0) { return {}; }
    std::string changed = text;
    const std::size_t at = Places(text).line(table->source().begin.line + 1);
    return changed.insert(at, key + " = " + edit.value + "\n");
}

std::string edited(const std::string& text, const SceneEdit& edit) {
    std::optional<toml::table> root = scene_tree(text);
    if (!root) { return {}; }
    std::vector<std::string> parts = parts_of(edit.key);
    toml::node* const node = node_at(*root, parts);
    const std::string last = parts.back();
    parts.pop_back();
    toml::node* const parent = node_at(*root, parts);
    if (parent == nullptr || last.empty()) { return {}; }
    // new keys at the top of the file would come before its `format`
    if (node == nullptr && parts.empty()) { return {}; }
    if (node == nullptr) { return edit.value.empty() ? std::string() : add_key(text, *parent, edit, last); }
    if (edit.value.empty()) { return remove_node(text, *root, *node, *parent, last); }
    if (node->source().begin.line == 0) { return {}; }
    const Places places(text);
    std::string changed = text;
    const std::size_t from = places.byte(node->source().begin);
    return changed.replace(from, places.byte(node->source().end) - from, edit.value);
}

/// Lines of the texts of a table, the translated ones too.
void collect_texts(const toml::table& table, std::map<std::size_t, std::size_t>& lines) {
    for (const auto& [key, value] : table) {
        const toml::table* const inner = value.as_table();
        if (key == "text" || key == "summary") {
            lines[key.source().begin.line] = value.source().end.line;
        } else if (inner != nullptr && is_language_tag(key.str())) {
            collect_texts(*inner, lines);
        }
    }
}

}  // namespace

EditedScene with_edits(std::string scene, std::span<const SceneEdit> edits) {
    for (const SceneEdit& edit : edits) {
        std::string changed = edited(scene, edit);
        if (changed.empty()) {
            return {std::move(scene), "there is no '" + edit.key + "' that could be set"};
        }
        scene = std::move(changed);
    }
    return {std::move(scene), {}};
}

std::string without_tables(const std::string& scene, const std::vector<std::string>& names) {
    std::optional<toml::table> root = scene_tree(scene);
    if (!root) { return scene; }
    std::set<std::size_t> lines;
    for (const std::string& name : names) {
        if (const toml::node* const node = root->get(name)) { collect_headers(*node, lines); }
    }
    return without_headers(scene, headers_of(*root), lines);
}

std::string without_texts(const std::string& scene) {
    const std::optional<toml::table> root = scene_tree(scene);
    if (!root) { return scene; }
    std::map<std::size_t, std::size_t> lines;
    collect_texts(*root, lines);
    for (const char* name : {"joint", "driver"}) {
        const toml::array* const list = (*root)[name].as_array();
        if (list == nullptr) { continue; }
        for (const toml::node& entry : *list) {
            if (const toml::table* const table = entry.as_table()) { collect_texts(*table, lines); }
        }
    }
    const Places places(scene);
    std::string kept;
    std::size_t from = 0;
    for (const auto& [first, last] : lines) {
        kept += scene.substr(from, places.line(first) - from);
        from = places.line(last + 1);
    }
    return kept + scene.substr(from);
}

std::string value_in(const std::string& scene, const std::string& key) {
    std::optional<toml::table> root = scene_tree(scene);
    const toml::node* const node = root ? node_at(*root, parts_of(key)) : nullptr;
    return node != nullptr ? node_text(*node) : std::string();
}

std::string claims_in(const std::string& scene) {
    const std::optional<toml::table> root = scene_tree(scene);
    const toml::node* const claims = root ? root->get("expect") : nullptr;
    if (claims == nullptr) { return {}; }
    toml::table kept;
    kept.insert("expect", *claims);
    return table_text(kept);
}

}  // namespace jw
