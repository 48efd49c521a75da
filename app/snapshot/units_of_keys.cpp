#include "app/snapshot/units_of_keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "lessons/diagnostics.hpp"
#include "lessons/exercise/scene_edits.hpp"

namespace jw::snapshot {

namespace {

/// Keys of lengths in m, unless their table says otherwise.
constexpr std::array<std::string_view, 17> kLengths{
    "point", "point_i",  "point_j", "radius", "size",           "at",     "at_i",       "at_j", "from", "to",
    "pitch", "position", "offset",  "length", "centre_of_mass", "target", "free_length"};

constexpr std::array<std::pair<std::string_view, const char*>, 5> kEndings{
    {{"_deg_per_s", "deg/s"}, {"_rad_per_s", "rad/s"}, {"_deg", "deg"}, {"_rad", "rad"}, {"_s", "s"}}};

struct UnitOfKey {
    std::string_view table;
    std::string_view key;
    const char* unit;
};

/// `from` of the camera is a direction.
constexpr std::array<UnitOfKey, 10> kUnits{
    {{"body", "mass", "kg"},
     {"body", "inertia", "kg m²"},
     {"body", "centre", "m"},
     {"camera", "from", ""},
     {"dynamics", "duration", "s"},
     {"dynamics", "gravity", "m/s²"},
     {"spring", "stiffness", "N/m"},
     {"spring", "damping", "N s/m"},
     {"rotational_spring", "stiffness", "N m/rad"},
     {"rotational_spring", "damping", "N m s/rad"}}};

/// Values of a function of time, in the unit of what it is a function of.
constexpr std::array<std::string_view, 4> kValues{"polynomial", "amplitude", "from", "to"};

template <class Words>
bool has(const Words& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::string unit_of_coefficient(const std::string& unit, std::size_t power) {
    return power == 0 ? unit : power == 1 ? unit + "/s" : unit + "/s^" + std::to_string(power);
}

std::string UnitsOfKeys::unit_of_load(const std::string& path, std::size_t index) const {
    const std::string_view table = table_of(path);
    const std::string unit = table == "force" ? "N" : "N m";
    const std::string_view key = last_key(path);
    if (key == table) { return unit; }
    if (!has(kValues, key)) { return {}; }
    // beside a vector in N a function is a factor
    const bool is_factor = value_in(lesson_, entry_of(path) + ".direction").empty();
    return is_factor ? std::string() : unit_of_coefficient(unit, key == "polynomial" ? index : 0);
}

std::string UnitsOfKeys::unit(const std::string& path, std::size_t index) const {
    const std::string_view key = last_key(path);
    const std::string_view table = table_of(path);
    const auto ending =
        std::ranges::find_if(kEndings, [key](const auto& known) { return key.ends_with(known.first); });
    if (ending != kEndings.end()) { return ending->second; }
    const auto known =
        std::ranges::find_if(kUnits, [&](const UnitOfKey& of) { return of.table == table && of.key == key; });
    if (known != kUnits.end()) { return known->unit; }
    const bool is_load = table == "force" || table == "torque";
    if (is_load && key != "at" && key != "point") { return unit_of_load(path, index); }
    return has(kLengths, key) ? "m" : "";
}

std::string UnitsOfKeys::amount(const std::string& path, std::size_t index, double amount) const {
    const std::string unit = this->unit(path, index);
    if (unit == "m" && amount < 0.1) { return short_number(1000.0 * amount, 4) + " mm"; }
    return short_number(amount, 4) + (unit.empty() ? "" : " " + unit);
}

}  // namespace jw::snapshot
