#include <algorithm>
#include <array>
#include <cmath>

#include "core/numerics/decimal.hpp"
#include "core/quantity/names.hpp"

namespace jw {

namespace {

constexpr std::array<std::string_view, 3> kDots{"", "_dot", "_ddot"};

int index_of(std::string_view name, const auto& things) {
    for (std::size_t k = 0; k < things.size(); ++k) {
        if (things[k].name == name) { return static_cast<int>(k); }
    }
    return -1;
}

std::optional<int> axis_of(std::string_view word) {
    constexpr std::string_view axes = "xyz";
    const auto found = word.size() == 1 ? axes.find(word[0]) : std::string_view::npos;
    return found == std::string_view::npos ? std::nullopt : std::optional(static_cast<int>(found));
}

/// Takes `start` from the front of `text`.
bool take(std::string_view& text, std::string_view start) {
    if (!text.starts_with(start)) { return false; }
    text.remove_prefix(start.size());
    return true;
}

/// Takes "_dot" or "_ddot" from the front.
int take_dots(std::string_view& text) { return take(text, "_ddot") ? 2 : take(text, "_dot") ? 1 : 0; }

/// Takes "[0.5 0 1e-3]" from the front, with one blank between numbers.
std::optional<Vec3> take_vector(std::string_view& text) {
    if (!take(text, "[")) { return std::nullopt; }
    Vec3 v = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const auto [end, error] = read_decimal(text.data(), text.data() + text.size(), v(k));
        if (error != std::errc{} || !std::isfinite(v(k))) { return std::nullopt; }
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (!take(text, k < 2 ? " " : "]")) { return std::nullopt; }
    }
    return v;
}

ReadName plain(const Quantity& quantity, int derivative = 0) { return {{quantity, derivative}, {}, false}; }

/// Finds the entry of a list that has this name.
std::optional<ReadName> found_in(
    const std::vector<NamedQuantity>& list, std::string_view text, const Mechanism& mechanism) {
    for (const NamedQuantity& named : list) {
        if (name_of(named.quantity, named.derivative, mechanism) == text) {
            return ReadName{named, {}, false};
        }
    }
    return std::nullopt;
}

/// "point[0.5 0 0].x", "point_dot.x", "point.speed": without numbers, the point is not given.
std::optional<ReadName> point_of(std::string_view word, int body) {
    if (!take(word, "point")) { return std::nullopt; }
    const int derivative = take_dots(word);
    const bool open = !word.starts_with("[");
    const std::optional<Vec3> point = open ? Vec3::Zero().eval() : take_vector(word);
    if (!point || !take(word, ".")) { return std::nullopt; }
    if (derivative == 0 && take(word, "speed")) {
        const int more = take_dots(word);
        if (!word.empty() || more > 1) { return std::nullopt; }
        return ReadName{{PointSpeedQuantity{body, *point}, more}, {}, open};
    }
    const std::optional<int> axis = axis_of(word);
    if (!axis) { return std::nullopt; }
    return ReadName{{PointQuantity{body, *point, *axis}, derivative}, {}, open};
}

/// "distance[0 0 0].rocker[1 0 0]", "angle_dot[0 0 1].rocker[1 0 0]".
std::optional<ReadName> between(std::string_view word, int body, const Mechanism& mechanism) {
    const bool distance = take(word, "distance");
    if (!distance && !take(word, "angle")) { return std::nullopt; }
    const int derivative = take_dots(word);
    const std::optional<Vec3> on_i = take_vector(word);
    const std::size_t bracket = word.rfind('[');
    if (!on_i || !take(word, ".") || bracket == std::string_view::npos) { return std::nullopt; }
    const int other = index_of(word.substr(0, bracket - 1), mechanism.bodies);
    word.remove_prefix(bracket - 1);
    const std::optional<Vec3> on_j = take_vector(word);
    if (other < 0 || !on_j || !word.empty()) { return std::nullopt; }
    if (distance) {
        return plain(MeasureQuantity{SquaredDistanceMeasure{*on_i, *on_j}, body, other, -1, -1}, derivative);
    }
    if (on_i->isZero(0.0) || on_j->isZero(0.0)) { return std::nullopt; }
    return plain(DirectionsQuantity{body, *on_i, other, *on_j}, derivative);
}

/// Reads a present name.
std::optional<ReadName> read_today(std::string_view text, const Mechanism& mechanism) {
    std::vector<NamedQuantity> whole;
    for (int k = 0; k < kEnergyParts; ++k) {
        for (int d = 0; d < 2; ++d) { whole.push_back({EnergyQuantity{static_cast<EnergyPart>(k)}, d}); }
    }
    whole.push_back({SingularValueQuantity{}, 0});
    if (auto found = found_in(whole, text, mechanism)) { return found; }
    const std::string_view owner = owner_in(text);
    const int body = index_of(owner, mechanism.bodies);
    if (body >= 0) {
        if (auto found = found_in(quantities_of_body(body), text, mechanism)) { return found; }
        if (text.size() <= owner.size()) { return std::nullopt; }
        const std::string_view word = text.substr(owner.size() + 1);
        if (auto found = point_of(word, body)) { return found; }
        return between(word, body, mechanism);
    }
    const int joint = index_of(owner, mechanism.joints);
    if (joint >= 0) { return found_in(quantities_of_joint(mechanism, joint), text, mechanism); }
    const int driver = index_of(owner, mechanism.drivers);
    if (driver >= 0) { return found_in(quantities_of_driver(mechanism, driver), text, mechanism); }
    return std::nullopt;
}

bool take_end(std::string_view& text, std::string_view end) {
    if (!text.ends_with(end)) { return false; }
    text.remove_suffix(end.size());
    return true;
}

/// Present name of a former name; any other text is returned unchanged.
std::string today_of(std::string_view text) {
    if (text == "kinetic_J") { return "energy.kinetic"; }
    if (text == "potential_J") { return "energy.potential"; }
    std::string_view rest = text;
    if (take_end(rest, ".point speed")) { return std::string(rest) + ".point.speed"; }
    if (take_end(rest, " rate")) { return std::string(rest) + "_dot"; }
    if (take_end(rest, " acceleration")) { return std::string(rest) + "_ddot"; }
    for (const std::string_view dot : kDots) {
        rest = text;
        if (take_end(rest, std::string(".theta") + std::string(dot))) {
            return std::string(rest) + ".angle" + std::string(dot);
        }
    }
    for (const std::string_view axis : {".x", ".y", ".z"}) {
        rest = text;
        if (take_end(rest, std::string(".r") + std::string(axis))) {
            return std::string(rest) + std::string(axis);
        }
    }
    return std::string(text);
}

/// "crank.r_dot.x" from "crank.x_dot", formerly "crank.x rate": derivatives of coordinates are named after r.
std::string named_after_r(std::string_view today) {
    for (const std::string_view dot : {kDots[1], kDots[2]}) {
        std::string_view rest = today;
        if (!take_end(rest, dot) || rest.size() < 2) { continue; }
        const std::string_view axis = rest.substr(rest.size() - 2);
        if (axis[0] != '.' || !axis_of(axis.substr(1))) { continue; }
        rest.remove_suffix(2);
        return std::string(rest) + ".r" + std::string(dot) + std::string(axis);
    }
    return std::string(today);
}

}  // namespace

std::string_view owner_in(std::string_view name) {
    if (name.starts_with("|") && name.find('|', 1) != std::string_view::npos) { name.remove_prefix(1); }
    return name.substr(0, name.find('.'));
}

std::optional<ReadName> read_name(std::string_view text, const Mechanism& mechanism) {
    if (auto found = read_today(text, mechanism)) { return found; }
    const std::string today = named_after_r(today_of(text));
    if (today == text) { return std::nullopt; }
    auto found = read_today(today, mechanism);
    if (found) { found->name_of_today = today; }
    return found;
}

}  // namespace jw
