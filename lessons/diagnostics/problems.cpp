#include "lessons/diagnostics/problems.hpp"

#include <algorithm>
#include <set>

namespace jw {

void Problems::add(
    Code code, const SourceSpan& span, std::string message, std::string hint, Severity severity) {
    if (severity == Severity::error) { ++errors_count_; }
    if (is_full()) { return; }
    list_.push_back({file_, span, code, std::move(message), std::move(hint), severity});
}

std::vector<Diagnostic> Problems::take() {
    std::ranges::stable_sort(list_, [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.span.line, a.span.column) < std::pair(b.span.line, b.span.column);
    });
    return std::move(list_);
}

std::string FileRead::report() const {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) { text += to_string(diagnostic, source); }
    return text;
}

void FileRead::blame(std::string file, Code code, std::string message) {
    diagnostics.push_back({std::move(file), {}, code, std::move(message), {}, Severity::error});
}

SourceSpan span_of(const toml::source_region& region) {
    SourceSpan span{static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 1};
    if (region.end.line == region.begin.line && region.end.column > region.begin.column) {
        span.length = static_cast<int>(region.end.column - region.begin.column);
    }
    return span;
}

namespace {

constexpr std::size_t kMostPlaces = 12;

Diagnostic warning_of(
    const std::string& file, const std::string& tag, const std::vector<const ReadText*>& missing,
    std::size_t all) {
    std::string places;
    for (std::size_t k = 0; k < std::min(missing.size(), kMostPlaces); ++k) {
        places += (k == 0 ? "" : ", ") + std::to_string(missing[k]->span.line);
    }
    if (missing.size() > kMostPlaces) { places += ", ..."; }
    const ReadText& first = *missing.front();
    return {
        file,
        first.span,
        Code::no_translation,
        std::to_string(missing.size()) + " of " + std::to_string(all) + " texts are not in " + tag +
            ": those of the lines " + places + "; they are shown in the language of the lesson",
        "beside " + in_quotes(first.key) + " here belongs " + in_quotes(tag + '.' + first.key),
        Severity::warning};
}

}  // namespace

std::vector<Diagnostic> missing_translations(const std::string& file, const std::vector<ReadText>& texts) {
    std::set<std::string> tags;
    for (const ReadText& read : texts) {
        for (const auto& [tag, text] : read.text.translations()) { tags.insert(tag); }
    }
    std::vector<Diagnostic> warnings;
    for (const std::string& tag : tags) {
        std::vector<const ReadText*> missing;
        std::size_t all = 0;
        for (const ReadText& read : texts) {
            const bool wanted = read.audience == Audience::students && !read.text.empty();
            all += wanted ? 1 : 0;
            if (wanted && !read.text.translations().contains(tag)) { missing.push_back(&read); }
        }
        std::ranges::stable_sort(missing, {}, [](const ReadText* read) { return read->span.line; });
        if (!missing.empty()) { warnings.push_back(warning_of(file, tag, missing, all)); }
    }
    return warnings;
}

}  // namespace jw
