#pragma once

#include <algorithm>
#include <array>

#include "app/hard/variants.hpp"

/// Loops that move although counting says no, and verdicts on them.
namespace jw::hard {

struct KnownLoop {
    const char* lesson;
    int rank;  ///< known: one freedom each
};
inline constexpr std::array kKnownLoops{
    KnownLoop{"loops/bennett.toml", 17}, KnownLoop{"loops/bricard.toml", 29},
    KnownLoop{"loops/four-bar.toml", 17}, KnownLoop{"loops/double-scott-russell.toml", 35}};

struct Verdicts {
    int right = 0;
    int least_dof = 1000;
    double least_margin = 1e300;

    void add(const KnownLoop& loop, const RankReport& report) {
        right += report.rank == loop.rank ? 1 : 0;
        least_dof = std::min(least_dof, report.dof);
        least_margin = std::min(least_margin, report.largest_gap);
    }
};

}  // namespace jw::hard
