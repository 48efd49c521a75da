#include <algorithm>
#include <cmath>

#include "lessons/format/motion_keys.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/read/scalar_formula.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::reading {

namespace {

// more coefficients or parts than this are data, not a lesson
constexpr std::size_t kMostParts = 100;
// a shorter step, or less time between two values, has unrealistic accelerations [s]
constexpr double kShortestStep = 1e-6;
// number of times at which values are checked
constexpr int kMomentsLookedAt = 200;

/// Keys of a function's values: plain for a length, "_deg" or "_rad" for an angle.
struct ValueKeys {
    bool angle = false;

    std::string name(const std::string& key) const { return angle ? key + "_deg" : key; }
    /// The name that stands in the table; the usual one if there is none.
    std::string name_in(Fields& fields, const std::string& key) const {
        return angle && fields.has(key + "_rad") ? key + "_rad" : name(key);
    }
    IfGiven<double> number(Fields& fields, const std::string& key) const {
        return angle ? fields.angle(key) : fields.number(key);
    }
    void require(Fields& fields, const std::string& key, const char* expected) const {
        fields.require(name_in(fields, key), expected);
    }
};

/// A list of values; for angles in radians.
IfGiven<std::vector<double>> read_values(
    Fields& fields, const ValueKeys& keys, const std::string& key, int most) {
    const auto count = static_cast<std::size_t>(most);
    if (!keys.angle) { return fields.numbers(key, 0, count); }
    if (!fields.at_most_one({key + "_deg", key + "_rad"})) { return std::nullopt; }
    if (auto list = fields.numbers(key + "_rad", 0, count)) { return list; }
    auto list = fields.numbers(key + "_deg", 0, count);
    if (list) { std::ranges::transform(list->value, list->value.begin(), radians); }
    return list;
}

void read_polynomial(Fields& fields, const ValueKeys& keys, TimeFunction& function) {
    const auto list = read_values(fields, keys, "polynomial", format::kMostCoefficients);
    if (list) { function.polynomial = list->value; }
}

void read_harmonic(Fields& fields, const ValueKeys& keys, TimeFunction& function) {
    TimeFunction::Harmonic harmonic;
    fields.call("the harmonic");
    keys.require(fields, "amplitude", "the size of the swing");
    if (const auto amplitude = keys.number(fields, "amplitude")) { harmonic.amplitude = amplitude->value; }
    const auto frequency = fields.number("frequency_hz");
    const auto omega = fields.number("omega_rad_per_s");
    fields.at_most_one({"frequency_hz", "omega_rad_per_s"});
    if (!fields.has("omega_rad_per_s")) { fields.require("frequency_hz", "its oscillations per second"); }
    if (const auto phase = fields.angle("phase")) { harmonic.phase = phase->value; }
    fields.finish();
    if (frequency) { harmonic.omega = omega_of_frequency(frequency->value); }
    if (omega) { harmonic.omega = omega->value; }
    function.harmonics.push_back(harmonic);
}

void read_step(Fields& fields, const ValueKeys& keys, TimeFunction& function) {
    TimeFunction::SmoothStep step;
    fields.call("the step");
    keys.require(fields, "to", "the value at which it ends");
    fields.require("end_s", "the time at which it ends");
    if (const auto from = keys.number(fields, "from")) { step.from = from->value; }
    if (const auto to = keys.number(fields, "to")) { step.to = to->value; }
    if (const auto start = fields.number("start_s")) { step.start = start->value; }
    const auto end = fields.number("end_s");
    fields.finish();
    if (!end) { return; }
    step.end = end->value;
    if (step.end - step.start < kShortestStep) {
        const int digits = writing::digits_apart(step.end, step.start, 6);
        fields.report(
            Code::ends_before_start, end->span,
            "the step ends at " + short_number(step.end, digits) + " s and starts at " +
                short_number(step.start, digits) + " s; expected 'end_s' at least 1e-6 s after 'start_s'");
        return;
    }
    function.steps.push_back(step);
}

/// Reports the first time that does not come after the one before it.
bool are_increasing(Fields& fields, const Located<std::vector<double>>& times) {
    for (std::size_t k = 1; k < times.value.size(); ++k) {
        const double before = times.value[k - 1];
        const double t = times.value[k];
        if (t - before >= kShortestStep) { continue; }
        const int digits = writing::digits_apart(t, before, 6);
        fields.report(
            Code::table_times, times.span,
            "in 'times_s', " + short_number(t, digits) + " s follows " + short_number(before, digits) +
                " s; expected each time at least 1e-6 s after the one before");
        return false;
    }
    return true;
}

void read_table(Fields& fields, const ValueKeys& keys, TimeFunction& function) {
    fields.call("the table");
    fields.require("times_s");
    keys.require(fields, "values", "one value for each time");
    const auto times = fields.numbers("times_s", 0, format::kMostTimes);
    const auto values = read_values(fields, keys, "values", format::kMostTimes);
    const auto interpolation = fields.word("interpolation", kInterpolations);
    fields.finish();
    if (!times || !values || !are_increasing(fields, *times)) { return; }
    if (times->value.size() < 2 || times->value.size() != values->value.size()) {
        fields.report(
            Code::wrong_count, values->span,
            "the table has " + std::to_string(times->value.size()) + " times and " +
                std::to_string(values->value.size()) +
                " values; expected at least two times, with a value each");
        return;
    }
    function.table =
        table_through(times->value, values->value, interpolation.value_or(TimeTable::Interpolation::smooth));
}

/// Reports a table that begins after `from` or ends before `to`.
bool covers(Fields& fields, const TimeTable& table, double from, double to) {
    const double first = table.times.front();
    const double last = table.times.back();
    // possible error of a typed time that was rounded
    const double rounding = 1e-9 * std::max({1.0, std::abs(from), std::abs(to)});
    if (first <= from + rounding && last >= to - rounding) { return true; }
    const auto both = [](double asked, double given) {
        const int digits = writing::digits_apart(asked, given, 6);
        return std::pair(short_number(asked, digits) + " s", short_number(given, digits) + " s");
    };
    const auto [begin, first_text] = both(from, first);
    const auto [end, last_text] = both(to, last);
    fields.report(
        Code::table_times, fields.span(),
        "the table of " + fields.what() + " has values from " + first_text + " to " + last_text +
            "; expected values from " + begin + " to " + end + ", the times of the motion");
    return false;
}

std::optional<TimeFormula> read_time_formula(Fields& fields, const ValueKeys& keys) {
    if (keys.angle && !fields.at_most_one({"formula_deg", "formula_rad"})) { return std::nullopt; }
    const std::string key = keys.name_in(fields, "formula");
    auto formula = read_scalar_formula(
        fields, key, formula::time_only(), "numbers and the time t, in s, such as 0.2 \\sin(3 t)");
    if (!formula) { return std::nullopt; }
    return TimeFormula{std::move(*formula), key == "formula_deg" ? radians(1.0) : 1.0};
}

/// Reports a formula without a value, a rate or an acceleration between two times.
bool exists(Fields& fields, const TimeFormula& formula, const ValueKeys& keys, double from, double to) {
    const std::optional<double> gap = formula.gap_between(from, to);
    if (!gap) { return true; }
    fields.report(
        Code::unreadable_formula, fields.span(keys.name_in(fields, "formula")),
        "the formula of " + fields.what() +
            " has no value, rate or acceleration at t = " + short_number(*gap) +
            " s; expected a smooth formula from " + short_number(from) + " to " + short_number(to) + " s");
    return false;
}

}  // namespace

std::optional<ScalarFormula> read_formula(
    Fields& fields, const std::string& key, const FormulaReader& read, const char* made_of) {
    const auto source = fields.formula(key);
    if (!source) { return std::nullopt; }
    try {
        return read(source->value);
    } catch (const formula::NotEvaluated& failed) {
        const auto& [at, message, hint] = failed.problem();
        fields.report(
            Code::unreadable_formula, fields.place_in(key, at), message,
            hint.empty() || hint.starts_with("docs/") ? std::string("write it of ") + made_of : hint);
    }
    return std::nullopt;
}

std::optional<ScalarFormula> read_scalar_formula(
    Fields& fields, const std::string& key, std::span<const formula::Variable> variables,
    const char* made_of) {
    const auto read = [&](const std::string& source) { return formula::scalar_formula(source, variables); };
    return read_formula(fields, key, read, made_of);
}

TimeFunction read_time_function(Fields& fields, bool angle) {
    const ValueKeys keys{angle};
    TimeFunction function;
    read_polynomial(fields, keys, function);
    for (Fields& harmonic : fields.tables("harmonics", kMostParts)) {
        read_harmonic(harmonic, keys, function);
    }
    for (Fields& step : fields.tables("step", kMostParts)) { read_step(step, keys, function); }
    if (auto table = fields.table("table")) { read_table(*table, keys, function); }
    function.formula = read_time_formula(fields, keys);
    if (!has_time_function(fields, angle)) {
        fields.missing(
            keys.name("polynomial"), "a function of time: " + keys.name("polynomial") +
                                         ", harmonics, step, table or " + keys.name("formula"));
    }
    return function;
}

bool has_time_function(Fields& fields, bool angle) {
    const ValueKeys keys{angle};
    const auto has = [&](const char* key) { return fields.has(keys.name_in(fields, key)); };
    return has("polynomial") || has("formula") || fields.has("harmonics") || fields.has("step") ||
           fields.has("table");
}

void check_values(Fields& fields, const TimeFunction& function, double from, double to, bool never_negative) {
    if (function.table && !covers(fields, *function.table, from, to)) { return; }
    const ValueKeys keys{function.formula && !fields.has("formula")};
    if (function.formula && !exists(fields, *function.formula, keys, from, to)) { return; }
    for (int k = 0; k <= kMomentsLookedAt; ++k) {
        const double t = from + (to - from) * k / kMomentsLookedAt;
        const TimeFunction::Value value = function.at(t);
        const bool finite =
            std::isfinite(value.f) && std::isfinite(value.f_dot) && std::isfinite(value.f_ddot);
        const int digits = writing::digits_apart(std::abs(value.f), kLargestNumber, 6);
        const std::string place = fields.what() + " reaches " + short_number(value.f, digits) +
                                  " at t = " + short_number(t) + " s; expected ";
        if (!finite || std::abs(value.f) > kLargestNumber) {
            fields.report(Code::beyond_all_values, fields.span(), place + "at most 1e9 in magnitude");
            return;
        }
        if (never_negative && value.f < 0.0) {
            fields.report(
                Code::beyond_all_values, fields.span(), place + "a distance, which is never negative");
            return;
        }
    }
}

std::optional<double> read_angular_rate(
    Fields& fields, const std::string& key, IfGiven<double> (Fields::*read)(std::string_view)) {
    const std::string in_degrees = key + "_deg_per_s";
    const std::string in_radians = key + "_rad_per_s";
    if (!fields.at_most_one({in_degrees, in_radians})) { return std::nullopt; }
    if (const auto rate = (fields.*read)(in_radians)) { return rate->value; }
    if (const auto rate = (fields.*read)(in_degrees)) { return radians(rate->value); }
    return std::nullopt;
}

}  // namespace jw::reading
