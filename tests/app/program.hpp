#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands/program/program.hpp"
#include "tests/support/crank.hpp"
#include "tests/support/temporary_folder.hpp"

/// The program as a function, and lessons for it.
namespace jw::test {

struct Ran {
    int status = 0;
    std::string out;
    std::string err;
};

/// Runs `jointwise` in this process.
inline Ran run(const std::vector<std::string>& arguments) {
    std::ostringstream out;
    std::ostringstream err;
    const int status = run_program(arguments, Streams{out, err, false});
    return {status, out.str(), err.str()};
}

inline std::string source_path(const std::string& path) { return std::string(JW_SOURCE_ROOT) + "/" + path; }
inline std::string lesson_path(const std::string& name) { return source_path("lessons/catalogue/" + name); }

/// A temporary folder whose paths are arguments of the program.
class Folder {
public:
    std::string path(const std::string& name = {}) const {
        return name.empty() ? folder_.path().string() : (folder_.path() / name).string();
    }
    /// Writes a lesson and gives its path.
    std::string file(const std::string& name, const std::string& text) const {
        return folder_.write(name, text).string();
    }

private:
    TemporaryFolder folder_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// A rod of 1 m between two points that are 3 m apart.
inline constexpr const char* kTooShort = R"(format = 1
title = "Too short"
[[body]]
name = "arm"
position = [1, 0, 0]
[[joint]]
name = "pivot"
type = "spherical"
bodies = ["ground", "arm"]
at = [0, 0, 0]
[[joint]]
name = "rod"
type = "distance"
bodies = ["ground", "arm"]
at = [4, 0, 0]
to = [1, 0, 0]
length = 1
)";

}  // namespace jw::test
