#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/host/ui/ui.hpp"
#include "app/panels/plot/plot.hpp"
#include "app/session/benchmark/newton_runs.hpp"

namespace jw::host {

/// The tab "Newton": several methods or coordinates from the same start; the iterates of one as ghosts.
class NewtonTab {
public:
    void draw(const LessonUi& ui, const panels::Box& box);

    /// Iterates that the picture shows as ghosts. Empty while this tab is not shown, and if they do not
    /// belong to the telling `told`, which may have other bodies.
    std::span<const State> ghosts(std::uint64_t told) const {
        return told == key_.told ? std::span<const State>(ghosts_) : std::span<const State>();
    }
    void forget_ghosts() { ghosts_.clear(); }
    /// True if runs remain to be done, one per frame.
    bool is_comparing() const { return key_.start >= 0 && runs_.traces.size() < ways_of(key_.plan); }
    /// Grows with every change of ghosts().
    std::uint64_t version() const { return version_; }

private:
    enum class Compared { methods, coordinates };

    void controls(const LessonUi& ui);
    void compute(const Session& session, int start);
    void choose(int run);

    Compared compared_ = Compared::methods;
    NewtonMethod method_ = NewtonMethod::stepwise_limited;
    CoordinateChoice choice_ = CoordinateChoice::modified_euler_parameters;
    std::uint64_t choice_of_ = 0;  ///< telling that choice_ was taken from
    bool normalisation_ = true;
    int chosen_ = 0;

    struct Key {
        std::uint64_t told = 0;
        int start = -1;
        NewtonPlan plan;
        bool operator==(const Key&) const = default;
    };
    Key key_;
    NewtonRuns runs_;
    panels::PlotState plot_;
    std::vector<State> ghosts_;
    std::uint64_t version_ = 0;
};

}  // namespace jw::host
