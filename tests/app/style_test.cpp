#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "lessons/files/catalogue.hpp"
#include "tests/app/program.hpp"

namespace jw::test {

namespace {

/// Words that docs/style.md says are not used, from the last column of its terms.
std::vector<std::string> unused_words() {
    const std::string page = bytes_of(source_path("docs/style.md"));
    std::istringstream lines(page.substr(page.find("| idea | term | not |")));
    std::vector<std::string> words;
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    while (std::getline(lines, line) && line.starts_with("| ")) {
        const std::size_t begin = line.rfind(" | ", line.size() - 3) + 3;
        std::istringstream cell(line.substr(begin, line.size() - 2 - begin));
        for (std::string word; std::getline(cell, word, ',');) {
            words.push_back(word.substr(word.find_first_not_of(' ')));
        }
    }
    return words;
}

bool has_word(const std::string& text, const std::string& word) {
    return std::regex_search(text, std::regex("\\b" + word + "\\b", std::regex::icase));
}

/// Checks a text, and says where it came from.
void check(const std::string& from, const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        INFO(from << ": '" << word << "'; docs/style.md has the term");
        CHECK_FALSE(has_word(text, word));
    }
}

}  // namespace

TEST_CASE("Pages, lessons, exercises, help and sentences use the terms of docs/style.md", "[app][style]") {
    const std::vector<std::string> words = unused_words();
    REQUIRE(words.size() >= 10);
    const auto check_files = [&](const std::filesystem::path& folder, const std::string& ending) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            const std::string path = entry.path().string();
            if (path.ends_with(ending) && !path.ends_with("docs/style.md")) {
                check(path, bytes_of(path), words);
            }
        }
    };
    check_files(source_path("docs"), ".md");
    check_files(catalogue_folder(), ".toml");
    check_files(source_path("lessons/exercises"), ".toml");
    for (const char* page : {"README.md", "CONTRIBUTING.md", "app/languages/zh-Hant.po"}) {
        check(page, bytes_of(source_path(page)), words);
    }
    check("manual", run({"manual"}).out, words);
}

}  // namespace jw::test
