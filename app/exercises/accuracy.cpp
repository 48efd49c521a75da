#include "app/exercises/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"
#include "lessons/text/translatable.hpp"

namespace jw {

namespace {

/// Number of significant digits at which rounding stays within the tolerance, whatever the first digit is:
/// for 1.0, rounding is half a unit of the last digit.
int digits_for(double relative_tolerance) {
    return static_cast<int>(
        std::max(1.0, std::ceil(1.0 - elementary::log10(2.0 * relative_tolerance) - 1e-9)));
}

}  // namespace

std::string accuracy_text(const Task& task) {
    constexpr std::array kWords{
        "",
        tr_later("One"),
        tr_later("Two"),
        tr_later("Three"),
        tr_later("Four"),
        tr_later("Five"),
        tr_later("Six"),
        tr_later("Seven"),
        tr_later("Eight")};
    const Asked& asked = task.asked;
    const ExerciseKind kind = task.exercise().kind;
    const bool is_measured = kind == ExerciseKind::number || kind == ExerciseKind::vector ||
                             kind == ExerciseKind::matrix || kind == ExerciseKind::pose;
    if (!is_measured || asked.tolerance <= 0.0 || asked.right.size() == 0) { return {}; }
    const bool several = asked.right.size() > 1;
    if (task.exercise().absolute) {
        const std::string unit = asked.unit.empty() ? "" : " " + asked.unit;
        const std::string off = number_text(asked.tolerance, 3) + unit;
        return several ? tr("Each number may be off by {0}.", off) : tr("It may be off by {0}.", off);
    }
    // not the tolerance itself, which is a fraction of the answer
    const int digits = digits_for(task.exercise().tolerance);
    const auto k = static_cast<std::size_t>(digits);
    const std::string count = k < kWords.size() ? tr(kWords[k]) : std::to_string(digits);
    return several
               ? tr_count(
                     digits, "{1} significant digit in each number is enough.",
                     "{1} significant digits in each number are enough.", count)
               : tr_count(
                     digits, "{1} significant digit is enough.", "{1} significant digits are enough.", count);
}

}  // namespace jw
