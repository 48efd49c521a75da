#include "app/session/benchmark/bench_job.hpp"

#include <stdexcept>

namespace jw {

BenchJob::BenchJob(Lesson lesson, std::optional<Reference> reference, BenchPlan plan)
    : worker_([this, lesson = std::move(lesson), reference = std::move(reference), plan = std::move(plan)](
                  const std::stop_token& stop) mutable { work(lesson, std::move(reference), plan, stop); }) {}

std::uint64_t BenchJob::version() const {
    const std::scoped_lock lock(mutex_);
    return version_;
}

BenchJob::News BenchJob::news() const {
    const std::scoped_lock lock(mutex_);
    return news_;
}

template <class Change>
void BenchJob::tell(const Change& change) {
    const std::scoped_lock lock(mutex_);
    change(news_);
    ++version_;
}

void BenchJob::work(
    const Lesson& lesson, std::optional<Reference> reference, const BenchPlan& plan,
    const std::stop_token& stop) {
    try {
        if (!reference) { reference = own_reference(lesson, stop); }
        tell([&](News& news) { news.origin = reference->origin; });
        const auto seen = [this](const std::vector<BenchRun>& runs) {
            tell([&](News& news) { news.runs = runs; });
        };
        bench_dynamics(lesson, *reference, plan, {seen, stop});
    } catch (const Stopped&) { return; } catch (const std::exception& error) {
        tell([&](News& news) { news.failure = error.what(); });
    }
    tell([](News& news) { news.done = true; });
}

}  // namespace jw
