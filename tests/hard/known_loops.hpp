#pragma once

#include <algorithm>
#include <array>

#include "tests/hard/variants.hpp"

/// Loops that move although counting says no, and verdicts on them, ours and the naive one's.
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
    int naive_right = 0;
    int least_dof = 1000;
    double least_margin = 1e300;

    void add(const KnownLoop& loop, const RankReport& report) {
        right += report.rank == loop.rank ? 1 : 0;
        least_dof = std::min(least_dof, report.dof);
        least_margin = std::min(least_margin, report.largest_gap);
    }
    void add_naive(const KnownLoop& loop, int rank) { naive_right += rank == loop.rank ? 1 : 0; }
};

/// Largest change of singular values, relative to the largest of them.
inline double relative_change(const VectorX& now, const VectorX& before) {
    return (now - before).cwiseAbs().maxCoeff() / before(0);
}

}  // namespace jw::hard
