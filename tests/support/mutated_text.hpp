#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Texts damaged by chance, the same for the same generator.
namespace jw::test {

/// `text` with one to four changes: bytes set, erased, repeated, or words of `words` put in or in place of
/// others.
/// @param words  at least one
inline std::string mutated(std::string text, std::mt19937& random, const std::vector<std::string>& words) {
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    // values and keys are exchanged whole, so that many mutants survive the TOML parser
    const auto word_at = [&](std::size_t k) {
        const std::size_t begin = text.find_last_of(" \n", k);
        const std::size_t end = text.find_first_of(" \n,]", k);
        const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
        return std::pair(first, std::min(end, text.size()) - first);
    };
    const std::size_t changes = 1 + below(4);
    for (std::size_t k = 0; k < changes && !text.empty(); ++k) {
        const std::size_t at = below(text.size());
        switch (below(6)) {
            case 0: text[at] = static_cast<char>(below(256)); break;
            case 1: text.erase(at, 1 + below(20)); break;
            case 2: text.insert(at, words[below(words.size())]); break;
            case 3: text.insert(at, text.substr(below(text.size()), below(60))); break;
            default: {
                const auto [first, length] = word_at(at);
                text.replace(first, length, words[below(words.size())]);
            }
        }
    }
    return text;
}

}  // namespace jw::test
