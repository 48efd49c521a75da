#include "app/exercises/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

/// Significant digits of which the rounding is within the tolerance whatever the first digit is: of 1.0 it is
/// half a unit of the last one.
std::size_t digits_for(double relative_tolerance) {
    return static_cast<std::size_t>(
        std::max(1.0, std::ceil(1.0 - std::log10(2.0 * relative_tolerance) - 1e-9)));
}

}  // namespace

std::string accuracy_text(const Task& task) {
    constexpr std::array<std::string_view, 9> kWords{"no",   "One", "Two",   "Three", "Four",
                                                     "Five", "Six", "Seven", "Eight"};
    const Asked& asked = task.asked;
    const ExerciseKind kind = task.exercise().kind;
    const bool is_measured = kind == ExerciseKind::number || kind == ExerciseKind::vector ||
                             kind == ExerciseKind::matrix || kind == ExerciseKind::pose;
    if (!is_measured || asked.tolerance <= 0.0 || asked.right.size() == 0) { return {}; }
    const bool several = asked.right.size() > 1;
    if (task.exercise().absolute) {
        const std::string unit = asked.unit.empty() ? "" : " " + asked.unit;
        return (several ? "Each number may be off by " : "It may be off by ") +
               number_text(asked.tolerance, 3) + unit + ".";
    }
    // not the tolerance itself: it is a share of the answer
    const std::size_t digits = digits_for(task.exercise().tolerance);
    const std::string count = digits < kWords.size() ? std::string(kWords[digits]) : std::to_string(digits);
    return count + (digits == 1 ? " significant digit" : " significant digits") +
           (several ? " in each number" : "") + (digits == 1 ? " is enough." : " are enough.");
}

}  // namespace jw
