#pragma once

#include <array>
#include <map>
#include <string>

#include "app/host/parts/pointed.hpp"
#include "app/host/ui/ui.hpp"
#include "app/session/answers/right_answer.hpp"

/// Answers to the questions of a lesson: given before the step, compared after it.
namespace jw::host {

class Predictions {
public:
    /// Gives the keyboard to the answer field, if a question is asked here.
    void focus() { wants_focus_ = true; }
    /// Height that `draw` covers at the foot of `scene`; 0 if nothing is asked or answered.
    float height(const LessonUi& ui, const panels::Box& scene) const;
    /// Draws at the foot of `scene`: at a question, choices or a field; at its answer, the given answer.
    void draw(const LessonUi& ui, const panels::Box& scene);

    /// If a question asks for an object, a click on an object is the answer; a drag is not.
    /// @param reachable  nothing covers the object under the pointer
    void follow_mouse(const LessonUi& ui, const Pointed& pointed, bool reachable);

    /// The answer given to a question of the open lesson; nullptr if there is none.
    const GivenAnswer* given(int question) const;
    /// Why the last input at the current question is not an answer; empty if it is one, or without input.
    const std::string& objection() const { return objection_; }

private:
    static bool is_shown(const Session& session);
    void field(const LessonUi& ui, const QuestionView& question, const Step& step);
    void ask(const LessonUi& ui, const panels::Box& scene, const Step& step);
    void click(const LessonUi& ui, const std::array<Pointable, 4>& places);
    void take(const LessonUi& ui, const Step& step, const std::string& text);
    void compare(const LessonUi& ui, const panels::Box& scene, const Step& step) const;

    std::string lesson_;  ///< title of the lesson that the answers belong to
    std::map<int, GivenAnswer> given_;
    std::array<char, 256> field_{};  ///< room for seven numbers with all digits
    std::string objection_;          ///< why the last input is not an answer
    int asked_ = -1;                 ///< question of the step that was drawn last
    bool wants_focus_ = false;
    std::array<Pointable, 4> pressed_{};  ///< objects on which the button went down
};

}  // namespace jw::host
