#pragma once

#include <array>
#include <map>
#include <string>

#include "app/host/ui/ui.hpp"

/// Answers to the questions of a lesson: given before the step, compared after it.
namespace jw::host {

class Predictions {
public:
    /// The keyboard goes to the field for the answer, if a question is asked here.
    void focus() { wants_focus_ = true; }
    /// Height that `draw` covers at the foot of `scene`; 0 where nothing is asked or answered.
    float height(const LessonUi& ui, const panels::Box& scene) const;
    /// At the foot of `scene`: choices or a field at a question, what was said at its answer.
    void draw(const LessonUi& ui, const panels::Box& scene);

    /// What was answered to a question of the open lesson; nullptr if nothing was.
    const GivenAnswer* given(int question) const;

private:
    void ask(const LessonUi& ui, const panels::Box& scene, const Step& step);
    void take(const LessonUi& ui, const Step& step, const std::string& text);
    void compare(const LessonUi& ui, const panels::Box& scene, const Step& step) const;

    std::string lesson_;  ///< title of the lesson that they belong to
    std::map<int, GivenAnswer> given_;
    std::array<char, 64> field_{};
    std::string objection_;  ///< why what was typed is no answer
    bool wants_focus_ = false;
};

}  // namespace jw::host
