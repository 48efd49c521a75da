#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <stdlib.h>

#include "app/commands/program.hpp"

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

/// A folder of its own, removed with everything in it.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "jointwise-test-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) { throw std::runtime_error("no temporary folder"); }
        path_ = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    std::string path(const std::string& name = {}) const {
        return name.empty() ? path_.string() : (path_ / name).string();
    }
    /// Writes a lesson and gives its path.
    std::string file(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path(name);
    }

private:
    std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// A crank on the ground, driven at 90 deg/s.
inline constexpr const char* kCrank = R"(format = 1
title = "A crank"
[[body]]
name = "crank"
[[joint]]
name = "pivot"
type = "revolute"
bodies = ["ground", "crank"]
at = [0, 0, 0]
axis = [0, 0, 1]
[[driver]]
name = "drive"
joint = "pivot"
quantity = "angle"
polynomial_deg = [0, 90]
[motion]
to_s = 1
steps = 4
)";

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
