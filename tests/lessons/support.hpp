#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "lessons/read/reader.hpp"

/// Lessons for the tests of the reader.
namespace jw::test {

inline std::string text_of_file(const std::string& path) {
    std::ifstream stream(std::string(JW_SOURCE_ROOT) + "/" + path, std::ios::binary);
    REQUIRE(stream.good());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// The toml blocks of docs/writing-a-lesson.md: the complete lesson, shapes, functions of time, a
/// lesson of dynamics.
inline std::vector<std::string> documented_toml() {
    const std::string page = text_of_file("docs/writing-a-lesson.md");
    const std::string fence = "```toml\n";
    std::vector<std::string> blocks;
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
        at += fence.size();
        blocks.push_back(page.substr(at, page.find("```", at) - at));
    }
    REQUIRE(blocks.size() == 4);
    return blocks;
}

inline std::string documented_lesson() { return documented_toml()[0]; }

/// A few roundings of numbers of size 1 to 10.
inline constexpr double kRounding = 1e-14;

inline bool is_near(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff() < kRounding; }
inline bool is_near(const Vec4& a, const Vec4& b) { return (a - b).cwiseAbs().maxCoeff() < kRounding; }

/// Head and two bodies, `base` at the origin and `arm` turned and moved, then `rest`.
inline std::string with_two_bodies(const std::string& rest) {
    return R"(format = 1
title = "test"
[[body]]
name = "base"
[[body]]
name = "arm"
position = [1, 2, 3]
rotation = { axis = [0, 0, 1], angle_deg = 90 }
)" + rest;
}

/// Reads a lesson that must be right.
inline Lesson lesson_of(const std::string& text) {
    ReadResult result = read_lesson(text, "test.toml");
    INFO(result.report());
    REQUIRE(result.lesson.has_value());
    return std::move(*result.lesson);
}

}  // namespace jw::test
