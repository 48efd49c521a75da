#include "app/exercises/answers/units.hpp"

#include <cctype>
#include <cmath>
#include <numbers>
#include <string>

#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

struct UnitName {
    std::string_view name;
    WrittenUnit unit;
};

constexpr double kDegree = std::numbers::pi / 180.0;

// powers of m, kg, s, rad
constexpr std::array kUnits{
    UnitName{"deg", {kDegree, {0, 0, 0, 1}}},     UnitName{"°", {kDegree, {0, 0, 0, 1}}},
    UnitName{"degrees", {kDegree, {0, 0, 0, 1}}}, UnitName{"rad", {1.0, {0, 0, 0, 1}}},
    UnitName{"m", {1.0, {1, 0, 0, 0}}},           UnitName{"cm", {0.01, {1, 0, 0, 0}}},
    UnitName{"mm", {0.001, {1, 0, 0, 0}}},        UnitName{"s", {1.0, {0, 0, 1, 0}}},
    UnitName{"ms", {0.001, {0, 0, 1, 0}}},        UnitName{"kg", {1.0, {0, 1, 0, 0}}},
    UnitName{"g", {0.001, {0, 1, 0, 0}}},         UnitName{"N", {1.0, {1, 1, -2, 0}}},
    UnitName{"kN", {1000.0, {1, 1, -2, 0}}},      UnitName{"J", {1.0, {2, 1, -2, 0}}},
    UnitName{"Hz", {1.0, {0, 0, -1, 0}}}};

/// Takes a power from the front: "^2", "²", "^-1".
int take_power(std::string_view& text) {
    for (const auto& [sign, power] : {std::pair<std::string_view, int>{"²", 2}, {"³", 3}}) {
        if (text.starts_with(sign)) {
            text.remove_prefix(sign.size());
            return power;
        }
    }
    if (text.empty()) { return 1; }
    const bool caret = text.front() == '^';
    if (caret) { text.remove_prefix(1); }
    const bool minus = caret && !text.empty() && text.front() == '-';
    if (minus) { text.remove_prefix(1); }
    if (text.empty() || text.front() < '1' || text.front() > '4') { return caret ? 0 : 1; }
    const int power = text.front() - '0';
    text.remove_prefix(1);
    return minus ? -power : power;
}

bool is_part_of_word(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80U;
}

/// Takes a unit name from the front.
const UnitName* take_name(std::string_view& text) {
    const UnitName* best = nullptr;
    for (const UnitName& unit : kUnits) {
        if (!text.starts_with(unit.name)) { continue; }
        if (best == nullptr || unit.name.size() > best->name.size()) { best = &unit; }
    }
    if (best == nullptr) { return nullptr; }
    const std::string_view rest = text.substr(best->name.size());
    const bool power = rest.starts_with("²") || rest.starts_with("³") || rest.starts_with("·");
    if (!rest.empty() && is_part_of_word(rest.front()) && !power) { return nullptr; }
    text = rest;
    return best;
}

}  // namespace

std::optional<WrittenUnit> read_unit(std::string_view text) {
    WrittenUnit unit;
    int side = 1;
    while (!text.empty()) {
        if (text.front() == ' ' || text.front() == '*') {
            text.remove_prefix(1);
        } else if (text.starts_with("·")) {
            text.remove_prefix(std::string_view("·").size());
        } else if (text.front() == '/') {
            if (side < 0) { return std::nullopt; }
            side = -1;
            text.remove_prefix(1);
        } else {
            const UnitName* const name = take_name(text);
            if (name == nullptr) { return std::nullopt; }
            const int power = side * take_power(text);
            if (power == 0) { return std::nullopt; }
            unit.factor *= elementary::pow(name->unit.factor, power);
            for (std::size_t k = 0; k < unit.powers.size(); ++k) {
                unit.powers[k] += power * name->unit.powers[k];
            }
        }
    }
    return unit;
}

}  // namespace jw
