#include <algorithm>
#include <array>

#include "lessons/diagnostics/text_place.hpp"
#include "lessons/fields/fields.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/text/text.hpp"

/// Access to keys that hold words for people, and to the same words in other languages.
namespace jw {

namespace {

// keys of lessons that have the form of a language tag and may be tables
constexpr std::array<std::string_view, 3> kNoLanguages{"try", "rod", "box"};

std::string in_language_of(const std::string& tag, std::string_view key) {
    return tag + '.' + std::string(key);
}

}  // namespace

std::vector<std::pair<std::string, const toml::table*>> Fields::languages() const {
    std::vector<std::pair<std::string, const toml::table*>> found;
    for (const auto& [key, node] : *table_) {
        const bool reserved = std::ranges::find(kNoLanguages, key.str()) != kNoLanguages.end();
        if (!reserved && node.is_table() && is_language_tag(key.str())) {
            found.emplace_back(key.str(), node.as_table());
        }
    }
    return found;
}

IfGiven<Text> Fields::words(std::string_view key, Audience audience) {
    check_described(key, {KeyKind::words});
    return words_in(key, true, audience);
}

IfGiven<Text> Fields::plain_words(std::string_view key) {
    check_described(key, {KeyKind::plain_words});
    return words_in(key, false, Audience::students);
}

IfGiven<Text> Fields::words_in(std::string_view key, bool has_formulas, Audience audience) {
    words_.emplace(key);
    const toml::node* node = find(key);
    const auto own = node != nullptr ? text_in(*node, std::string(key)) : std::nullopt;
    if (!own) { return std::nullopt; }
    if (has_formulas) { check_formulas(*own); }
    Text text = own->value;
    for (const auto& [tag, table] : languages()) {
        const toml::node* const other = table->get(key);
        const auto translated = other != nullptr ? text_in(*other, in_language_of(tag, key)) : std::nullopt;
        if (!translated) { continue; }
        if (has_formulas) { check_formulas(*translated); }
        text.translate(tag, translated->value);
    }
    record(key, own->span, text, audience);
    return Located<Text>{std::move(text), own->span};
}

IfGiven<std::vector<Text>> Fields::list_of_words(std::string_view key) {
    check_described(key, {KeyKind::list_of_words});
    words_.emplace(key);
    const toml::node* node = find(key);
    const auto own = node != nullptr ? texts_in(*node, std::string(key), "a list of texts") : std::nullopt;
    if (!own) { return std::nullopt; }
    Located<std::vector<Text>> list{{}, own->span};
    for (const Located<std::string>& entry : own->value) {
        check_formulas(entry);
        list.value.emplace_back(entry.value);
    }
    for (const auto& [tag, table] : languages()) {
        const toml::node* const other = table->get(key);
        const std::string what = in_language_of(tag, key);
        const auto translated = other != nullptr ? texts_in(*other, what, "a list of texts") : std::nullopt;
        if (!translated) { continue; }
        if (translated->value.size() != list.value.size()) {
            report(
                Code::wrong_count, translated->span,
                in_quotes(what) + " has " + std::to_string(translated->value.size()) + " entries; expected " +
                    std::to_string(list.value.size()) + ", as many as " + in_quotes(key));
            continue;
        }
        for (std::size_t k = 0; k < list.value.size(); ++k) {
            check_formulas(translated->value[k]);
            list.value[k].translate(tag, translated->value[k].value);
        }
    }
    for (std::size_t k = 0; k < list.value.size(); ++k) {
        record(key, own->value[k].span, list.value[k], Audience::students);
    }
    return list;
}

void Fields::check_formulas(const Located<std::string>& words) {
    for (math::Problem& problem : math::text_parts(words.value).problems) {
        const SourceSpan place = place_in_text(problems_->source(), words.span, problem.at);
        report(Code::unreadable_formula, place, std::move(problem.message), std::move(problem.hint));
    }
}

void Fields::record(std::string_view key, const SourceSpan& span, const Text& text, Audience audience) {
    problems_->texts().push_back({what_, std::string(key), span, text, audience});
}

void Fields::finish_language(const std::string& tag, const toml::table& table) {
    known_.emplace(tag);
    const std::vector<std::string> names(words_.begin(), words_.end());
    for (const auto& [key, node] : table) {
        if (problems_->is_full()) { return; }
        if (!words_.contains(key.str())) {
            report(
                Code::unknown_key, span_of(key.source()),
                "unknown key " + in_quotes(key.str()) + " in " + tag + " of " + what_ + "; expected one of " +
                    comma_list(names),
                did_you_mean(key.str(), names));
        } else if (find(key.str()) == nullptr) {
            report(
                Code::lonely_key, span_of(key.source()),
                in_quotes(in_language_of(tag, key.str())) + " without " + in_quotes(key.str()) +
                    "; expected the words in the language of the lesson too");
        }
    }
}

bool Fields::is_misnamed_language(const toml::key& key, const toml::node& node) {
    const toml::table* const table = node.as_table();
    const bool has_words =
        table != nullptr && !table->empty() &&
        std::ranges::all_of(*table, [&](auto&& entry) { return words_.contains(entry.first.str()); });
    if (!has_words) { return false; }
    const std::string meant = meant_language_tag(key.str());
    report(
        Code::language_tag, span_of(key.source()),
        in_quotes(key.str()) + " is not a language tag; expected one such as 'zh-Hant', 'de' or 'pt-BR'",
        meant.empty() ? "" : "did you mean " + in_quotes(meant) + "?");
    return true;
}

}  // namespace jw
