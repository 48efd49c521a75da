#include <algorithm>
#include <map>
#include <regex>

#include <catch2/catch.hpp>

#include "core/model/joint_types.hpp"
#include "tests/architecture/project_tree.hpp"

namespace jw::architecture {
namespace {

/// Lines of the project in which `pattern` is found, as "path:line: text".
std::vector<std::string> lines_with(const std::regex& pattern) {
    std::vector<std::string> found;
    for (const SourceFile& file : project_files()) {
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            if (!std::regex_search(file.lines[i], pattern)) { continue; }
            found.push_back(file.path + ':' + std::to_string(i + 1) + ": " + file.lines[i]);
        }
    }
    return found;
}

// only where a path begins: "a/work" and "$root/build" are not matched
const std::regex machine_path(R"re((^|[^A-Za-z0-9_.)}/-])/(work|root|home)(/|["'`\s]|$))re");
// in two halves, because this line would be found otherwise
const std::regex unfinished(
    "\\b(TO"
    "DO|FIX"
    "ME|HA"
    "CK)\\b");

/// Names of joint types as "revolute|planar|..."; if `of_joints_only`, without words with other meanings.
std::string joint_names(bool of_joints_only) {
    std::string names;
    for (const JointType& type : kJointTypes) {
        // also a key of bodies, a quantity, an experiment, keys of joints, a line of wheels, primitives
        const bool means_more = type.name == "fixed" || type.name == "distance" || type.name == "screw" ||
                                type.name == "curve" || type.name == "formula" || type.name == "rack" ||
                                type.name.size() < 3;
        if (of_joints_only && means_more) { continue; }
        names += (names.empty() ? "" : "|") + std::string(type.name);
    }
    return names;
}

bool is_shipped(const SourceFile& file) {
    // programs in docs/ use the library
    const bool uses_it = file.path.starts_with("tests/") || file.path.starts_with("docs/");
    return is_cpp(file) && !uses_it && file.path != "core/model/joint_types.hpp";
}

}  // namespace

TEST_CASE("Nothing but its entry knows a joint type by name", "[architecture]") {
    const std::regex alone("\"(" + joint_names(true) + ")\"");
    const std::regex compared(
        "[!=]= *\"(" + joint_names(false) + ")\"|\"(" + joint_names(false) +
        ")\" *[!=]=|find_joint_type\\(\"");
    for (const SourceFile& file : project_files()) {
        if (!is_shipped(file)) { continue; }
        for (const std::string& line : file.lines) {
            CAPTURE(file.path, line);
            CHECK_FALSE(std::regex_search(line, alone));
            CHECK_FALSE(std::regex_search(line, compared));
        }
    }
    CHECK(std::regex_search(std::string("if (type.name == \"revolute\") {"), alone));
    CHECK(std::regex_search(std::string("if (type.name == \"p1\") {"), compared));
}

TEST_CASE("No room has more than 25 files", "[architecture]") {
    const std::regex in_rooms("(core|lessons|render|app/session|app/panels|app/host|app/commands)/.*");
    std::map<std::string, int> entries;
    for (const SourceFile& file : project_files()) {
        if (is_cpp(file) && std::regex_match(file.path, in_rooms)) {
            ++entries[file.path.substr(0, file.path.rfind('/'))];
        }
    }
    CHECK(entries.size() > 20);
    for (const auto& [room, count] : entries) {
        CAPTURE(room);
        CHECK(count <= 25);
    }
}

TEST_CASE("No source file is longer than 400 lines", "[architecture]") {
    for (const SourceFile& file : project_files()) {
        if (!is_cpp(file)) { continue; }
        CAPTURE(file.path);
        CHECK(file.lines.size() <= 400);
    }
}

TEST_CASE("No file names a folder of somebody's machine", "[architecture]") {
    CHECK(lines_with(machine_path) == std::vector<std::string>{});
    CHECK(std::regex_search(
        "open(\"/"
        "home/ada/x\")",
        machine_path));
    CHECK_FALSE(std::regex_search("see docs/work/x and \"$root/build\"", machine_path));
}

TEST_CASE("Nothing is left marked as unfinished", "[architecture]") {
    CHECK(lines_with(unfinished) == std::vector<std::string>{});
    CHECK(std::regex_search(
        "// TO"
        "DO later",
        unfinished));
}

TEST_CASE("No name of a test has a semicolon, where ctest would cut it in two", "[architecture]") {
    const std::regex named(
        R"re((TEST_CASE(_METHOD)?|TEST_CASE_SIG)\s*\(\s*((\w+\s*,\s*)?("([^"\\]|\\.)*"\s*)+))re");
    int tests = 0;
    for (const SourceFile& file : project_files()) {
        if (!file.path.starts_with("tests/") || !file.path.ends_with(".cpp")) { continue; }
        std::string text;
        for (const std::string& line : file.lines) { text += line + '\n'; }
        for (std::sregex_iterator it(text.begin(), text.end(), named), end; it != end; ++it) {
            ++tests;
            CAPTURE(file.path, (*it).str());
            CHECK((*it)[3].str().find(';') == std::string::npos);
        }
    }
    CHECK(tests > 500);  // an expression that finds nothing would pass
}

TEST_CASE("Every header is included once", "[architecture]") {
    for (const SourceFile& file : project_files()) {
        if (!file.path.ends_with(".hpp")) { continue; }
        CAPTURE(file.path);
        CHECK(std::ranges::count(file.lines, "#pragma once") == 1);
    }
}

}  // namespace jw::architecture
