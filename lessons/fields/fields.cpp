#include "lessons/fields/fields.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lessons/diagnostics/text_place.hpp"
#include "lessons/format/key.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/typed/exact_text.hpp"
#include "lessons/typed/typed.hpp"

namespace jw {

namespace {

bool is_control(char c) {
    return (static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\t' && c != '\r') || c == '\x7f';
}

}  // namespace

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

const toml::node* Fields::find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
}

const Key* Fields::check_described(std::string_view key, std::initializer_list<KeyKind> kinds) const {
    if (described_ == nullptr) { return nullptr; }
    const Key* found = find_key(*described_, key);
    if (found == nullptr || (kinds.size() > 0 && std::ranges::find(kinds, found->kind) == kinds.end())) {
        throw std::logic_error(
            "key " + in_quotes(key) + " of table " + in_quotes(described_->name) +
            " is read as lessons/format does not describe it");
    }
    return found;
}

Fields Fields::below(const toml::table& table, std::string_view key) const {
    const Key* described = check_described(key);
    return {
        table, std::string(key), *problems_, described != nullptr ? &key_table(described->table) : nullptr};
}

SourceSpan Fields::span(std::string_view key) const {
    const toml::node* node = table_->get(key);
    return node != nullptr ? span_of(node->source()) : span();
}

SourceSpan Fields::place_in(std::string_view key, std::size_t at) const {
    return place_in_text(problems_->source(), span(key), at);
}

void Fields::wrong_type(std::string_view key, const toml::node& node, std::string_view expected) {
    report(
        Code::wrong_type, span_of(node.source()),
        in_quotes(key) + " is " + kind_of(node) + "; expected " + std::string(expected));
}

std::optional<double> Fields::number_in(const toml::node& node, const std::string& what) {
    const double value =
        node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
    if (!std::isfinite(value)) {
        report(
            Code::out_of_range, span_of(node.source()),
            what + " is " + short_number(value) + "; expected a finite number");
        return std::nullopt;
    }
    if (std::abs(value) > kLargestNumber) {
        report(
            Code::out_of_range, span_of(node.source()),
            what + " is " + short_number(value, writing::digits_apart(std::abs(value), kLargestNumber, 6)) +
                "; expected at most 1e9 in magnitude",
            "lengths are in m, masses in kg, times in s");
        return std::nullopt;
    }
    return value;
}

IfGiven<std::string> Fields::text(std::string_view key) {
    check_described(key, {KeyKind::text, KeyKind::word, KeyKind::formula});
    const toml::node* node = find(key);
    return node != nullptr ? text_in(*node, std::string(key)) : std::nullopt;
}

IfGiven<std::string> Fields::text_in(const toml::node& node, const std::string& what) {
    if (!node.is_string()) {
        wrong_type(what, node, "a text in quotes");
        return std::nullopt;
    }
    const SourceSpan where = span_of(node.source());
    std::string value = node.as_string()->get();
    if (value.size() > kLongestText) {
        report(
            Code::too_much, where,
            in_quotes(what) + " has " + std::to_string(value.size()) + " bytes; expected at most " +
                std::to_string(kLongestText));
        return std::nullopt;
    }
    if (std::ranges::any_of(value, is_control)) {
        report(
            Code::character, where,
            in_quotes(what) + " contains a control character; expected text that can be shown");
        return std::nullopt;
    }
    std::erase(value, '\r');
    return Located<std::string>{std::move(value), where};
}

IfGiven<std::string> Fields::formula(std::string_view key) {
    check_described(key, {KeyKind::formula});
    auto source = text(key);
    if (!source) { return source; }
    if (auto problem = math::read_math(source->value).problem) {
        report(
            Code::unreadable_formula, place_in(key, problem->at), std::move(problem->message),
            std::move(problem->hint));
        return std::nullopt;
    }
    return source;
}

IfGiven<double> Fields::number(std::string_view key) {
    check_described(key, {KeyKind::number, KeyKind::positive, KeyKind::not_negative});
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_number()) {
        wrong_type(key, *node, "a number");
        return std::nullopt;
    }
    const auto value = number_in(*node, in_quotes(key));
    if (!value) { return std::nullopt; }
    return Located<double>{*value, span_of(node->source())};
}

IfGiven<double> Fields::number_that(
    std::string_view key, KeyKind kind, bool (*fits)(double), const char* expected) {
    check_described(key, {kind});
    auto value = number(key);
    if (!value || fits(value->value)) { return value; }
    report(
        Code::out_of_range, value->span,
        in_quotes(key) + " is " + short_number(value->value) + "; expected a number " + expected);
    return std::nullopt;
}

IfGiven<double> Fields::positive(std::string_view key) {
    return number_that(
        key, KeyKind::positive, [](double x) { return x > 0.0; }, "above 0");
}

IfGiven<double> Fields::not_negative(std::string_view key) {
    return number_that(
        key, KeyKind::not_negative, [](double x) { return x >= 0.0; }, "that is not negative");
}

IfGiven<int> Fields::integer(std::string_view key, int least, int most) {
    check_described(key, {KeyKind::whole_number});
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_integer()) {
        if (const auto* fraction = node->as_floating_point()) {
            report(
                Code::wrong_type, span_of(node->source()),
                in_quotes(key) + " is " + short_number(fraction->get()) + "; expected a whole number");
            return std::nullopt;
        }
        wrong_type(key, *node, "a whole number");
        return std::nullopt;
    }
    const auto value = node->as_integer()->get();
    if (value < least || value > most) {
        report(
            Code::out_of_range, span_of(node->source()),
            in_quotes(key) + " is " + std::to_string(value) + "; expected " + std::to_string(least) + " to " +
                std::to_string(most));
        return std::nullopt;
    }
    return Located<int>{static_cast<int>(value), span_of(node->source())};
}

IfGiven<int> Fields::integer(std::string_view key) {
    const Key& described = *check_described(key);
    return integer(key, described.least, described.most);
}

IfGiven<bool> Fields::flag(std::string_view key) {
    check_described(key, {KeyKind::flag});
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_boolean()) {
        wrong_type(key, *node, "true or false");
        return std::nullopt;
    }
    return Located<bool>{node->as_boolean()->get(), span_of(node->source())};
}

std::optional<Fields> Fields::table(std::string_view key) {
    check_described(key, {KeyKind::table});
    const toml::node* node = find(key);
    if (node == nullptr) { return std::nullopt; }
    if (!node->is_table()) {
        wrong_type(key, *node, "one table");
        return std::nullopt;
    }
    return below(*node->as_table(), key);
}

std::vector<Fields> Fields::tables(std::string_view key, std::size_t most) {
    check_described(key, {KeyKind::tables});
    const toml::node* node = find(key);
    if (node == nullptr) { return {}; }
    if (node->is_table()) { return {below(*node->as_table(), key)}; }
    const toml::array* list = node->as_array();
    if (list == nullptr) {
        wrong_type(key, *node, "one or several tables");
        return {};
    }
    std::vector<Fields> out;
    if (list->size() > most) {
        report(
            Code::too_much, span_of(node->source()),
            "there are " + std::to_string(list->size()) + " times " + in_quotes(key) + "; expected at most " +
                std::to_string(most));
        return out;
    }
    for (const toml::node& entry : *list) {
        if (!entry.is_table()) {
            report(
                Code::wrong_type, span_of(entry.source()),
                "an entry of " + in_quotes(key) + " is " + kind_of(entry) + "; expected a table");
            continue;
        }
        out.push_back(below(*entry.as_table(), key));
    }
    return out;
}

std::optional<std::size_t> Fields::word(std::string_view key, const std::vector<std::string>& words) {
    check_described(key, {KeyKind::word, KeyKind::text});
    const auto value = text(key);
    if (!value) { return std::nullopt; }
    const auto found = std::ranges::find(words, value->value);
    if (found == words.end()) {
        report(
            Code::unknown_word, value->span,
            "unknown " + std::string(key) + ' ' + in_quotes(value->value) + "; expected one of " +
                comma_list(words),
            did_you_mean(value->value, words));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - words.begin());
}

std::optional<std::size_t> Fields::word(std::string_view key) {
    return word(key, check_described(key)->words());
}

IfGiven<double> Fields::angle(std::string_view key) {
    const std::string in_degrees = std::string(key) + "_deg";
    const std::string in_radians = std::string(key) + "_rad";
    if (!at_most_one({in_degrees, in_radians})) { return std::nullopt; }
    if (!has(in_degrees)) { return number(in_radians); }
    auto value = number(in_degrees);
    if (value) { value->value = radians(value->value); }
    return value;
}

const toml::key* Fields::meant_as(std::string_view key) const {
    const std::vector<std::string> wanted{std::string(key)};
    const std::string_view bare = key.substr(0, key.find("_deg"));
    for (const auto& [other, node] : *table_) {
        const std::string_view word = other.str();
        const bool other_unit = (key.starts_with(word) && word.size() >= bare.size()) ||
                                word == wanted[0] + "_deg" || word == wanted[0] + "_rad";
        const bool is_meant =
            other_unit || !key_meant_by(word, wanted).empty() || !did_you_mean(word, wanted).empty();
        if (is_meant && !known_.contains(word) && !told_.contains(word)) { return &other; }
    }
    return nullptr;
}

bool Fields::has_instead_of(std::string_view expected) const {
    std::vector<std::string> names;
    if (described_ == nullptr) { return false; }
    for (const SpelledKey& spelled : spelled_keys(*described_)) { names.push_back(spelled.name); }
    return std::ranges::any_of(*table_, [&](const auto& entry) {
        const std::string_view word = entry.first.str();
        const std::string meant = known_.contains(word) ? "" : key_meant_by(word, names);
        return !meant.empty() && expected.find(in_quotes(meant)) != std::string_view::npos;
    });
}

void Fields::missing(std::string_view key, std::string_view expected) {
    // a misspelt key is one mistake, not a missing and an unknown one
    if (const toml::key* other = meant_as(key)) {
        std::string in_radians(key);
        const std::size_t unit = in_radians.find("_deg");
        if (unit != std::string::npos) { in_radians.replace(unit, 4, "_rad"); }
        report(
            Code::unknown_key, span_of(other->source()),
            "unknown key " + in_quotes(other->str()) + " in " + what_ + "; expected " + in_quotes(key) +
                (in_radians != key && in_radians != other->str() ? " or " + in_quotes(in_radians) : ""),
            "did you mean " + in_quotes(key) + "?");
        told_.emplace(other->str());
        return;
    }
    if (has_instead_of(expected)) { return; }
    report(
        Code::missing_key, span(),
        what_ + " has no " + in_quotes(key) + "; expected " + std::string(expected));
}

void Fields::require(std::string_view key, std::string_view expected) {
    if (!has(key)) { missing(key, expected); }
}

void Fields::require(std::string_view key) { require(key, check_described(key)->expected); }

bool Fields::at_most_one(const std::vector<std::string>& keys) {
    std::vector<std::string> present;
    for (const std::string& key : keys) {
        if (has(key)) { present.push_back(key); }
    }
    if (present.size() <= 1) { return true; }
    report(
        Code::exclusive_keys, span(present[1]),
        in_quotes(present[1]) + " beside " + in_quotes(present[0]) + "; expected only one of " +
            comma_list(keys));
    return false;
}

void Fields::finish() {
    const std::vector<std::string> names(known_.begin(), known_.end());
    if (!words_.empty()) {
        for (const auto& [tag, table] : languages()) { finish_language(tag, *table); }
    }
    for (const auto& [key, node] : *table_) {
        if (known_.contains(key.str()) || told_.contains(key.str())) { continue; }
        if (problems_->is_full()) { return; }
        if (is_misnamed_language(key, node)) { continue; }
        const std::string meant = key_meant_by(key.str(), names);
        report(
            Code::unknown_key, span_of(key.source()),
            "unknown key " + in_quotes(key.str()) + " in " + what_ + "; expected one of " + comma_list(names),
            meant.empty() ? did_you_mean(key.str(), names) : "did you mean " + in_quotes(meant) + "?");
    }
}

}  // namespace jw
