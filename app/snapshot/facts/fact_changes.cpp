#include "app/snapshot/facts/fact_changes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "lessons/diagnostics/diagnostics.hpp"

namespace jw::snapshot {

namespace {

/// Residuals of solved equations are rounding: Newton's method goes on to 1e-10 at least.
constexpr double kRounding = 1e-9;

struct NumberInText {
    double value = 0.0;
    double last_digit = 0.0;  ///< the value of one unit in it; 0 for a whole number
    std::size_t length = 0;   ///< bytes; 0: there is no number here
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Bytes of a sign at the start: '-' or '−'.
std::size_t sign_length(std::string_view text) {
    constexpr std::string_view minus = "−";
    if (text.starts_with('-')) { return 1; }
    return text.starts_with(minus) ? minus.size() : 0;
}

/// The number that `text` begins with.
NumberInText number_at(std::string_view text) {
    const std::size_t sign = sign_length(text);
    const std::string_view digits = text.substr(sign);
    if (digits.empty() || !is_digit(digits.front())) { return {}; }
    NumberInText found;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), found.value);
    if (error != std::errc()) { return {}; }
    const std::string_view number(digits.data(), static_cast<std::size_t>(end - digits.data()));
    found.length = sign + number.size();
    const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
    const std::size_t point = number.find('.');
    if (point != std::string_view::npos || exponent < number.size()) {
        const std::size_t decimals = point == std::string_view::npos ? 0 : exponent - point - 1;
        int power = 0;
        if (exponent < number.size()) {
            std::size_t from = exponent + 1;
            if (from < number.size() && number[from] == '+') { ++from; }
            std::from_chars(number.data() + from, number.data() + number.size(), power);
        }
        found.last_digit = std::pow(10.0, power - static_cast<int>(decimals));
    }
    if (sign > 0) { found.value = -found.value; }
    return found;
}

bool are_same(const NumberInText& a, const NumberInText& b) {
    const double digit = std::max(a.last_digit, b.last_digit);
    if (digit == 0.0) { return a.value == b.value; }
    // one and a half units: the last digits may differ by one, and are not exact binary numbers
    return std::abs(a.value - b.value) <= std::max(1.5 * digit, kRounding);
}

/// True for texts from the lesson's file: no machine rounds their numbers.
bool is_of_author(std::string_view name) {
    constexpr std::array names{
        "title of the lesson", "text of the author", "question", "reason of the answer", "source"};
    return std::ranges::find(names, name) != names.end() || name == "choice" || name.starts_with("choice (");
}

bool are_same(const Fact& before, const Fact& after) {
    if (before.value.has_value() != after.value.has_value()) { return false; }
    if (!before.value) {
        return is_of_author(after.name) ? before.text == after.text : say_the_same(before.text, after.text);
    }
    return before.unit == after.unit && std::abs(*before.value - *after.value) <= before.tolerance;
}

/// True for a number that is zero and so may be missing, such as an entry of the matrix.
bool is_nothing(const Fact& fact, double tolerance) {
    return fact.value && fact.tolerance > 0.0 && std::abs(*fact.value) <= std::min(fact.tolerance, tolerance);
}

/// The largest tolerance of each unit.
std::map<std::string_view, double> tolerances_of(const std::vector<Fact>& facts) {
    std::map<std::string_view, double> tolerances;
    for (const Fact& fact : facts) {
        double& tolerance = tolerances[fact.unit];
        tolerance = std::max(tolerance, fact.tolerance);
    }
    return tolerances;
}

}  // namespace

bool say_the_same(std::string_view before, std::string_view after) {
    while (!before.empty() && !after.empty()) {
        const NumberInText a = number_at(before);
        const NumberInText b = number_at(after);
        if (a.length > 0 && b.length > 0) {
            if (!are_same(a, b)) { return false; }
            before.remove_prefix(a.length);
            after.remove_prefix(b.length);
        } else {
            if (before.front() != after.front()) { return false; }
            before.remove_prefix(1);
            after.remove_prefix(1);
        }
    }
    return before.empty() && after.empty();
}

std::string value_text(const Fact& fact) {
    if (!fact.value) { return fact.text; }
    const bool has_unit = !fact.unit.empty() && !fact.unit.starts_with("of ");
    return short_decimal(fact) + (has_unit ? " " + fact.unit : "");
}

std::optional<StepNumber> step_number_of(const std::vector<Fact>& facts) {
    const auto count = [&](const char* name) {
        const auto fact = std::ranges::find(facts, name, &Fact::name);
        return fact != facts.end() && fact->value ? static_cast<int>(std::lround(*fact->value)) : 0;
    };
    const StepNumber number{count(kStepFact), count(kStepsFact)};
    if (number.step < 1 || number.step > number.steps) { return std::nullopt; }
    return number;
}

std::vector<std::string> loose_tolerances(const std::vector<Fact>& before, const std::vector<Fact>& after) {
    std::map<std::string_view, const Fact*> now;
    for (const Fact& fact : after) { now.emplace(fact.name, &fact); }
    std::vector<std::string> loose;
    for (const Fact& fact : before) {
        const auto found = now.find(fact.name);
        if (!fact.value || found == now.end() || !are_same(fact, *found->second)) { continue; }
        const double tolerance = found->second->tolerance;
        // tolerances are powers of ten, which are not exact binary numbers
        if (fact.tolerance <= (1.0 + 1e-9) * kMostOfTolerance * tolerance) { continue; }
        loose.push_back(
            fact.name + ": " + short_number(fact.tolerance) + " " + fact.unit + " may differ, of " +
            short_number(tolerance) + " " + fact.unit);
    }
    return loose;
}

std::vector<FactChange> changes_of(const std::vector<Fact>& before, const std::vector<Fact>& after) {
    std::map<std::string_view, const Fact*> left;
    for (const Fact& fact : before) { left.emplace(fact.name, &fact); }
    std::vector<FactChange> changes;
    for (const Fact& fact : after) {
        const auto old = left.find(fact.name);
        if (old == left.end()) {
            if (!is_nothing(fact, fact.tolerance)) {
                changes.push_back({fact.weight, fact.name, {}, value_text(fact)});
            }
            continue;
        }
        if (!are_same(*old->second, fact)) {
            changes.push_back({fact.weight, fact.name, value_text(*old->second), value_text(fact)});
        }
        left.erase(old);
    }
    const std::map<std::string_view, double> tolerances = tolerances_of(after);
    for (const Fact& fact : before) {
        if (!left.contains(fact.name)) { continue; }
        const auto of_unit = tolerances.find(fact.unit);
        const double believed =
            of_unit == tolerances.end() ? fact.tolerance : kMostOfTolerance * of_unit->second;
        if (is_nothing(fact, believed)) { continue; }
        changes.push_back({fact.weight, fact.name, value_text(fact), {}});
    }
    std::ranges::stable_sort(changes, {}, &FactChange::weight);
    return changes;
}

}  // namespace jw::snapshot
