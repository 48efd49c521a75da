#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The hard cases: mechanisms on which a naive method fails. The naive method is run, not only described, and
/// so is Jointwise. Every case is also a test: its numbers have bounds.
namespace jw::hard {

/// Limits of a number; without limits it is only shown.
struct Bounds {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();

    bool hold(double value) const { return value >= least && value <= most; }  // not for NaN
};
inline Bounds any() { return {}; }
inline Bounds at_most(double most) { return {-std::numeric_limits<double>::infinity(), most}; }
inline Bounds at_least(double least) { return {least, std::numeric_limits<double>::infinity()}; }
inline Bounds exactly(double value) { return {value, value}; }

struct Bounded {
    double value = 0.0;
    Bounds bounds;
};

/// One line of a case: the same quantity from both methods, or from one of them.
struct Measurement {
    std::string what;  ///< with its unit
    std::optional<Bounded> naive;
    std::optional<Bounded> ours;
};
inline Measurement of_both(std::string what, double naive, Bounds its, double ours, Bounds ours_bounds) {
    return {std::move(what), Bounded{naive, its}, Bounded{ours, ours_bounds}};
}
inline Measurement of_naive(std::string what, double value, Bounds bounds = any()) {
    return {std::move(what), Bounded{value, bounds}, {}};
}
inline Measurement of_ours(std::string what, double value, Bounds bounds = any()) {
    return {std::move(what), {}, Bounded{value, bounds}};
}

struct Result {
    std::string naive;  ///< what the naive method did, one or two sentences
    std::string ours;
    std::vector<Measurement> measurements;
};

struct Case {
    std::string_view name;  ///< on the command line: lower case and hyphens
    std::string_view title;
    std::string_view hard;          ///< what is hard about it, one or two sentences
    std::string_view naive_method;  ///< method that is run as the naive one
    std::string_view our_method;
    std::string_view lesson;  ///< lesson that shows the case, below lessons/catalogue
    Result (*run)();
};

/// All cases, in the order of the page.
std::span<const Case> cases();

/// Bounds that do not hold, one sentence each; empty if all do.
std::vector<std::string> broken_bounds(const Result& result);

}  // namespace jw::hard
