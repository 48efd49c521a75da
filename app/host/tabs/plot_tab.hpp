#pragma once

#include <array>
#include <optional>

#include "app/host/ui/ui.hpp"
#include "app/panels/plot/plot.hpp"
#include "app/session/view/series.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw::host {

/// The tab "Plots": series of the story over time or over iterations, with a cursor at the current step.
class PlotTab {
public:
    void draw(const LessonUi& ui, const panels::Box& box);
    /// The shown curves as CSV.
    std::string csv(const Session& session);
    /// Part of a file name: "quantities".
    const char* name() const;

private:
    enum class Topic { quantities, residuals, singular_values, conditions };
    static constexpr std::array kTopics{
        EnumWord<Topic>{Topic::quantities, "quantities", tr_later("Quantities over time")},
        EnumWord<Topic>{Topic::residuals, "residuals", tr_later("‖Φ‖ over all iterations")},
        EnumWord<Topic>{Topic::singular_values, "singular-values", tr_later("Singular values over time")},
        EnumWord<Topic>{Topic::conditions, "conditions", tr_later("Condition of the pairs over time")}};

    const SeriesSet& set(const Session& session, int joint);
    void controls(const LessonUi& ui, const SeriesSet& shown);
    void choose_curves(const SeriesSet& shown);
    void handle(const LessonUi& ui, const panels::PlotLayout& layout, const SeriesSet& shown);
    panels::PlotState& state() { return states_[static_cast<std::size_t>(topic_)]; }

    Topic topic_ = Topic::quantities;
    int joint_ = -1;  ///< of the conditions
    std::uint64_t told_ = 0;
    std::array<std::optional<SeriesSet>, kTopics.size()> sets_;
    std::array<panels::PlotState, kTopics.size()> states_;
};

}  // namespace jw::host
