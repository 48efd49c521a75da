#include "app/snapshot/units_of_keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/exercise/scene_edits.hpp"
#include "lessons/format/key.hpp"

namespace jw::snapshot {

namespace {

/// Values of a function of time, in the unit of the function.
constexpr std::array<std::string_view, 6> kValues{"polynomial", "amplitude", "from",
                                                  "to",         "values",    "formula"};

}  // namespace

std::string unit_of_coefficient(const std::string& unit, std::size_t power) {
    return power == 0 ? unit : power == 1 ? unit + "/s" : unit + "/s^" + std::to_string(power);
}

std::string UnitsOfKeys::unit_of_load(const std::string& path, std::size_t index) const {
    const std::string_view table = table_of(path);
    const std::string unit = table == "force" ? "N" : "N m";
    const std::string_view key = last_key(path);
    if (std::ranges::find(kValues, key) == kValues.end()) { return {}; }
    // beside a vector in N, a function is only a factor
    const bool is_factor = value_in(lesson_, entry_of(path) + ".direction").empty();
    return is_factor ? std::string() : unit_of_coefficient(unit, key == "polynomial" ? index : 0);
}

std::string UnitsOfKeys::unit(const std::string& path, std::size_t index) const {
    const std::string_view table = table_of(path);
    const std::string known = unit_of_key(path);
    return known.empty() && (table == "force" || table == "torque") ? unit_of_load(path, index) : known;
}

std::string UnitsOfKeys::amount(const std::string& path, std::size_t index, double amount) const {
    const std::string unit = this->unit(path, index);
    if (unit == "m" && amount < 0.1) { return short_number(1000.0 * amount, 4) + " mm"; }
    return short_number(amount, 4) + (unit.empty() ? "" : " " + unit);
}

}  // namespace jw::snapshot
