#include "lessons/diagnostics/diagnostics.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <utility>

#include "lessons/text/utf8.hpp"

namespace jw {

namespace {

constexpr std::string_view kPrefix = "JW";

bool begins_with_prefix(std::string_view text) {
    return text.size() > kPrefix.size() && (text[0] == 'J' || text[0] == 'j') &&
           (text[1] == 'W' || text[1] == 'w');
}

// a longer name is not a typing mistake
constexpr std::size_t kLongestGuess = 60;
constexpr std::size_t kMostListed = 30;  // the joint types are 26
// one line of a terminal, with room for the margin
constexpr int kWidestLine = 110;
constexpr int kBeforeMark = 40;

std::string_view line_of(std::string_view source, int line) {
    for (int k = 1; k < line; ++k) {
        const std::size_t end = source.find('\n');
        if (end == std::string_view::npos) { return {}; }
        source.remove_prefix(end + 1);
    }
    std::string_view text = source.substr(0, source.find('\n'));
    if (text.ends_with('\r')) { text.remove_suffix(1); }
    return text;
}

int characters_in(std::string_view text) {
    return static_cast<int>(std::ranges::count_if(text, starts_character));
}

/// Characters first to first + count of a line.
std::string_view characters_of(std::string_view text, int first, int count) {
    const auto byte_of = [&](int character) {
        std::size_t byte = 0;
        for (; byte < text.size(); ++byte) {
            if (starts_character(text[byte]) && character-- == 0) { break; }
        }
        return byte;
    };
    const std::size_t begin = byte_of(first);
    return text.substr(begin, byte_of(first + count) - begin);
}

std::string underlined(std::string_view line, const SourceSpan& span) {
    // leading blanks are cut, so that the line is indented by two columns
    int first = static_cast<int>(std::min(line.find_first_not_of(" \t"), line.size()));
    const int mark = std::max(first, span.column - 1);
    const int end = characters_in(line);
    std::string before;
    std::string after;
    if (end - first > kWidestLine) {
        if (mark - first > kBeforeMark) {
            first = mark - kBeforeMark;
            before = "...";
        }
        if (end - first > kWidestLine) { after = "..."; }
    }
    const int shown = std::min(end - first, kWidestLine);
    const int length = std::clamp(span.length, 1, std::max(1, first + shown - mark));
    const std::size_t column = before.size() + static_cast<std::size_t>(mark - first);
    return "  " + before + printable(characters_of(line, first, shown)) + after + "\n  " +
           std::string(column, ' ') + '^' + std::string(static_cast<std::size_t>(length - 1), '~') + '\n';
}

/// Number of letters to change, insert, leave out or swap with the next one.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last;
    std::vector<std::size_t> last;
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last = std::exchange(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) { row[j] = std::min(row[j], before_last[j - 2] + 1); }
        }
    }
    return row.back();
}

}  // namespace

std::vector<Code> all_codes() {
    std::vector<Code> codes;
    for (const CodeGroup& group : kCodeGroups) {
        for (int number = static_cast<int>(group.first); number <= static_cast<int>(group.last); ++number) {
            codes.push_back(static_cast<Code>(number));
        }
    }
    return codes;
}

std::string to_string(Code code) { return std::string(kPrefix) + std::to_string(static_cast<int>(code)); }

std::optional<Code> read_code(std::string_view text) {
    if (begins_with_prefix(text)) { text.remove_prefix(kPrefix.size()); }
    for (const Code code : all_codes()) {
        if (to_string(code).substr(kPrefix.size()) == text) { return code; }
    }
    return std::nullopt;
}

std::string to_string(const Diagnostic& diagnostic, std::string_view source) {
    std::string text = diagnostic.file;
    if (diagnostic.span.line > 0) {
        text += ':' + std::to_string(diagnostic.span.line) + ':' + std::to_string(diagnostic.span.column);
    }
    text += diagnostic.severity == Severity::error ? ": error: " : ": warning: ";
    text += diagnostic.message + " [" + to_string(diagnostic.code) + "]\n";
    const std::string_view line = line_of(source, diagnostic.span.line);
    if (diagnostic.span.line > 0 && !line.empty()) { text += underlined(line, diagnostic.span); }
    if (!diagnostic.hint.empty()) { text += "  hint: " + diagnostic.hint + '\n'; }
    return text;
}

std::string did_you_mean(std::string_view text, std::span<const std::string> names) {
    if (text.size() > kLongestGuess) { return {}; }
    const std::string* best = nullptr;
    // a third of the letters may be wrong, but never all of them
    std::size_t nearest = std::max<std::size_t>(1, text.size() / 3) + 1;
    for (const std::string& name : names) {
        if (name.size() > kLongestGuess) { continue; }
        const std::size_t distance = edit_distance(text, name);
        if (distance < nearest && distance < name.size()) {
            nearest = distance;
            best = &name;
        }
    }
    return best != nullptr ? "did you mean " + in_quotes(*best) + "?" : std::string();
}

std::string comma_list(std::span<const std::string> names) {
    std::string text;
    for (const std::string& name : names.first(std::min(names.size(), kMostListed))) {
        text += (text.empty() ? "" : ", ") + name;
    }
    if (names.size() > kMostListed) { text += ", ... (" + std::to_string(names.size()) + " in all)"; }
    return text;
}

std::string in_quotes(std::string_view text) {
    const bool cut = characters_in(text) > static_cast<int>(kLongestGuess);
    const std::string_view shown = cut ? characters_of(text, 0, static_cast<int>(kLongestGuess)) : text;
    return "'" + printable(shown) + (cut ? "..." : "") + "'";
}

std::string short_number(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

}  // namespace jw
