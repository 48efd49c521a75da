#include "app/session/wording/typed_words.hpp"

#include <algorithm>
#include <cmath>

#include "core/numerics/decimal.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

// the limit of lesson files
constexpr double kLargest = 1e9;
// typed names from a lesson have at most this many words
constexpr std::size_t kWordsOfAName = 4;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string what_came(std::string_view word) { return word.empty() ? "the end" : in_quotes(word); }

}  // namespace

Words::Words(std::string_view text) {
    for (std::size_t k = 0; k < text.size();) {
        if (is_blank(text[k])) {
            ++k;
        } else if (text[k] == '"') {
            const std::size_t end = text.find('"', k + 1);
            if (end == std::string_view::npos) { throw Unreadable("a quote \" is not closed"); }
            words_.push_back({std::string(text.substr(k + 1, end - k - 1)), true});
            k = end + 1;
        } else {
            std::size_t end = k;
            while (end < text.size() && !is_blank(text[end]) && text[end] != '"') { ++end; }
            words_.push_back({std::string(text.substr(k, end - k)), false});
            k = end;
        }
    }
}

std::string_view Words::peek() const {
    return done() ? std::string_view() : std::string_view(words_[next_].text);
}

std::string Words::joined(std::size_t count) const {
    std::string text;
    for (std::size_t k = next_; k < std::min(next_ + count, words_.size()); ++k) {
        text += (k == next_ ? "" : " ") + words_[k].text;
    }
    return text;
}

std::string Words::rest() const { return joined(words_.size()); }

bool Words::take(std::string_view phrase) {
    const Words wanted(phrase);
    if (words_.size() - next_ < wanted.words_.size()) { return false; }
    for (std::size_t k = 0; k < wanted.words_.size(); ++k) {
        const Word& word = words_[next_ + k];
        if (word.quoted || word.text != wanted.words_[k].text) { return false; }
    }
    next_ += wanted.words_.size();
    return true;
}

std::string Words::guess(const std::vector<std::string>& names) const {
    std::string hint;
    for (std::size_t k = 1; k <= kWordsOfAName && hint.empty(); ++k) {
        hint = did_you_mean(joined(k), names);
    }
    return hint;
}

std::size_t Words::name(const std::vector<std::string>& names, const std::string& kind) {
    if (names.empty()) { throw Unreadable("the lesson has no " + kind); }
    std::size_t words_taken = 0;
    std::size_t found = names.size();
    for (std::size_t k = 0; k < names.size() && !done(); ++k) {
        if (words_[next_].quoted) {
            if (words_[next_].text != names[k]) { continue; }
            ++next_;
            return k;
        }
        const auto count = static_cast<std::size_t>(std::ranges::count(names[k], ' ')) + 1;
        if (count > words_taken && joined(count) == names[k]) {
            words_taken = count;
            found = k;
        }
    }
    if (found < names.size()) {
        next_ += words_taken;
        return found;
    }
    throw Unreadable(
        done() ? "the " + kind + " is missing; expected one of " + comma_list(names)
               : "no " + kind + " " + in_quotes(peek()) + "; expected one of " + comma_list(names),
        guess(names));
}

std::size_t Words::last_word(const std::vector<std::string>& words, const std::string& kind) {
    const std::string text = rest();
    const auto found = std::ranges::find(words, text);
    if (found == words.end()) {
        throw Unreadable(
            text.empty() ? "the " + kind + " is missing; expected one of " + comma_list(words)
                         : "no " + kind + " " + in_quotes(text) + "; expected one of " + comma_list(words),
            did_you_mean(text, words));
    }
    next_ = words_.size();
    return static_cast<std::size_t>(found - words.begin());
}

double Words::number(const std::string& what) {
    const std::string_view text = peek();
    double value = 0.0;
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = read_decimal(begin, text.data() + text.size(), value);
    if (text.empty() || error != std::errc()) {
        throw Unreadable(what_came(text) + " where " + what + " should be; expected a number");
    }
    if (!std::isfinite(value) || std::abs(value) > kLargest) {
        throw Unreadable(
            in_quotes(text) + " is too large or not a number; expected at most 1e9 in magnitude");
    }
    // a unit may follow without a blank: "30deg"
    Word& word = words_[next_];
    word.text.erase(0, static_cast<std::size_t>(end - text.data()));
    if (word.text.empty()) { ++next_; }
    return value;
}

std::string Words::text(const std::string& what) {
    if (done()) { throw Unreadable(what + " is missing; expected it in double quotes"); }
    return words_[next_++].text;
}

Vec3 Words::vector(const std::string& what) {
    Vec3 v;
    for (double& component : v) { component = number(what); }
    take("m");
    return v;
}

int Words::integer(const std::string& what) {
    const std::string text(peek());
    const double value = number(what);
    if (value != std::floor(value)) {
        throw Unreadable(in_quotes(text) + " is not a whole number; expected " + what);
    }
    return static_cast<int>(value);
}

void Words::finish() const {
    if (!done()) { throw Unreadable(in_quotes(rest()) + " is left over; nothing more was expected"); }
}

std::string quoted_name(const std::string& name, const std::vector<std::string>& names) {
    const bool has_blank = std::ranges::any_of(name, is_blank);
    const bool begins_another =
        std::ranges::any_of(names, [&](const std::string& other) { return other.starts_with(name + " "); });
    return has_blank || begins_another ? '"' + name + '"' : name;
}

}  // namespace jw
