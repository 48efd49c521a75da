#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/elementary/elementary.hpp"
#include "core/poses/typed/meant_mechanism.hpp"
#include "lessons/reading.hpp"

/// What the digits say that the author of a lesson has typed: a short number is exact, a long one was
/// rounded.
namespace jw::reading {

namespace {

constexpr int kFewestDigits = 2;
constexpr int kMostDigits = 17;

/// Half a unit of the last digit of a number with a decimal point. @param digits significant ones from which
///        on it counts as rounded @return 0 for one that is exact
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

/// The numbers of joints that were rounded.
class RoundedNumbers {
public:
    explicit RoundedNumbers(const Reading& reading) : reading_(reading) {}

    void add(const Fields& fields, int joint);
    const std::vector<TypedNumber>& all() const { return all_; }

private:
    /// A vector of the geometry, and the way there from the vector that was typed.
    struct Target {
        Vec3 JointGeometry::*vector;
        Mat3 way;
    };
    void add_vector(const Fields& fields, const char* key, const std::vector<Target>& targets, bool is_unit);
    void add_scalar(const Fields& fields, const char* key, double JointGeometry::*scalar, double by);
    std::vector<Rounded> rounded(const std::vector<TypedText>& typed) const;
    void add_axes(const Fields& fields, const JointType& type, const Mat3& to_i, const Mat3& to_j);

    const Reading& reading_;
    int joint_ = 0;
    std::vector<TypedNumber> all_;
};

/// A number with fewer digits may be one that lost its last zeros, if others of its vector have more.
std::vector<Rounded> RoundedNumbers::rounded(const std::vector<TypedText>& typed) const {
    std::vector<Rounded> out;
    double most = 0.0;
    for (const TypedText& number : typed) {
        out.push_back({half_unit(number.text, reading_.lesson.precision.digits)});
        most = std::max(most, out.back().half_unit);
    }
    for (std::size_t k = 0; k < typed.size(); ++k) {
        if (out[k].half_unit == 0.0 && typed[k].value != std::round(typed[k].value)) {
            out[k] = {most, true};
        }
    }
    return out;
}

void RoundedNumbers::add_vector(
    const Fields& fields, const char* key, const std::vector<Target>& targets, bool is_unit) {
    const std::vector<TypedText> typed = fields.typed_numbers(key);
    if (typed.size() != 3) { return; }
    const Vec3 vector(typed[0].value, typed[1].value, typed[2].value);
    const double by = is_unit ? 1.0 / vector.norm() : 1.0;
    const std::vector<Rounded> numbers = rounded(typed);
    for (Eigen::Index k = 0; k < 3; ++k) {
        const auto& [half_unit, is_short] = numbers[at(k)];
        if (half_unit == 0.0) { continue; }
        TypedNumber& number = all_.emplace_back(TypedNumber{half_unit, {}, is_short});
        for (const Target& target : targets) {
            number.changes.push_back({joint_, target.vector, by * target.way.col(k)});
        }
    }
}

void RoundedNumbers::add_scalar(
    const Fields& fields, const char* key, double JointGeometry::*scalar, double by) {
    const std::vector<TypedText> typed = fields.typed_numbers(key);
    if (typed.size() != 1) { return; }
    const double unit = by * rounded(typed)[0].half_unit;
    if (unit > 0.0) { all_.push_back({unit, {{joint_, nullptr, Vec3::Zero(), scalar}}}); }
}

void RoundedNumbers::add_axes(
    const Fields& fields, const JointType& type, const Mat3& to_i, const Mat3& to_j) {
    const JointNeeds needs(type);
    std::vector<Target> axes{{&JointGeometry::s_i_local, to_i}};
    if (needs.axis_j && !needs.arms) { axes.push_back({&JointGeometry::s_j_local, to_j}); }
    add_vector(fields, "axis", axes, true);
    add_vector(fields, "axis2", {{&JointGeometry::s_j_local, to_j}}, true);
    add_vector(fields, "axis_i", {{&JointGeometry::s_i_local, Mat3::Identity()}}, false);
    add_vector(fields, "axis_j", {{&JointGeometry::s_j_local, Mat3::Identity()}}, false);
    if (!type.uses(kSidesH)) { return; }
    const Joint& joint = reading_.lesson.mechanism.joints[at(joint_)];
    const Vec3 axis = to_i.transpose() * joint.geometry.s_i_local.normalized();
    add_vector(
        fields, "side", {{&JointGeometry::h_i_local, to_i}, {&JointGeometry::h_j_local, to_j * tilde(axis)}},
        true);
    add_vector(fields, "side_i", {{&JointGeometry::h_i_local, Mat3::Identity()}}, false);
    add_vector(fields, "side_j", {{&JointGeometry::h_j_local, Mat3::Identity()}}, false);
}

void RoundedNumbers::add(const Fields& fields, int joint) {
    joint_ = joint;
    const Mechanism& mechanism = reading_.lesson.mechanism;
    const Joint& read = mechanism.joints[at(joint)];
    const Mat3 to_i = rotation_of(mechanism.bodies[at(read.body_i)]).transpose();
    const Mat3 to_j = rotation_of(mechanism.bodies[at(read.body_j)]).transpose();
    const Target point_i{&JointGeometry::P_i_local, to_i};
    const Target point_j{&JointGeometry::P_j_local, to_j};
    const bool has_two = !fields.typed_numbers("to").empty();
    add_vector(fields, "at", has_two ? std::vector{point_i} : std::vector{point_i, point_j}, false);
    add_vector(fields, "to", {point_j}, false);
    add_vector(fields, "point_i", {{&JointGeometry::P_i_local, Mat3::Identity()}}, false);
    add_vector(fields, "point_j", {{&JointGeometry::P_j_local, Mat3::Identity()}}, false);
    add_axes(fields, *read.type, to_i, to_j);
    add_scalar(fields, "length", &JointGeometry::length, 1.0);
    add_scalar(fields, "pitch", &JointGeometry::alpha, 1.0 / (2.0 * std::numbers::pi));
    add_scalar(fields, "advance_per_rad", &JointGeometry::alpha, 1.0);
}

void tell(const TypedVerdict& verdict, Fields& last, Problems& problems) {
    const std::string ranks =
        "the numbers of the joints as typed give rank " + std::to_string(verdict.rank_as_typed) + ", others ";
    const std::string meant = "rank " + std::to_string(verdict.rank);
    const std::string message = verdict.is_told ? ranks + "within " + short_number(verdict.share, 2) +
                                                      " of half a unit of their last digits give " + meant +
                                                      " and a motion of finite length; these are used"
                                                : ranks + "that differ in their last digits may give " +
                                                      meant + "; which of both is meant cannot be told";
    problems.warn(
        Code::typed_digits, last.span(), message,
        "give points and axes more digits; to keep the numbers as they are: [precision] exact = true");
}

}  // namespace

void read_precision(Fields& root, Lesson& lesson) {
    auto fields = root.table("precision");
    if (!fields) { return; }
    fields->at_most_one({"exact", "digits"});
    if (const auto exact = fields->flag("exact")) { lesson.precision.exact = exact->value; }
    if (const auto digits = fields->integer("digits", kFewestDigits, kMostDigits)) {
        lesson.precision.digits = digits->value;
    }
    fields->finish();
}

void take_as_meant(std::vector<Fields>& joints, Reading& reading) {
    Mechanism& mechanism = reading.lesson.mechanism;
    if (reading.lesson.precision.exact) { return; }
    RoundedNumbers numbers(reading);
    for (std::size_t k = 0; k < joints.size(); ++k) { numbers.add(joints[k], static_cast<int>(k)); }
    const auto meant = judge_typed_numbers(mechanism, numbers.all());
    if (!meant) { return; }
    mechanism.typed = meant->verdict;
    for (std::size_t k = 0; k < meant->geometry.size(); ++k) {
        mechanism.joints[k].geometry = meant->geometry[k];
    }
    if (meant->verdict.rank < meant->verdict.rank_as_typed) {
        tell(meant->verdict, joints.back(), *reading.problems);
    }
}

}  // namespace jw::reading
