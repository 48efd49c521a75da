#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/snapshot/facts/facts.hpp"

namespace jw::snapshot {

/// A fact that has changed, or that exists only before or only after.
struct FactChange {
    Weight weight = Weight::detail;
    std::string name;
    std::string before;  ///< with unit; empty: it was not there
    std::string after;   ///< empty: it is not there any more

    bool operator==(const FactChange&) const = default;
};

/// "step 3 of 24"
struct StepNumber {
    int step = 1;  ///< from 1
    int steps = 1;

    bool operator==(const StepNumber&) const = default;
};

/// The number of the step as facts tell it; nothing if they do not.
std::optional<StepNumber> step_number_of(const std::vector<Fact>& facts);

/// A golden file may allow this many times the tolerance that the program computes now. If a largest value
/// has passed a power of ten, ten times would be enough.
inline constexpr double kMostOfTolerance = 100.0;

/// Numbers that count as unchanged only because `before` allows more than that: comparing them proves
/// nothing. "crank · r · x: 1e+09 m may differ, of 1e-06 m"
std::vector<std::string> loose_tolerances(const std::vector<Fact>& before, const std::vector<Fact>& after);

/// Facts that differ by more than the tolerances of `before`, most important first.
std::vector<FactChange> changes_of(const std::vector<Fact>& before, const std::vector<Fact>& after);

/// True if two texts say the same: their numbers may differ by one in the last printed digit, and numbers
/// below one billionth count as rounding. Whole numbers and words must be equal.
bool say_the_same(std::string_view before, std::string_view after);

/// A fact as text: "0.25 m".
std::string value_text(const Fact& fact);

}  // namespace jw::snapshot
