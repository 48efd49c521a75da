#include "lessons/math/text_parts.hpp"

#include <utility>

#include "lessons/math/write_math.hpp"

namespace jw::math {

namespace {

/// End of the formula that starts at `from`: at its closing dollar signs, not at an escaped one.
std::size_t end_of_formula(std::string_view text, std::size_t from, std::string_view mark) {
    for (std::size_t at = from; at < text.size(); ++at) {
        if (text[at] == '\\') {
            ++at;
        } else if (text.substr(at).starts_with(mark)) {
            return at;
        }
    }
    return std::string_view::npos;
}

void add_words(TextParts& parts, std::string words) {
    if (words.empty()) { return; }
    parts.parts.push_back({TextPart::Kind::words, std::move(words), {}});
}

void add_formula(TextParts& parts, std::string_view source, std::size_t from, TextPart::Kind kind) {
    Reading reading = read_math(source);
    if (reading.problem) {
        reading.problem->at += from;
        parts.problems.push_back(std::move(*reading.problem));
    }
    parts.parts.push_back({kind, std::string(source), std::move(reading.row)});
}

/// End of the code that begins with the backtick at `from`, in its line.
std::size_t end_of_code(std::string_view text, std::size_t from) {
    const std::size_t end = text.find_first_of("`\n", from + 1);
    return end != std::string_view::npos && text[end] == '`' ? end : std::string_view::npos;
}

}  // namespace

TextParts text_parts(std::string_view text) {
    TextParts parts;
    std::string words;
    for (std::size_t at = 0; at < text.size();) {
        if (text.substr(at).starts_with("\\$")) {
            words += '$';
            at += 2;
            continue;
        }
        const std::size_t code = text[at] == '`' ? end_of_code(text, at) : std::string_view::npos;
        if (code != std::string_view::npos) {
            add_words(parts, std::exchange(words, {}));
            parts.parts.push_back(
                {TextPart::Kind::code, std::string(text.substr(at + 1, code - at - 1)), {}});
            at = code + 1;
            continue;
        }
        if (text[at] != '$') {
            words += text[at++];
            continue;
        }
        const bool display = text.substr(at).starts_with("$$");
        const std::string_view mark = display ? "$$" : "$";
        const std::size_t from = at + mark.size();
        const std::size_t end = end_of_formula(text, from, mark);
        if (end == std::string_view::npos) {
            parts.problems.push_back(
                {at, "a formula starts with '" + std::string(mark) + "' and does not end",
                 "write \\$ for a dollar sign"});
            words += text.substr(at);
            break;
        }
        add_words(parts, std::exchange(words, {}));
        add_formula(
            parts, text.substr(from, end - from), from,
            display ? TextPart::Kind::display : TextPart::Kind::formula);
        at = end + mark.size();
    }
    add_words(parts, std::move(words));
    return parts;
}

bool has_marks(std::string_view text) { return text.find_first_of("$`") != std::string_view::npos; }

std::string plain_words(std::string_view text) {
    if (!has_marks(text)) { return std::string(text); }
    std::string plain;
    for (const TextPart& part : text_parts(text).parts) {
        switch (part.kind) {
            case TextPart::Kind::words: plain += part.words; break;
            case TextPart::Kind::code: plain += '`' + part.words + '`'; break;
            case TextPart::Kind::formula:
            case TextPart::Kind::display: plain += write_plain(part.row); break;
        }
    }
    return plain;
}

}  // namespace jw::math
