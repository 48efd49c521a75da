#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "app/snapshot/facts/fact_list.hpp"

namespace jw::snapshot {

namespace {

constexpr double kRelative = 1e-6;
constexpr double kLeastOfNatural = 1e-3;
/// Scale of units without a natural one, such as forces if all are zero.
constexpr double kLeast = 1e-6;

/// Typical values of lengths, angles and their rates in a mechanism that moves.
std::map<std::string, double> natural_scales(const NaturalScale& natural) {
    const double rate = 1.0 / natural.duration;
    return {
        {"m", natural.length},
        {"m²", natural.length * natural.length},
        {"m/s", natural.length * rate},
        {"m/s²", natural.length * rate * rate},
        {"", 1.0},
        {"rad", 1.0},
        {"rad/s", rate},
        {"rad/s²", rate * rate},
        {"deg", 57.3},
        {"deg/s", 57.3 * rate},
        {"deg/s²", 57.3 * rate * rate},
        {"s", natural.duration},
        {"of Φq", 1.0},
        {"of σ", 1.0},
        {"of ‖Φ‖", natural.length},
        {"of ‖Δq‖", natural.length}};
}

/// Decimals with which a number of this tolerance is written: one more than matters.
int decimals_of(double tolerance) { return 1 - static_cast<int>(std::lround(std::log10(tolerance))); }

}  // namespace

void set_tolerance(Fact& fact, double scale) {
    // a power of ten, so that the scale stays the same if the largest value changes in its last digits
    fact.tolerance = std::pow(10.0, std::floor(std::log10(kRelative * scale)));
    const double step = 0.1 * fact.tolerance;
    fact.value = std::round(*fact.value / step) * step;
}

std::string short_decimal(const Fact& fact) {
    if (fact.tolerance <= 0.0) { return std::to_string(std::lround(*fact.value)); }
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f", std::max(decimals_of(fact.tolerance), 0), *fact.value);
    std::string digits = text.data();
    if (digits.find('.') != std::string::npos) {
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.ends_with('.')) { digits.pop_back(); }
    }
    return digits == "-0" ? "0" : digits;
}

void set_tolerances(std::vector<std::vector<Fact>*> facts, const NaturalScale& natural) {
    std::map<std::string, double> scales;
    for (const auto& [unit, scale] : natural_scales(natural)) { scales[unit] = kLeastOfNatural * scale; }
    const auto is_number = [](const Fact& fact) { return fact.tolerance == FactList::kToBeSet; };
    for (const std::vector<Fact>* list : facts) {
        for (const Fact& fact : *list) {
            if (!is_number(fact)) { continue; }
            double& scale = scales.try_emplace(fact.unit, kLeast).first->second;
            scale = std::max(scale, std::abs(*fact.value));
        }
    }
    for (std::vector<Fact>* list : facts) {
        for (Fact& fact : *list) {
            if (!is_number(fact)) { continue; }
            set_tolerance(fact, scales[fact.unit]);
        }
    }
}

}  // namespace jw::snapshot
