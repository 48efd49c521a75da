#pragma once

#include <cstdint>
#include <memory>

#include "app/session/benchmark/benchmark.hpp"

/// A benchmark beside whatever else goes on.
namespace jw {

/// Measures a lesson, one at a time: in a thread, or, in a page, in another copy of the program.
/// Destroyed, it stops at once, or at the next sample of the run under way.
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
    ~BenchJob();
    BenchJob(const BenchJob&) = delete;
    BenchJob& operator=(const BenchJob&) = delete;

    /// Grows with everything that is new.
    std::uint64_t version() const;
    News news() const;

private:
    struct Running;
    std::unique_ptr<Running> running_;
};

/// Receiver of the results known so far, whenever there are new ones.
using TellNews = std::function<void(const BenchJob::News&)>;
/// Measures a lesson here and now, and tells what is known after every point; a failure is news, too.
/// @throws Stopped if `stop` asks for it
void measure_prices(
    const Lesson& lesson, std::optional<Reference> reference, const BenchPlan& plan, const TellNews& tell,
    const std::stop_token& stop);

}  // namespace jw
