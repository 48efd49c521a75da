#include <array>
#include <regex>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include "tests/architecture/project_tree.hpp"

namespace jw::architecture {
namespace {

/// Folders whose numbers are the same on every machine.
constexpr std::array<std::string_view, 5> kSameEverywhere{
    "core/", "lessons/", "app/session/", "app/exercises/", "app/export/"};

bool is_same_everywhere(const SourceFile& file) {
    return is_cpp(file) &&
           std::ranges::any_of(kSameEverywhere, [&](auto folder) { return file.path.starts_with(folder); });
}

const std::string kFunctions =
    "(a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|expm1|log|log2|log10|log1p|pow|hypot|cbrt|erfc?|[lt]gamma|fma|"
    "lerp)f?";

/// Calls of these functions in a library: qualified or not. Where functions of jets are defined, unqualified
/// calls are calls of those.
const std::regex of_a_library("((^|[^\\w:.>])|std::|[^\\w]::|Eigen::numext::)" + kFunctions + "\\(");
const std::regex of_a_library_by_name("(std::|[^\\w]::)" + kFunctions + "\\(");
/// Distributions of random numbers differ between libraries, the digits of long double between machines, and
/// AngleAxis of Eigen calls sines of the library.
const std::regex of_a_machine("std::\\w+_distribution\\b|\\blong double\\b|\\bAngleAxis");

/// The line without comments and without the contents of string literals.
std::string code_of(const std::string& line) {
    static const std::regex quoted(R"re("([^"\\]|\\.)*")re");
    const std::string code = std::regex_replace(line, quoted, "\"\"");
    return code.substr(0, code.find("//"));
}

}  // namespace

TEST_CASE("Numbers come from functions that are the same on every machine", "[architecture]") {
    int lines_count = 0;
    for (const SourceFile& file : project_files()) {
        if (!is_same_everywhere(file) || file.path.starts_with("core/elementary/")) { continue; }
        const bool has_jets = file.path.starts_with("core/jets/");
        for (const std::string& line : file.lines) {
            const std::string code = code_of(line);
            ++lines_count;
            CAPTURE(file.path, line);
            CHECK_FALSE(std::regex_search(code, has_jets ? of_a_library_by_name : of_a_library));
            CHECK_FALSE(std::regex_search(code, of_a_machine));
        }
    }
    CHECK(lines_count > 10'000);  // folders that are not found would pass
}

TEST_CASE("Functions of a library are told from those that are the same everywhere", "[architecture]") {
    const auto is_objected_to = [](const std::string& line) {
        const std::string code = code_of(line);
        return std::regex_search(code, of_a_library) || std::regex_search(code, of_a_machine);
    };
    CHECK(is_objected_to("return std::sin(x);"));
    CHECK(is_objected_to("return -cos(x);"));
    CHECK(is_objected_to("return ::atan2f(y, x);"));
    CHECK(is_objected_to("y = std::pow(x, 2) + 1;"));
    CHECK(is_objected_to("std::normal_distribution<double> any;"));
    CHECK(is_objected_to("turned = Eigen::AngleAxisd(angle, up) * view;"));
    CHECK_FALSE(is_objected_to("return elementary::sin(x);"));
    CHECK_FALSE(is_objected_to("return std::sqrt(x) + std::remainder(y, 2.0);  // cos(x)"));
    CHECK_FALSE(is_objected_to("fail(node, \"expected atan2(y, x)\");"));
    CHECK_FALSE(is_objected_to("log_.exp(x); catalog(x);"));
}

}  // namespace jw::architecture
