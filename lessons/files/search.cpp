#include "lessons/files/search.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

namespace jw {

namespace {

constexpr std::string_view kLongDash = "\xE2\x80\x93";  // "4–6"

std::string lower(std::string_view text) {
    std::string out(text);
    for (std::size_t k = 0; k < out.size(); ++k) {
        const auto c = static_cast<unsigned char>(out[k]);
        const bool capital = c >= 'A' && c <= 'Z';
        // À to Þ in UTF-8, without ×
        const bool accented = k > 0 && static_cast<unsigned char>(out[k - 1]) == 0xC3U && c >= 0x80U &&
                              c <= 0x9EU && c != 0x97U;
        if (capital || accented) { out[k] = static_cast<char>(c + 0x20U); }
    }
    return out;
}

/// Reads a text from its front.
class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    bool done() const { return rest_.empty(); }
    void drop_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }
    bool take(std::string_view word) {
        if (!rest_.starts_with(word)) { return false; }
        rest_.remove_prefix(word.size());
        return true;
    }
    std::optional<int> number() {
        int value = 0;
        const auto [end, fault] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (fault != std::errc() || rest_.starts_with('-')) { return std::nullopt; }
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }
    std::string_view word() {
        const std::string_view taken = rest_.substr(0, rest_.find_first_of(" \t\r\n"));
        rest_.remove_prefix(taken.size());
        return taken;
    }
    std::string_view rest() const { return rest_; }
    void back_to(std::string_view rest) { rest_ = rest; }

private:
    std::string_view rest_;
};

/// Takes a range: "5", "4-6", "4 - 6"; at the end of the text typed so far also "4-".
std::optional<SlideRange> range_at(Scanner& text) {
    const auto first = text.number();
    if (!first) { return std::nullopt; }
    const std::string_view behind = text.rest();
    text.drop_blanks();
    if (text.take("-") || text.take(kLongDash)) {
        text.drop_blanks();
        if (const auto last = text.number()) {
            return SlideRange{std::min(*first, *last), std::max(*first, *last)};
        }
        if (text.done()) { return SlideRange{*first, *first}; }
    }
    text.back_to(behind);
    return SlideRange{*first, *first};
}

/// Takes "slide 5" or "slides 4-6, 8 and 10" off the front of `text`, which is in lower case; else nothing.
std::vector<SlideRange> slides_at(Scanner& text) {
    const std::string_view before = text.rest();
    std::vector<SlideRange> slides;
    if (!text.take("slides") && !text.take("slide")) { return slides; }
    text.drop_blanks();
    std::string_view end = before;
    while (const auto range = range_at(text)) {
        slides.push_back(*range);
        end = text.rest();
        text.drop_blanks();
        if (!text.take(",") && !text.take("and ") && !text.take("&")) { break; }
        text.drop_blanks();
    }
    text.back_to(end);
    return slides;
}

bool overlap(const SlideRange& a, const SlideRange& b) { return a.first <= b.last && b.first <= a.last; }

bool has_one_of(const std::vector<SlideRange>& slides, const std::vector<SlideRange>& wanted) {
    return std::ranges::any_of(wanted, [&](const SlideRange& want) {
        return std::ranges::any_of(slides, [&](const SlideRange& is) { return overlap(is, want); });
    });
}

void add(std::string& words, std::string_view text) {
    words += text;
    words += '\n';  // so that a word does not continue in the next text
}

/// Adds the text in every language: a search in any of them finds the lesson.
void add(std::string& words, const Text& text) {
    add(words, std::string_view(text.own()));
    for (const auto& [tag, translated] : text.translations()) { add(words, std::string_view(translated)); }
}

}  // namespace

std::vector<SlideRange> slides_in(std::string_view source) {
    const std::string text = lower(source);
    std::vector<SlideRange> slides;
    for (std::size_t at = text.find("slide"); at != std::string::npos; at = text.find("slide", at + 1)) {
        const bool in_a_word = at > 0 && text[at - 1] >= 'a' && text[at - 1] <= 'z';
        if (in_a_word) { continue; }
        Scanner scanner(std::string_view(text).substr(at));
        const std::vector<SlideRange> some = slides_at(scanner);
        slides.insert(slides.end(), some.begin(), some.end());
    }
    return slides;
}

Searchable searchable_of(const Lesson& lesson, const std::filesystem::path& file) {
    std::string words;
    for (const Text* text : {&lesson.title, &lesson.text}) { add(words, *text); }
    add(words, std::string_view(lesson.chapter));
    add(words, std::string_view(lesson.source));
    add(words, std::string_view(file.stem().string()));
    for (const Joint& joint : lesson.mechanism.joints) {
        add(words, std::string_view(joint.name));
        add(words, joint.type->name);
    }
    const StepTexts& steps = lesson.step_texts;
    add(words, steps.bodies);
    for (const Text& text : steps.joints) { add(words, text); }
    for (const Text& text : steps.drivers) { add(words, text); }
    add(words, steps.motion);
    for (const StepTexts::AtTime& at : steps.times) { add(words, at.text); }
    return {lower(words), slides_in(lesson.source)};
}

Searchable searchable_of(const std::filesystem::path& file) { return {lower(file.stem().string()), {}}; }

bool fits(const Searchable& lesson, std::string_view search) {
    const std::string wanted = lower(search);
    Scanner scanner(wanted);
    for (scanner.drop_blanks(); !scanner.done(); scanner.drop_blanks()) {
        const std::vector<SlideRange> slides = slides_at(scanner);
        const bool found = slides.empty() ? lesson.words.find(scanner.word()) != std::string::npos
                                          : has_one_of(lesson.slides, slides);
        if (!found) { return false; }
    }
    return true;
}

}  // namespace jw
