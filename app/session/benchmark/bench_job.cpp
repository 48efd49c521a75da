#include "app/session/benchmark/bench_job.hpp"

#include <mutex>
#include <utility>

#include "app/session/background/worker.hpp"

namespace jw {

struct BenchJob::Running {
    Running(Lesson lesson, std::optional<Reference> reference, BenchPlan plan)
        : worker([this, lesson = std::move(lesson), reference = std::move(reference),
                  plan = std::move(plan)](const std::stop_token& stop) mutable {
              try {
                  measure_prices(
                      lesson, std::move(reference), plan, [this](const News& told) { take(told); }, stop);
              } catch (const Stopped&) {}  // nobody waits for the result
              return false;
          }) {}

    void take(const News& told) {
        const std::scoped_lock lock(mutex);
        news = told;
        ++version;
    }

    std::mutex mutex;
    News news;
    std::uint64_t version = 0;
    Worker worker;  ///< last member: it ends before the members that it writes to are destroyed
};

BenchJob::BenchJob(Lesson lesson, std::optional<Reference> reference, BenchPlan plan)
    : running_(std::make_unique<Running>(std::move(lesson), std::move(reference), std::move(plan))) {}

BenchJob::~BenchJob() = default;

std::uint64_t BenchJob::version() const {
    const std::scoped_lock lock(running_->mutex);
    return running_->version;
}

BenchJob::News BenchJob::news() const {
    const std::scoped_lock lock(running_->mutex);
    return running_->news;
}

}  // namespace jw
