#include "lessons/lesson/translations.hpp"

#include <algorithm>
#include <set>

namespace jw {

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
