#include "tests/fuzz/words.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace jw::fuzz {

namespace fs = std::filesystem;

namespace {

/// Word between the quotes of a line.
std::string word_in(const std::string& line) {
    const std::size_t first = line.find('"');
    const std::size_t last = line.rfind('"');
    if (first == last) { throw std::runtime_error("no word in quotes: " + line); }
    std::string word;
    for (std::size_t k = first + 1; k < last; ++k) {
        if (line[k] != '\\') {
            word += line[k];
        } else if (line.compare(k, 2, "\\x") == 0) {
            word += static_cast<char>(std::stoi(line.substr(k + 2, 2), nullptr, 16));
            k += 3;
        } else {
            word += line.at(++k);
        }
    }
    return word;
}

}  // namespace

std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) { throw std::runtime_error("cannot read " + file.string()); }
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> read_words(const fs::path& file) {
    std::istringstream lines(bytes_of(file));
    std::vector<std::string> words;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line[0] != '#') { words.push_back(word_in(line)); }
    }
    if (words.empty()) { throw std::runtime_error("no word in " + file.string()); }
    return words;
}

std::vector<Kept> kept_inputs(const fs::path& folder) {
    std::vector<Kept> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        all.push_back({entry.path().filename().string(), bytes_of(entry.path())});
    }
    std::ranges::sort(all, {}, &Kept::name);
    return all;
}

}  // namespace jw::fuzz
