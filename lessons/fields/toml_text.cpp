#include <algorithm>
#include <array>
#include <cstdio>

#include "lessons/fields/fields.hpp"
#include "lessons/text/utf8.hpp"

namespace jw {

namespace {

// every dot of a key is a table within a table; the parser's own limit covers only brackets
constexpr int kDeepestKey = 32;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Reports the first byte that is not UTF-8 and replaces all of them.
bool check_utf8(std::string& source, Problems& problems) {
    std::string shown;
    SourceSpan here{1, 1, 1};
    bool good = true;
    for (std::size_t k = 0; k < source.size();) {
        const std::size_t length = character_length(std::string_view(source).substr(k));
        if (length == 0 && good) {
            std::array<char, 8> hex{};
            std::snprintf(hex.data(), hex.size(), "0x%02X", static_cast<unsigned char>(source[k]));
            problems.add(
                Code::character, here,
                "the byte " + std::string(hex.data()) + " is not UTF-8; expected a text file in UTF-8",
                "save the file with the encoding UTF-8");
            good = false;
        }
        here.column = source[k] == '\n' ? 1 : here.column + 1;
        here.line += source[k] == '\n' ? 1 : 0;
        if (length == 0) {
            shown += kReplacement;
        } else {
            shown.append(source, k, length);
        }
        k += std::max<std::size_t>(1, length);
    }
    if (!good) { source = std::move(shown); }
    return good;
}

/// Skips a comment or a string of any of the four kinds, which cannot contain a key. @return its end
std::size_t skip_text(std::string_view source, std::size_t k) {
    const char c = source[k];
    if (c == '#') { return std::min(source.find('\n', k), source.size()); }
    const bool triple = source.substr(k, 3) == std::string(3, c);
    const std::size_t step = triple ? 3 : 1;
    for (k += step; k < source.size(); ++k) {
        if (source[k] == '\\' && c == '"') {
            ++k;
        } else if (source.substr(k, step) == std::string(step, c)) {
            return k + step;
        } else if (source[k] == '\n' && !triple) {
            return k;
        }
    }
    return source.size();
}

/// Reports keys that are nested so deeply that they would exhaust the parser's stack.
bool check_depth(std::string_view source, Problems& problems) {
    int dots = 0;
    int line = 1;
    for (std::size_t k = 0; k < source.size();) {
        const char c = source[k];
        if (c == '#' || c == '"' || c == '\'') {
            const std::size_t end = skip_text(source, k);
            line += static_cast<int>(std::ranges::count(source.substr(k, end - k), '\n'));
            k = end;
            continue;
        }
        if (c == '.') { ++dots; }
        if (c == '\n') { ++line; }
        if (std::string_view("\n,=[]{}").find(c) != std::string_view::npos) { dots = 0; }
        if (dots > kDeepestKey) {
            problems.add(
                Code::too_much, {line, 1, 1},
                "a key has more than " + std::to_string(kDeepestKey) +
                    " dots; expected keys as in docs/writing-a-lesson.md");
            return false;
        }
        ++k;
    }
    return true;
}

/// The span, with a column at most one behind the last character of its line: the parser counts the end of
/// the file as one more character.
SourceSpan within(SourceSpan span, std::string_view source) {
    std::size_t from = 0;
    for (int line = 1; line < span.line; ++line) {
        from = std::min(source.find('\n', from), source.size() - 1) + 1;
    }
    const std::string_view text = source.substr(from, source.find('\n', from) - from);
    const auto behind = static_cast<int>(std::ranges::count_if(text, starts_character)) + 1;
    span.column = std::min(span.column, behind);
    return span;
}

void report_syntax(const toml::parse_error& error, std::string_view source, Problems& problems) {
    std::string description(error.description());
    const std::string_view prefix = "Error while parsing ";
    if (description.starts_with(prefix)) { description.erase(0, prefix.size()); }
    std::ranges::replace(description, '\n', ' ');
    std::string hint;
    if (description.find("cannot redefine") != std::string::npos) {
        hint = "a key may appear once; several bodies are several [[body]], in double brackets";
    } else if (description.find("could not") != std::string::npos) {
        hint = "texts need quotes, numbers have a decimal point and no comma, true and false are lower case";
    }
    problems.add(
        Code::no_toml, within(span_of(error.source()), source), "this is not TOML, in " + description, hint);
}

}  // namespace

std::optional<toml::table> parse_toml(std::string& source, Problems& problems) {
    if (source.starts_with(kByteOrderMark)) { source.erase(0, kByteOrderMark.size()); }
    if (source.find_first_not_of(" \t\r\n") == std::string::npos) {
        problems.add(
            Code::file_empty, {}, "the file is empty; expected a lesson that begins with format = 1");
        return std::nullopt;
    }
    if (!check_utf8(source, problems) || !check_depth(source, problems)) { return std::nullopt; }
    try {
        return toml::parse(source);
    } catch (const toml::parse_error& error) {
        report_syntax(error, source, problems);
        return std::nullopt;
    }
}

}  // namespace jw
