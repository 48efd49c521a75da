#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "tests/soak/property.hpp"

/// Checks a property on many mechanisms, and shrinks the first one that fails.
namespace jw::test {

struct Asked {
    int count = 100;  ///< mechanisms that it must hold for
    std::uint64_t seed = 1;
    double shrink_seconds = 20.0;  ///< after which the smallest so far is taken [s]
    double seconds = 1e9;          ///< after which no other mechanism is checked [s]
};

struct Counterexample {
    Generated generated;
    std::string why;
    std::string recipe;
    int parts_before = 0;  ///< bodies, joints, drivers and loads, before it was made smaller
};

struct Answer {
    int held = 0;
    std::map<std::string, int> not_asked;  ///< by the reason
    std::optional<Counterexample> wrong;
};

Answer ask(const Property& property, const Asked& asked);

/// A counterexample that was written down: its recipe among other lines, one of which names the property.
struct WrittenDown {
    std::string property;
    Recipe recipe;
};
/// @throws std::runtime_error if the file says neither
WrittenDown read_counterexample(const std::filesystem::path& path);

/// Verdict on the mechanism of one recipe, as it is.
Verdict ask_of(const Property& property, const Recipe& recipe);

/// The counterexample as a lesson file. @return its text
std::string lesson_text_of(const Property& property, const Asked& asked, const Counterexample& wrong);

}  // namespace jw::test
