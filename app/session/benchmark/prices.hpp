#pragma once

#include <array>

#include "app/session/benchmark/benchmark.hpp"
#include "app/session/view/series.hpp"

/// Results of a benchmark as plain values to be shown: the cost of one more digit, method by method.
namespace jw {

/// Errors of position at which methods are compared [m].
inline constexpr std::array<double, 3> kErrorLevels{1e-3, 1e-6, 1e-9};
/// Level as text, "1e-6 m".
std::string level_text(std::size_t level);

struct PriceRow {
    std::string name;  ///< of the method
    /// Time to reach each of the levels [ms]; nothing where it was not reached.
    std::array<std::optional<double>, kErrorLevels.size()> milliseconds;
    double finest = 0.0;  ///< smallest error of all its runs [m]; NaN if none reached the end
};

struct Prices {
    std::vector<PriceRow> rows;
    SeriesSet curves;     ///< CPU time over digits of position, one curve per row
    std::string summary;  ///< which method is first at each level, and by how much
};

Prices prices_of(const std::vector<BenchRun>& runs);

/// CPU time over digits of position, one curve per method: the shortest time that reaches this many digits.
SeriesSet work_precision(const std::vector<BenchRun>& runs);

}  // namespace jw
