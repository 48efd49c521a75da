#include "lessons/diagnostics.hpp"

#include <algorithm>
#include <numeric>

namespace jw {

namespace {

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

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

int characters_in(std::string_view text) {
    return static_cast<int>(std::ranges::count_if(text, starts_character));
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
            diagonal = above;
        }
    }
    return row.back();
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic, std::string_view source) {
    std::string text = diagnostic.file;
    if (diagnostic.span.line > 0) {
        text += ':' + std::to_string(diagnostic.span.line) + ':' + std::to_string(diagnostic.span.column);
    }
    text += ": error: " + diagnostic.message + '\n';
    const std::string_view line = line_of(source, diagnostic.span.line);
    if (diagnostic.span.line > 0 && !line.empty()) {
        // leading blanks are cut so that the line stands two columns in
        const std::size_t blank = std::min(line.find_first_not_of(" \t"), line.size());
        const int column = std::max(0, diagnostic.span.column - 1 - static_cast<int>(blank));
        const int room = std::max(1, characters_in(line) - diagnostic.span.column + 1);
        const int length = std::clamp(diagnostic.span.length, 1, room);
        text += "  " + std::string(line.substr(blank)) + '\n';
        text += "  " + std::string(static_cast<std::size_t>(column), ' ') + '^';
        text += std::string(static_cast<std::size_t>(length - 1), '~') + '\n';
    }
    if (!diagnostic.hint.empty()) { text += "  hint: " + diagnostic.hint + '\n'; }
    return text;
}

std::string did_you_mean(std::string_view text, std::span<const std::string> names) {
    const std::string* best = nullptr;
    std::size_t nearest = std::max<std::size_t>(2, text.size() / 3) + 1;
    for (const std::string& name : names) {
        const std::size_t distance = edit_distance(text, name);
        if (distance < nearest) {
            nearest = distance;
            best = &name;
        }
    }
    return best != nullptr ? "did you mean '" + *best + "'?" : std::string();
}

std::string comma_list(std::span<const std::string> names) {
    std::string text;
    for (const std::string& name : names) { text += (text.empty() ? "" : ", ") + name; }
    return text;
}

}  // namespace jw
