#include "lessons/text/text.hpp"

#include <algorithm>
#include <vector>

namespace jw {

namespace {

void drop_line_feeds_of(std::string& text) {
    while (text.ends_with('\n')) { text.pop_back(); }
}

}  // namespace

void Text::show(std::string_view tag) {
    std::string own = this->own();
    own_.reset();
    for (; !tag.empty(); tag = tag.substr(0, tag.find('-') == std::string_view::npos ? 0 : tag.rfind('-'))) {
        const auto found = translations_.find(tag);
        if (found == translations_.end()) { continue; }
        std::string::operator=(found->second);
        own_ = std::move(own);
        return;
    }
    std::string::operator=(std::move(own));
}

void Text::drop_line_feeds() {
    drop_line_feeds_of(*this);
    if (own_) { drop_line_feeds_of(*own_); }
    for (auto& [tag, text] : translations_) { drop_line_feeds_of(text); }
}

bool same_in_all_languages(const Text& a, const Text& b) {
    return a.own() == b.own() && a.translations() == b.translations();
}

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::vector<std::string> parts_of(std::string_view text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == '-' || c == '_') {
            parts.emplace_back();
        } else {
            parts.back() += lower(c);
        }
    }
    return parts;
}

bool is_language(const std::string& p) {
    return (p.size() == 2 || p.size() == 3) && std::ranges::all_of(p, is_letter);
}
bool is_script(const std::string& p) { return p.size() == 4 && std::ranges::all_of(p, is_letter); }
bool is_region(const std::string& p) {
    return (p.size() == 2 && std::ranges::all_of(p, is_letter)) ||
           (p.size() == 3 && std::ranges::all_of(p, is_digit));
}
bool is_variant(const std::string& p) {
    const bool plain = std::ranges::all_of(p, [](char c) { return is_letter(c) || is_digit(c); });
    return plain && ((p.size() >= 5 && p.size() <= 8) || (p.size() == 4 && is_digit(p[0])));
}

}  // namespace

std::string meant_language_tag(std::string_view text) {
    std::vector<std::string> parts = parts_of(text);
    if (!is_language(parts[0])) { return {}; }
    std::size_t next = 1;
    if (next < parts.size() && is_script(parts[next])) {
        parts[next][0] = upper(parts[next][0]);
        ++next;
    }
    if (next < parts.size() && is_region(parts[next])) {
        std::ranges::transform(parts[next], parts[next].begin(), upper);
        ++next;
    }
    if (!std::all_of(parts.begin() + static_cast<std::ptrdiff_t>(next), parts.end(), is_variant)) {
        return {};
    }
    std::string tag;
    for (const std::string& part : parts) { tag += (tag.empty() ? "" : "-") + part; }
    return tag;
}

bool is_language_tag(std::string_view text) { return !text.empty() && meant_language_tag(text) == text; }

}  // namespace jw
