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

/// "Price": what a digit of this lesson costs, method by method, measured here and now while the window goes
/// on.
class PriceTab {
public:
    PriceTab() = default;
    /// @param lesson_file  its stored reference is used as long as the lesson is as the file has it
    explicit PriceTab(std::filesystem::path lesson_file) : lesson_file_(std::move(lesson_file)) {}

    void draw(const LessonUi& ui, const panels::Box& box);
    /// True while a measurement runs, so that something new will come without an event.
    bool is_measuring() const { return job_ && !news_.done; }

private:
    void controls(const LessonUi& ui);
    void begin(const Session& session);
    /// Drops what was measured, and what is still being measured.
    void forget();
    void look_at_news();

    std::filesystem::path lesson_file_;
    Treatment treatment_ = Treatment::projection;
    std::uint64_t told_ = 0;  ///< telling that is measured: another one is another lesson
    std::unique_ptr<BenchJob> job_;
    std::uint64_t seen_ = 0;
    BenchJob::News news_;
    std::optional<Prices> prices_;
    panels::PlotState plot_;
};

}  // namespace jw::host
