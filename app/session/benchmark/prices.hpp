#pragma once

#include <array>

#include "app/session/benchmark/benchmark.hpp"
#include "app/session/view/series.hpp"

/// Prices found by a benchmark: what one more digit costs, method by method, as plain values to be shown.
namespace jw {

/// Errors of position that people ask for [m].
inline constexpr std::array<double, 3> kErrorLevels{1e-3, 1e-6, 1e-9};
/// "1e-6 m"
std::string level_text(std::size_t level);

struct PriceRow {
    std::string name;  ///< of the method
    /// To each of the levels [ms]; nothing where it was not reached.
    std::array<std::optional<double>, kErrorLevels.size()> milliseconds;
    double finest = 0.0;  ///< least error of all its runs [m]; NaN where none reached the end
};

struct Prices {
    std::vector<PriceRow> rows;
    SeriesSet curves;     ///< CPU time over digits of position, one curve per row
    std::string summary;  ///< who is first to each level, and by how much
};

Prices prices_of(const std::vector<BenchRun>& runs);

/// CPU time over digits of position, one curve per method: the least time that reaches so many digits.
SeriesSet work_precision(const std::vector<BenchRun>& runs);

}  // namespace jw
