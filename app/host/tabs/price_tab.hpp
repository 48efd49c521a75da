#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/host/ui/ui.hpp"
#include "app/panels/plot/plot.hpp"
#include "app/session/benchmark/bench_job.hpp"
#include "app/session/benchmark/prices.hpp"

namespace jw::host {

/// The tab "Cost": time against error of each method for this lesson, measured on this machine while the
/// window keeps running.
class PriceTab {
public:
    PriceTab() = default;
    /// @param lesson_file  its stored reference is used while the lesson is unchanged
    explicit PriceTab(std::filesystem::path lesson_file) : lesson_file_(std::move(lesson_file)) {}

    void draw(const LessonUi& ui, const panels::Box& box);
    /// True while a measurement runs: it brings new results without an event.
    bool is_measuring() const { return job_ && !news_.done; }

private:
    void controls(const LessonUi& ui);
    void begin(const Session& session);
    /// Discards the measured results, and stops a measurement that is still running.
    void forget();
    void look_at_news();

    std::filesystem::path lesson_file_;
    Treatment treatment_ = Treatment::projection;
    std::uint64_t told_ = 0;  ///< telling that is measured: another one means another lesson
    std::unique_ptr<BenchJob> job_;
    std::uint64_t seen_ = 0;
    BenchJob::News news_;
    std::optional<Prices> prices_;
    panels::PlotState plot_;
};

}  // namespace jw::host
