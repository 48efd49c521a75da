#include "core/poses/typed/meant_mechanism.hpp"
#include "lessons/fields/member_keys.hpp"
#include "lessons/format/scene_keys.hpp"
#include "lessons/precision/rounded_numbers.hpp"

/// Judges the accuracy of typed numbers by their digits: a short number is exact, a long one was rounded.
namespace jw::reading {

namespace {

void tell(
    const TypedVerdict& verdict, const Located<std::string>& short_of_digits, const SourceSpan& last,
    Problems& problems) {
    const std::string ranks =
        "the numbers as typed give rank " + std::to_string(verdict.rank_as_typed) + ", others ";
    const std::string meant = "rank " + std::to_string(verdict.rank);
    const std::string message = verdict.is_told
                                    ? ranks + "that differ by at most " + short_number(verdict.share, 2) +
                                          " half units of the last digit give " + meant +
                                          " and a motion of finite length; these are used"
                                    : ranks + "that differ in their last digits may give " + meant +
                                          "; it is not known which of both is meant";
    problems.warn(
        Code::typed_digits, short_of_digits.span.line > 0 ? short_of_digits.span : last, message,
        "give " + short_of_digits.value +
            " more digits; to keep the numbers as they are: [precision] exact = true");
}

}  // namespace

void read_precision(Fields& root, Lesson& lesson) {
    auto fields = root.table("precision");
    if (!fields) { return; }
    fields->at_most_one({"exact", "digits"});
    read_members(*fields, format::kPrecision, lesson.precision);
    fields->finish();
}

void take_as_meant(std::vector<Fields>& bodies, const std::vector<Fields>& joints, Reading& reading) {
    Mechanism& mechanism = reading.lesson.mechanism;
    if (reading.lesson.precision.exact) { return; }
    RoundedNumbers numbers(reading);
    numbers.add_joints(joints);
    numbers.add_poses(bodies, joints);
    const auto meant = judge_typed_numbers(mechanism, numbers.all());
    if (!meant) { return; }
    mechanism.typed = meant->verdict;
    for (std::size_t k = 0; k < meant->geometry.size(); ++k) {
        mechanism.joints[k].geometry = meant->geometry[k];
    }
    if (meant->verdict.rank == meant->verdict.rank_as_typed) { return; }
    const Located<std::string> short_of_digits = numbers.short_of_digits(meant->effects);
    if (short_of_digits.span.line > 0) { mechanism.typed->short_of_digits = short_of_digits.value; }
    tell(meant->verdict, short_of_digits, joints.back().span(), *reading.problems);
}

}  // namespace jw::reading
