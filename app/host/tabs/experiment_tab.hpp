#pragma once

#include "app/host/ui/ui.hpp"

/// The tab "Try it": everything in the lesson that can be changed, and the effect on rank and freedoms.
namespace jw::host {

void experiment_tab(const LessonUi& ui, const panels::Box& box);

/// The joint that "Try it" is about: the chosen one, else that of the step, else the first; -1 if there is
/// none.
int experiment_joint_of(const LessonUi& ui);

/// Points, axes and equations of one joint.
void experiment_joint(const LessonUi& ui, int joint);

/// Values of drivers, and time.
void experiment_drivers(const LessonUi& ui);

}  // namespace jw::host
