#pragma once

#include <cstdint>
#include <mutex>

#include "app/session/benchmark/benchmark.hpp"
#include "app/session/beside/worker.hpp"

/// A benchmark beside whatever else goes on.
namespace jw {

/// Measures a lesson by a `Worker`. Destroyed, it stops at the next sample of the run under way.
class BenchJob {
public:
    /// Results known so far.
    struct News {
        std::vector<BenchRun> runs;
        std::string origin;   ///< of the reference; empty while that is being computed
        std::string failure;  ///< why there are no runs
        bool done = false;
    };

    /// @param lesson     with a point whose path can be compared
    /// @param reference  nothing: the lesson computes its own
    BenchJob(Lesson lesson, std::optional<Reference> reference, BenchPlan plan);

    /// Grows with everything that is new.
    std::uint64_t version() const;
    News news() const;

private:
    template <class Change>
    void tell(const Change& change);
    void work(
        const Lesson& lesson, std::optional<Reference> reference, const BenchPlan& plan,
        const std::stop_token& stop);

    mutable std::mutex mutex_;
    News news_;
    std::uint64_t version_ = 0;
    Worker worker_;  ///< last: it ends before what it writes into
};

}  // namespace jw
