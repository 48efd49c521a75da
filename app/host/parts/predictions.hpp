#pragma once

#include <array>
#include <map>
#include <string>

#include "app/host/parts/pointed.hpp"
#include "app/host/ui/ui.hpp"
#include "app/session/answers/judged_answer.hpp"

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

    /// Where a thing is asked for, a click on one is the answer; a drag is none.
    /// @param reachable  nothing lies over what is pointed at
    void follow_mouse(const LessonUi& ui, const Pointed& pointed, bool reachable);

    /// What was answered to a question of the open lesson; nullptr if nothing was.
    const GivenAnswer* given(int question) const;
    /// Why the last attempt at the question that is asked was no answer; empty if it was, or there was none.
    const std::string& objection() const { return objection_; }

private:
    static bool is_shown(const Session& session);
    void field(const LessonUi& ui, const QuestionView& question, const Step& step);
    void ask(const LessonUi& ui, const panels::Box& scene, const Step& step);
    void click(const LessonUi& ui, const std::array<Pointable, 4>& places);
    void take(const LessonUi& ui, const Step& step, const std::string& text);
    void compare(const LessonUi& ui, const panels::Box& scene, const Step& step) const;

    std::string lesson_;  ///< title of the lesson that they belong to
    std::map<int, GivenAnswer> given_;
    std::array<char, 256> field_{};  ///< seven numbers with all digits fit
    std::string objection_;          ///< why what was typed or clicked is no answer
    int asked_ = -1;                 ///< question of the step that was drawn last
    bool wants_focus_ = false;
    std::array<Pointable, 4> pressed_{};  ///< what the mouse went down on
};

}  // namespace jw::host
