#pragma once

#include "app/host/ui/ui.hpp"
#include "app/session/story/timeline.hpp"

/// The bar at the bottom: play, step, speed, and the whole lesson as one line to jump and scrub on.
namespace jw::host {

/// Places of the stretches on a line. A motion may have hundreds of steps and a joint only five, so each
/// stretch gets room for its name and a share of the rest.
class TimelineScale {
public:
    TimelineScale(const std::vector<Stretch>& stretches, float left, float width);
    float x_of(int step) const;
    int step_at(float x) const;
    float left_of(std::size_t stretch) const { return edges_[stretch]; }
    float right_of(std::size_t stretch) const { return edges_[stretch + 1]; }

private:
    const std::vector<Stretch>* stretches_;
    std::vector<float> edges_;
};

void timeline_bar(const LessonUi& ui, const panels::FrameLayout& layout);

/// The bar for a figure, without the line: it says at which step the lesson waits.
void bar_of_figure(const LessonUi& ui, const panels::FrameLayout& layout);

}  // namespace jw::host
