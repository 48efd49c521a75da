#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "lessons/files/catalogue.hpp"
#include "lessons/files/search.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/session/catalogue_lessons.hpp"
#include "tests/lessons/support.hpp"

namespace jw::test {

namespace {

namespace fs = std::filesystem;

constexpr int kSlides = 25;

struct Row {
    int slide = 0;
    std::vector<std::string> lessons;
    std::vector<std::pair<std::string, std::string>> code;  ///< name and file
    std::vector<std::string> tests;
};

std::vector<std::string> matches_of(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator k(text.begin(), text.end(), expression), end; k != end; ++k) {
        found.push_back((*k)[1]);
    }
    return found;
}

/// Cells of a line of the table; "\|" is no border.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    for (std::size_t k = 1; k < line.size(); ++k) {
        if (line[k] == '\\' && k + 1 < line.size() && line[k + 1] == '|') {
            cells.back() += '|';
            ++k;
        } else if (line[k] == '|') {
            cells.emplace_back();
        } else {
            cells.back() += line[k];
        }
    }
    return cells;
}

std::vector<Row> rows_of_map() {
    std::vector<Row> rows;
    std::istringstream page(text_of_file("docs/map.md"));
    for (std::string line; std::getline(page, line);) {
        if (!std::regex_search(line, std::regex("^\\| [0-9]"))) { continue; }
        const std::vector<std::string> cells = cells_of(line);
        Row row;
        row.slide = std::stoi(cells.at(0));
        row.lessons = matches_of(cells.at(2), "`([^`]+)`");
        const std::regex code("`([^`]+)` in `([^`]+)`");
        for (std::sregex_iterator k(cells.at(3).begin(), cells.at(3).end(), code), end; k != end; ++k) {
            row.code.emplace_back((*k)[1], (*k)[2]);
        }
        row.tests = matches_of(cells.at(4), "\"([^\"]+)\"");
        rows.push_back(row);
    }
    return rows;
}

bool names_slide(const std::string& source, int slide) {
    const std::vector<SlideRange> ranges = slides_in(source);
    return std::ranges::any_of(
        ranges, [slide](const SlideRange& r) { return r.first <= slide && slide <= r.last; });
}

std::string all_tests() {
    std::string all;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(JW_SOURCE_ROOT) / "tests")) {
        if (entry.path().extension() == ".cpp" && entry.path().filename() != "map_test.cpp") {
            all += text_of_file(fs::relative(entry.path(), JW_SOURCE_ROOT).string());
        }
    }
    return all;
}

}  // namespace

TEST_CASE("docs/map.md has a row for every slide", "[app][docs]") {
    const std::vector<Row> rows = rows_of_map();
    REQUIRE(rows.size() == kSlides);
    for (int k = 0; k < kSlides; ++k) {
        const Row& row = rows[static_cast<std::size_t>(k)];
        CHECK(row.slide == k + 1);
        // the first slide is the title
        CHECK((k == 0 || (!row.lessons.empty() && !row.code.empty() && !row.tests.empty())));
    }
}

TEST_CASE("lessons that docs/map.md names for a slide have it as their source", "[app][docs]") {
    for (const Row& row : rows_of_map()) {
        for (const std::string& name : row.lessons) {
            CAPTURE(row.slide, name);
            const Lesson lesson = lesson_named(name);
            CHECK(names_slide(lesson.source, row.slide));
        }
    }
}

TEST_CASE("code and tests that docs/map.md names are there", "[app][docs]") {
    const std::string tests = all_tests();
    for (const Row& row : rows_of_map()) {
        for (const auto& [name, file] : row.code) {
            CAPTURE(row.slide, name, file);
            const std::string text = text_of_file(file);
            CHECK(std::regex_search(text, std::regex("\\b" + name + "\\b")));
        }
        for (const std::string& test : row.tests) {
            CAPTURE(row.slide, test);
            CHECK(tests.find('"' + test + '"') != std::string::npos);
        }
    }
}

TEST_CASE(
    "a formula of every slide from 2 on is a claim of a lesson, and misprints are refuted", "[app][docs]") {
    std::set<int> proved;
    int misprints = 0;
    for (const fs::path& path : lessons_below(catalogue_folder())) {
        const ReadResult read = read_lesson_file(path);
        REQUIRE(read.lesson);
        for (const Claim& claim : read.lesson->claims) {
            const auto* const formula = std::get_if<FormulaClaim>(&claim.fact);
            if (formula == nullptr) { continue; }
            misprints += formula->holds ? 0 : 1;
            for (int slide = 2; slide <= kSlides; ++slide) {
                if (names_slide(read.lesson->source, slide)) { proved.insert(slide); }
            }
        }
    }
    CHECK(proved.size() == kSlides - 1);
    CHECK(misprints > 60);
}

}  // namespace jw::test
