#include "tests/fuzz/diagnostics.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

namespace {

/// Characters (code points) of each line; behind the last line end there is another, empty line.
std::vector<int> lengths_of_lines(const std::string& source) {
    std::vector<int> lengths(1, 0);
    for (const char c : source) {
        if (c == '\n') {
            lengths.push_back(0);
        } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
            ++lengths.back();
        }
    }
    return lengths;
}

/// Promises a place in a line or just behind it, where something is missing.
void promise_place(const SourceSpan& span, const std::vector<int>& lengths, const std::string& message) {
    if (span.line == 0) { return; }
    const std::string place = " at " + std::to_string(span.line) + ":" + std::to_string(span.column) + " + " +
                              std::to_string(span.length) + ": " + message;
    promise(span.line > 0 && span.line <= static_cast<int>(lengths.size()), "no such line" + place);
    const int length = lengths[static_cast<std::size_t>(span.line - 1)];
    promise(span.column >= 1 && span.column <= length + 1, "no such column" + place);
    promise(span.length >= 1 && span.column + span.length <= length + 2, "too long" + place);
}

}  // namespace

void promise_places(const std::vector<Diagnostic>& diagnostics, const std::string& source) {
    const std::vector<int> lengths = lengths_of_lines(source);
    for (const Diagnostic& diagnostic : diagnostics) {
        promise_place(diagnostic.span, lengths, diagnostic.message);
        promise(!to_string(diagnostic, source).empty(), "a diagnostic without a text");
    }
}

bool has_error(const std::vector<Diagnostic>& diagnostics) {
    return std::ranges::any_of(
        diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
}

void promise_reported_places(const std::string& report, const std::string& source) {
    static const std::regex kPlace(R"(^answers\.toml:(\d{1,9}):(\d{1,9}): error: )");
    const std::vector<int> lengths = lengths_of_lines(source);
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        // the report quotes lines of the file; on a long one std::regex would recurse too deeply
        const std::string head = line.substr(0, 60);
        if (!std::regex_search(head, match, kPlace)) { continue; }
        promise_place({std::stoi(match[1]), std::stoi(match[2]), 1}, lengths, line);
    }
}

}  // namespace jw::fuzz
