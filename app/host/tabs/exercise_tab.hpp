#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/exercises/practice/practice.hpp"
#include "app/host/tabs/exercise_words.hpp"
#include "app/host/ui/ui.hpp"

namespace jw::host {

/// What the student does with a lesson that an exercise handed out.
struct ExerciseWork {
    std::filesystem::path file;            ///< the working copy; empty: there is none
    std::vector<std::string> experiments;  ///< carried out so far, as after 'jointwise try --try'
};

/// "Exercises": those of the lesson, or the one that is being solved.
class ExerciseTab {
public:
    void draw(const LessonUi& ui, const panels::Box& box, const Practice& practice, const ExerciseWork& work);
    /// Words of the tab in lines, for those who do not see it.
    std::string text(const Practice& practice, const ExerciseWork& work) const;

    /// Keys while nobody types: they choose in the list, and lead into the field for the answer; what numbers
    /// begin with begins the answer.
    /// @return whether the event was for the exercises
    bool act(const InputEvent& event, const Practice& practice, Requests& requests);

    /// Letters wait for the field to have the keyboard: for the next picture.
    bool is_handing_over() const { return !typed_.empty(); }

    /// Keeps what was typed for the exercise before, and goes on with what was typed for this one.
    void follow(const Practice& practice);
    /// The text in the field for the answer of the exercise begun.
    const std::string& answer() const { return answer_; }
    void set_answer(std::string text) { answer_ = std::move(text); }

private:
    bool act_on_letter(unsigned character, const Practice& practice, Requests& requests);
    void list(const LessonUi& ui, const Practice& practice);
    void row(const LessonUi& ui, const Practice& practice, int index);
    void task(const LessonUi& ui, const Practice& practice, const ExerciseWork& work);
    void head(const LessonUi& ui, const Practice& practice);
    void question(const LessonUi& ui, const Task& task);
    Caret hand_over_typed();
    void hand_in(Requests& requests);
    void answer_field(const LessonUi& ui, const Task& task, const ExerciseWork& work);
    void choices(const LessonUi& ui, const Task& task);
    void buttons(const LessonUi& ui, const Practice& practice);
    void verdict(const LessonUi& ui, const Practice& practice);
    void hints(const LessonUi& ui, const Practice& practice);
    void solution(const LessonUi& ui, const Practice& practice);

    /// What the student has been shown of the exercise begun: what is new comes into sight.
    struct Told {
        int verdicts = 0;
        int hints = 0;
        bool solution = false;

        bool operator==(const Told&) const = default;
    };
    void tell(const LessonUi& ui, const Practice& practice);

    Told told_;
    bool wants_top_ = false;  ///< another exercise, or other numbers: from the beginning
    int row_ = 0;             ///< chosen in the list
    bool wants_focus_ = false;
    std::u32string typed_;       ///< goes into the field once that has the keyboard
    bool took_letters_ = false;  ///< in this frame: into `typed_`
    bool has_caret_ = false;     ///< the field, where the letters go
    bool has_keyboard_ = false;  ///< the field, in the frame before
    bool wants_row_ = false;     ///< the chosen row comes into sight
    std::string answer_;
    std::string handed_in_;                      ///< the answer that was judged last
    std::string answers_;                        ///< key and variant that the answer belongs to
    std::map<std::string, std::string> drafts_;  ///< answers that were begun, by key and variant
};

}  // namespace jw::host
