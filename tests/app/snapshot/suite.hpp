#pragma once

#include <catch2/catch.hpp>

#include "tests/app/program.hpp"

namespace jw::test {

inline constexpr const char* kSmall = "960x540";

/// A folder with a lesson and its golden snapshots.
class Suite {
public:
    explicit Suite(const std::string& text = kCrank, const std::vector<std::string>& more = {})
        : text_(text) {
        write(text);
        std::vector<std::string> arguments{"record", lesson_, "--golden", golden(), "--size", kSmall};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = snapshot(arguments);
        INFO(ran.err);
        REQUIRE(ran.status == 0);
    }

    static Ran snapshot(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "snapshot");
        return run(arguments);
    }
    Ran compare(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"compare", lesson_, "--golden", golden()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return snapshot(arguments);
    }
    Ran bless(const std::string& reason, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"bless", lesson_, "--golden", golden(), "--reason", reason};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return snapshot(arguments);
    }
    void change(const std::string& from, const std::string& to) {
        const std::size_t at = text_.find(from);
        REQUIRE(at != std::string::npos);
        write(text_.replace(at, from.size(), to));
    }
    void change_golden(const std::string& file, const std::string& from, const std::string& to) const {
        std::string text = bytes_of(golden(file));
        const std::size_t at = text.find(from);
        REQUIRE(at != std::string::npos);
        write_golden(file, text.replace(at, from.size(), to));
    }
    void write_golden(const std::string& file, const std::string& text) const {
        std::ofstream(golden(file), std::ios::binary) << text;
    }
    std::string golden(const std::string& file = {}) const {
        return folder_.path("golden") + (file.empty() ? "" : "/crank/" + file);
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    const std::string& lesson() const { return lesson_; }

private:
    void write(const std::string& text) { lesson_ = folder_.file("crank.toml", text); }

    Folder folder_;
    std::string text_;
    std::string lesson_;
};

inline bool says(const Ran& ran, const std::string& words) {
    return ran.out.find(words) != std::string::npos || ran.err.find(words) != std::string::npos;
}

/// A hinged plate that is fully visible.
inline constexpr const char* kPlate = R"(format = 1
title = "A plate"
[[body]]
name = "plate"
colour = "blue"
shape = [{ rod = { from = [0, 0, 0], to = [1, 0, 0], radius = 0.05 } }]
[[body]]
name = "stand"
colour = "vermilion"
fixed = true
shape = [{ sphere = { at = [0, 0.6, 0], radius = 0.1 } }]
[[joint]]
name = "pivot"
type = "revolute"
bodies = ["ground", "plate"]
at = [0, 0, 0]
axis = [0, 0, 1]
)";

/// A door: only a few pixels of its hinge are visible beside the post that it is in.
inline constexpr const char* kDoor = R"(format = 1
title = "A door"
[[body]]
name = "post"
fixed = true
colour = "steel"
shape = [{ box = { size = [0.1, 0.1, 2.0], at = [0, 0, 1.0] } }]
[[body]]
name = "leaf"
position = [0.45, 0, 1]
colour = "orange"
shape = [{ box = { size = [0.8, 0.04, 1.9] } }]
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["post", "leaf"]
at = [0, 0, 1]
axis = [0, 0, 1]
[[driver]]
name = "hand"
joint = "hinge"
quantity = "angle"
polynomial_deg = [10]
)";

}  // namespace jw::test
