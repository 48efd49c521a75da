#pragma once

#include <cstdint>
#include <memory>

#include "app/session/benchmark/benchmark.hpp"

/// A benchmark in the background.
namespace jw {

/// Measures one lesson at a time: in a thread, or, in a web page, in another copy of the program. When it is
/// destroyed, it stops at once, or at the next sample of the present run.
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
    /// @param reference  if there is none, it is computed from the lesson
    BenchJob(Lesson lesson, std::optional<Reference> reference, BenchPlan plan);
    ~BenchJob();
    BenchJob(const BenchJob&) = delete;
    BenchJob& operator=(const BenchJob&) = delete;

    /// Number that grows whenever there are new results.
    std::uint64_t version() const;
    News news() const;

private:
    struct Running;
    std::unique_ptr<Running> running_;
};

/// Callback that receives all results so far whenever there are new ones.
using TellNews = std::function<void(const BenchJob::News&)>;
/// Measures a lesson in this thread, and reports the results after every point. A failure is reported, too.
/// @throws Stopped if `stop` asks for it
void measure_prices(
    const Lesson& lesson, std::optional<Reference> reference, const BenchPlan& plan, const TellNews& tell,
    const std::stop_token& stop);

}  // namespace jw
