#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "lessons/files/catalogue.hpp"
#include "tests/hard/report.hpp"

namespace jw::test {

// one test a case, so that ctest runs them side by side
TEST_CASE("In every hard case the naive method fails and Jointwise keeps its numbers", "[app][hard]") {
    for (const hard::Case& c : hard::cases()) {
        DYNAMIC_SECTION(c.name) {
            const hard::Result result = c.run();
            INFO(hard::text_of(c, result));
            CHECK_FALSE(result.measurements.empty());
            for (const std::string& sentence : hard::broken_bounds(result)) {
                INFO(sentence);
                CHECK(false);
            }
            const auto is_bounded = [](const hard::Measurement& m) {
                return m.ours && (std::isfinite(m.ours->bounds.least) || std::isfinite(m.ours->bounds.most));
            };
            CHECK(std::ranges::any_of(result.measurements, is_bounded));
        }
    }
}

TEST_CASE(
    "Every hard case has a name of its own, a shipped lesson and a section on the page", "[app][hard]") {
    std::ifstream file(std::filesystem::path(JW_SOURCE_ROOT) / "docs" / "hard-cases.md");
    std::stringstream page;
    page << file.rdbuf();
    CHECK(page.str().starts_with(hard::markdown_head()));
    std::set<std::string_view> names;
    for (const hard::Case& c : hard::cases()) {
        INFO(c.name);
        CHECK(names.insert(c.name).second);
        CHECK(std::filesystem::is_regular_file(catalogue_folder() / c.lesson));
        CHECK(page.str().find("## " + std::string(c.title)) != std::string::npos);
    }
}

}  // namespace jw::test
