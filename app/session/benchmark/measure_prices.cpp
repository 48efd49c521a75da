#include <stdexcept>

#include "app/session/benchmark/bench_job.hpp"

namespace jw {

void measure_prices(
    const Lesson& lesson, std::optional<Reference> reference, const BenchPlan& plan, const TellNews& tell,
    const std::stop_token& stop) {
    BenchJob::News news;
    try {
        if (!reference) { reference = own_reference(lesson, stop); }
        news.origin = reference->origin;
        tell(news);
        const auto seen = [&](const std::vector<BenchRun>& runs) {
            news.runs = runs;
            tell(news);
        };
        bench_dynamics(lesson, *reference, plan, {seen, stop});
    } catch (const std::exception& error) { news.failure = error.what(); }
    news.done = true;
    tell(news);
}

}  // namespace jw
