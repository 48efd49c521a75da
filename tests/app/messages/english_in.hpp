#pragma once

#include <regex>
#include <string>

namespace jw::test {

/// The first three words of English that follow each other; empty if none do.
inline std::string english_in(const std::string& text) {
    static const std::regex words("[A-Za-z]{2,}[,;:]? [A-Za-z]{2,}[,;:]? [A-Za-z]{2,}");
    std::smatch found;
    return std::regex_search(text, found, words) ? found.str() : std::string();
}

}  // namespace jw::test
