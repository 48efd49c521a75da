#include "lessons/precision/rounded_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "core/elementary/elementary.hpp"

namespace jw::reading {

namespace {

// a number decides if it has three times the effect of all others together; otherwise it is one of several
constexpr double kDecides = 3.0;

/// Half a unit of the last digit of a number with a decimal point.
/// @param digits  with this many significant digits or more, it counts as rounded
/// @return 0 for an exact number
double half_unit(const std::string& typed, int digits) {
    const std::size_t point = typed.find('.');
    if (point == std::string::npos) { return 0.0; }
    const std::size_t end = std::min(typed.find_first_of("eE"), typed.size());
    int exponent = 0;
    if (end < typed.size()) {
        const char* from = typed.data() + end + (typed[end + 1] == '+' ? 2 : 1);
        std::from_chars(from, typed.data() + typed.size(), exponent);
    }
    int significant = 0;
    for (std::size_t k = 0; k < end; ++k) {
        const bool is_digit = typed[k] >= '0' && typed[k] <= '9';
        if (is_digit && (significant > 0 || typed[k] != '0')) { ++significant; }
    }
    const auto decimals = static_cast<int>(end - point) - 1;
    return significant >= digits ? 0.5 * elementary::pow(10.0, exponent - decimals) : 0.0;
}

/// A number that was rounded, or may have been.
struct Rounded {
    double half_unit = 0.0;
    bool is_short = false;
};

/// Rounding of the numbers of a key: a shorter one may have lost its last zeros, if others have more digits.
std::vector<Rounded> rounded(const std::vector<TypedText>& typed, int digits) {
    std::vector<Rounded> out;
    double most = 0.0;
    for (const TypedText& number : typed) {
        out.push_back({half_unit(number.text, digits)});
        most = std::max(most, out.back().half_unit);
    }
    for (std::size_t k = 0; k < typed.size(); ++k) {
        if (out[k].half_unit == 0.0 && typed[k].value != std::round(typed[k].value)) {
            out[k] = {most, true};
        }
    }
    return out;
}

}  // namespace

void RoundedNumbers::add(
    const Fields& fields, const std::string& pose_of, std::string_view key, std::size_t count,
    const Changes& changes, double by) {
    const std::vector<TypedText> typed = fields.typed_numbers(key);
    if (typed.size() != count) { return; }
    const std::vector<Rounded> numbers = rounded(typed, reading_.lesson.precision.digits);
    for (std::size_t k = 0; k < count; ++k) {
        if (numbers[k].half_unit == 0.0) { continue; }
        std::vector<Change> list = changes(static_cast<Eigen::Index>(k));
        if (list.empty()) { continue; }
        all_.push_back({by * numbers[k].half_unit, std::move(list), numbers[k].is_short, 0});
        const std::string& what = pose_of.empty() ? fields.what() : pose_of;
        places_.push_back(
            {typed[k].span, typed[k].text, fields.span(key), in_quotes(std::string(key)) + " of " + what,
             !pose_of.empty()});
    }
}

void RoundedNumbers::add_vector(
    const Fields& fields, int joint, std::string_view key, const std::vector<Target>& targets, bool is_unit) {
    double square = is_unit ? 0.0 : 1.0;
    if (is_unit) {
        for (const TypedText& number : fields.typed_numbers(key)) { square += number.value * number.value; }
    }
    const double by = 1.0 / std::sqrt(square);
    const auto changes = [&](Eigen::Index k) {
        std::vector<Change> list;
        for (const Target& target : targets) {
            list.push_back({joint, target.vector, by * target.way.col(k)});
        }
        return list;
    };
    add(fields, {}, key, 3, changes);
}

void RoundedNumbers::add_scalar(
    const Fields& fields, int joint, std::string_view key, double JointGeometry::*scalar, double by) {
    const auto changes = [&](Eigen::Index) {
        return std::vector{Change{joint, nullptr, Vec3::Zero(), scalar}};
    };
    add(fields, {}, key, 1, changes, by);
}

void RoundedNumbers::add_axes(const Fields& fields, int joint, const Mat3& to_i, const Mat3& to_j) {
    const Joint& read = reading_.lesson.mechanism.joints[at(joint)];
    const JointNeeds needs(*read.type);
    std::vector<Target> axes{{&JointGeometry::s_i_local, to_i}};
    if (needs.axis_j && !needs.arms) { axes.push_back({&JointGeometry::s_j_local, to_j}); }
    add_vector(fields, joint, "axis", axes, true);
    add_vector(fields, joint, "axis2", {{&JointGeometry::s_j_local, to_j}}, true);
    if (!read.type->uses(kSidesH)) { return; }
    const Vec3 axis = to_i.transpose() * read.geometry.s_i_local.normalized();
    add_vector(
        fields, joint, "side",
        {{&JointGeometry::h_i_local, to_i}, {&JointGeometry::h_j_local, to_j * tilde(axis)}}, true);
}

void RoundedNumbers::add_joint(const Fields& fields, int joint) {
    const Mechanism& mechanism = reading_.lesson.mechanism;
    const Joint& read = mechanism.joints[at(joint)];
    const Mat3 to_i = rotation_of(mechanism.bodies[at(read.body_i)]).transpose();
    const Mat3 to_j = rotation_of(mechanism.bodies[at(read.body_j)]).transpose();
    const Target point_i{&JointGeometry::P_i_local, to_i};
    const Target point_j{&JointGeometry::P_j_local, to_j};
    const bool has_two = !fields.typed_numbers("to").empty();
    add_vector(fields, joint, "at", has_two ? std::vector{point_i} : std::vector{point_i, point_j});
    add_vector(fields, joint, "to", {point_j});
    for (const LocalKey& local : kLocalKeys) {
        add_vector(fields, joint, local.key, {{local.vector, Mat3::Identity()}});
    }
    add_axes(fields, joint, to_i, to_j);
    add_scalar(fields, joint, "length", &JointGeometry::length);
    add_scalar(fields, joint, "pitch", &JointGeometry::alpha, 1.0 / (2.0 * std::numbers::pi));
    add_scalar(fields, joint, "advance_per_rad", &JointGeometry::alpha);
    add_scalar(fields, joint, "radius", &JointGeometry::alpha);
}

void RoundedNumbers::add_joints(const std::vector<Fields>& joints) {
    for (std::size_t k = 0; k < joints.size(); ++k) { add_joint(joints[k], static_cast<int>(k)); }
}

Located<std::string> RoundedNumbers::short_of_digits(const VectorX& effects) const {
    const double all = effects.squaredNorm();
    const auto decides = [&](double square) { return square > kDecides * kDecides * (all - square); };
    std::map<std::string, double> of_keys;
    double of_poses = 0.0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const Place& place = places_[k];
        const double square = effects(static_cast<Eigen::Index>(k)) * effects(static_cast<Eigen::Index>(k));
        if (decides(square)) { return {place.text + " in " + place.key_name, place.span}; }
        of_keys[place.key_name] += square;
        of_poses += place.is_of_pose ? square : 0.0;
    }
    for (const Place& place : places_) {
        if (decides(of_keys[place.key_name])) { return {place.key_name, place.key}; }
    }
    if (decides(of_poses)) { return {"poses of bodies", {}}; }
    return {decides(all - of_poses) ? "points and axes" : "points, axes and poses of bodies", {}};
}

}  // namespace jw::reading
