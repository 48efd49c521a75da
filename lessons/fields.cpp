#include "lessons/fields.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jw {

namespace {

std::string kind_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table: return "a table";
        case toml::node_type::array: return "a list";
        case toml::node_type::string: return "a text";
        case toml::node_type::integer:
        case toml::node_type::floating_point: return "a number";
        case toml::node_type::boolean: return "true or false";
        default: return "a date";
    }
}

}  // namespace

void Problems::add(const SourceSpan& span, std::string message, std::string hint) {
    list_.push_back({file_, span, std::move(message), std::move(hint)});
}

SourceSpan Problems::span_of(const toml::source_region& region) const {
    SourceSpan span{static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 1};
    if (region.end.line == region.begin.line && region.end.column > region.begin.column) {
        span.length = static_cast<int>(region.end.column - region.begin.column);
    }
    return span;
}

SourceSpan Problems::span_of(const toml::node& node) const { return span_of(node.source()); }

SourceSpan Problems::span_of(const toml::key& key) const { return span_of(key.source()); }

std::vector<Diagnostic> Problems::take() {
    std::ranges::stable_sort(list_, [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.span.line, a.span.column) < std::pair(b.span.line, b.span.column);
    });
    return std::move(list_);
}

const toml::node* Fields::find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
}

bool Fields::has(std::string_view key) { return find(key) != nullptr; }

SourceSpan Fields::span(std::string_view key) const {
    const toml::node* node = table_->get(key);
    return node != nullptr ? problems_->span_of(*node) : span();
}

void Fields::wrong_type(std::string_view key, const toml::node& node, std::string_view expected) {
    problems_->add(
        problems_->span_of(node),
        "'" + std::string(key) + "' is " + kind_of(node) + "; expected " + std::string(expected));
}

std::optional<double> Fields::finite(const toml::node& node, std::string_view what) {
    const std::optional<double> value = node.value<double>();
    if (!value || node.is_boolean()) { return std::nullopt; }
    if (!std::isfinite(*value)) {
        problems_->add(
            problems_->span_of(node), std::string(what) + " is not a finite number; expected one below 1e9");
        return std::nullopt;
    }
    if (std::abs(*value) > kLargestNumber) {
        problems_->add(
            problems_->span_of(node), std::string(what) + " is absurdly large; expected at most 1e9 in size",
            "lengths are in m, times in s");
        return std::nullopt;
    }
    return value;
}

std::optional<Located<std::string>> Fields::text(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_string()) {
        wrong_type(key, *node, "a text in quotes");
        return std::nullopt;
    }
    return Located<std::string>{node->as_string()->get(), problems_->span_of(*node)};
}

std::optional<Located<double>> Fields::number(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_number()) {
        wrong_type(key, *node, "a number");
        return std::nullopt;
    }
    const auto value = finite(*node, "'" + std::string(key) + "'");
    if (!value) { return std::nullopt; }
    return Located<double>{*value, problems_->span_of(*node)};
}

std::optional<Located<double>> Fields::positive(std::string_view key) {
    auto value = number(key);
    if (value && value->value <= 0.0) {
        problems_->add(value->span, "'" + std::string(key) + "' is not positive; expected a number above 0");
        return std::nullopt;
    }
    return value;
}

std::optional<Located<int>> Fields::integer(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_integer()) {
        wrong_type(key, *node, "a whole number");
        return std::nullopt;
    }
    const auto value = node->as_integer()->get();
    if (std::abs(static_cast<double>(value)) > 1e6) {
        problems_->add(
            problems_->span_of(*node), "'" + std::string(key) + "' is absurdly large; expected below 1e6");
        return std::nullopt;
    }
    return Located<int>{static_cast<int>(value), problems_->span_of(*node)};
}

std::optional<Located<bool>> Fields::flag(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_boolean()) {
        wrong_type(key, *node, "true or false");
        return std::nullopt;
    }
    return Located<bool>{node->as_boolean()->get(), problems_->span_of(*node)};
}

std::optional<Located<std::vector<double>>> Fields::numbers(std::string_view key, std::size_t count) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    const std::string expected = count == 3   ? "three numbers"
                                 : count == 4 ? "four numbers"
                                              : "a list of numbers";
    const toml::array* list = node->as_array();
    if (list == nullptr) {
        wrong_type(key, *node, expected);
        return std::nullopt;
    }
    if ((count != 0 && list->size() != count) || list->empty() || list->size() > kLongestList) {
        problems_->add(
            problems_->span_of(*node), "'" + std::string(key) + "' has " + std::to_string(list->size()) +
                                           " entries; expected " + expected);
        return std::nullopt;
    }
    Located<std::vector<double>> out{{}, problems_->span_of(*node)};
    for (const toml::node& entry : *list) {
        if (!entry.is_number()) {
            problems_->add(
                problems_->span_of(entry),
                "an entry of '" + std::string(key) + "' is " + kind_of(entry) + "; expected a number");
            return std::nullopt;
        }
        const auto value = finite(entry, "an entry of '" + std::string(key) + "'");
        if (!value) { return std::nullopt; }
        out.value.push_back(*value);
    }
    return out;
}

std::optional<Located<Vec3>> Fields::vector(std::string_view key) {
    const auto list = numbers(key, 3);
    if (!list) { return std::nullopt; }
    return Located<Vec3>{Vec3(list->value[0], list->value[1], list->value[2]), list->span};
}

std::optional<Located<Vec3>> Fields::direction(std::string_view key) {
    const auto v = vector(key);
    // shorter than this, normalising loses the direction that was meant
    if (v && v->value.norm() < 1e-12) {
        problems_->add(
            v->span,
            "'" + std::string(key) + "' has length 0; expected a direction, three numbers not all zero");
        return std::nullopt;
    }
    return v;
}

std::optional<Located<std::vector<Located<std::string>>>> Fields::texts(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() > kLongestList) {
        wrong_type(key, *node, "a list of texts");
        return std::nullopt;
    }
    Located<std::vector<Located<std::string>>> out{{}, problems_->span_of(*node)};
    for (const toml::node& entry : *list) {
        if (!entry.is_string()) {
            problems_->add(
                problems_->span_of(entry), "an entry of '" + std::string(key) + "' is " + kind_of(entry) +
                                               "; expected a text in quotes");
            return std::nullopt;
        }
        out.value.push_back({entry.as_string()->get(), problems_->span_of(entry)});
    }
    return out;
}

std::optional<Fields> Fields::table(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_table()) {
        wrong_type(key, *node, "a table { ... }");
        return std::nullopt;
    }
    return Fields(*node->as_table(), std::string(key), *problems_);
}

std::vector<Fields> Fields::tables(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) { return {}; }
    if (node->is_table()) { return {Fields(*node->as_table(), std::string(key), *problems_)}; }
    const toml::array* list = node->as_array();
    if (list == nullptr) {
        wrong_type(key, *node, "one or several tables");
        return {};
    }
    std::vector<Fields> out;
    if (list->size() > kLongestList) {
        problems_->add(
            problems_->span_of(*node), "'" + std::string(key) + "' has " + std::to_string(list->size()) +
                                           " entries; expected at most " + std::to_string(kLongestList));
        return out;
    }
    for (const toml::node& entry : *list) {
        if (!entry.is_table()) {
            problems_->add(
                problems_->span_of(entry),
                "an entry of '" + std::string(key) + "' is " + kind_of(entry) + "; expected a table");
            continue;
        }
        out.emplace_back(*entry.as_table(), std::string(key), *problems_);
    }
    return out;
}

std::optional<std::size_t> Fields::word(std::string_view key, const std::vector<std::string>& words) {
    const auto value = text(key);
    if (!value) { return std::nullopt; }
    const auto found = std::ranges::find(words, value->value);
    if (found == words.end()) {
        problems_->add(
            value->span,
            "unknown " + std::string(key) + " '" + value->value + "'; expected one of " + comma_list(words),
            did_you_mean(value->value, words));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - words.begin());
}

std::optional<Located<double>> Fields::angle(std::string_view key) {
    const std::string in_degrees = std::string(key) + "_deg";
    const std::string in_radians = std::string(key) + "_rad";
    if (!at_most_one({in_degrees, in_radians})) { return std::nullopt; }
    auto value = number(in_degrees);
    if (value) {
        value->value *= std::numbers::pi / 180.0;
        return value;
    }
    return number(in_radians);
}

void Fields::missing(std::string_view key, std::string_view expected) {
    SourceSpan where = span();
    problems_->add(where, what_ + " has no '" + std::string(key) + "'; expected " + std::string(expected));
}

bool Fields::at_most_one(const std::vector<std::string>& keys) {
    std::vector<std::string> present;
    for (const std::string& key : keys) {
        if (has(key)) { present.push_back(key); }
    }
    if (present.size() <= 1) { return true; }
    problems_->add(
        span(present[1]),
        "'" + present[1] + "' contradicts '" + present[0] + "'; expected only one of " + comma_list(keys));
    return false;
}

void Fields::finish() {
    const std::vector<std::string> names(known_.begin(), known_.end());
    for (const auto& [key, node] : *table_) {
        if (known_.contains(key.str())) { continue; }
        problems_->add(
            problems_->span_of(key),
            "unknown key '" + std::string(key.str()) + "' in " + what_ + "; expected one of " +
                comma_list(names),
            did_you_mean(key.str(), names));
    }
}

}  // namespace jw
