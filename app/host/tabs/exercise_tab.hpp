#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/exercises/kinds.hpp"
#include "app/exercises/practice/practice.hpp"
#include "app/host/ui/ui.hpp"
#include "core/numerics/linear.hpp"
#include "lessons/exercise/handed_in.hpp"

struct ImFont;

namespace jw::host {

/// Wrapped text with formulas between dollar signs. A formula that is wider than the column can be scrolled.
void rich_words(const Ui& ui, const std::string& text, const ImFont* font, const render::Colour& colour);

/// A matrix in brackets whose marked entries are highlighted.
void marked_matrix(const Ui& ui, const MatrixX& value, const std::vector<std::vector<bool>>& marked);

/// Place in a field for the letters that are typed next.
enum class Caret {
    stays,
    at_end,
    over_all,  ///< they replace the text
};

/// A field for text of any length. Escape leaves the field and keeps the text.
/// @param lines  height; in a field of 1 line, Enter enters the text
/// @param enter  in a higher field: true if Enter enters the text and Ctrl+Enter breaks the line, false if
///               the other way round
/// @return true if the text was entered
bool text_field(
    const Ui& ui, const char* id, const char* hint, std::string& text, int lines = 1, bool enter = true,
    Caret caret = Caret::stays);

/// Lines of text without wrapping, in a box that scrolls in both directions.
void text_box(const Ui& ui, const char* id, const std::string& text, int most_lines);

/// Puts the next button beside the last item if it fits there; else on a new line.
void next_button(const char* label);

/// The student's work on a lesson that an exercise has handed out.
struct ExerciseWork {
    std::filesystem::path file;            ///< the working copy; empty: there is none
    std::vector<std::string> experiments;  ///< carried out so far, as for 'jointwise try --try'
};

/// The tab "Exercises": the exercises of the lesson, or the one that is being solved.
class ExerciseTab {
public:
    void draw(const LessonUi& ui, const panels::Box& box, const Practice& practice, const ExerciseWork& work);
    /// The tab as lines of text, for people who cannot see it.
    std::string text(const Practice& practice, const ExerciseWork& work) const;

    /// Handles keys while no field has the keyboard: they select in the list, and move to the answer field. A
    /// character that can begin a number begins the answer.
    /// @return whether the event was for the exercises
    bool act(const InputEvent& event, const Practice& practice, Requests& requests);

    /// True if letters wait until the field has the keyboard, in one of the next frames.
    bool is_handing_over() const { return !typed_.empty(); }

    /// Keeps the answer typed for the previous exercise, and restores the one typed for this exercise.
    void follow(const Practice& practice);
    /// The text in the answer field of the current exercise.
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

    /// Parts of the current exercise that the student has been shown. New parts are scrolled into view.
    struct Told {
        int verdicts = 0;
        int hints = 0;
        bool solution = false;

        bool operator==(const Told&) const = default;
    };
    void tell(const LessonUi& ui, const Practice& practice);

    Told told_;
    bool wants_top_ = false;  ///< scroll to the top: another exercise, or other numbers
    int row_ = 0;             ///< selected in the list
    bool wants_focus_ = false;
    std::u32string typed_;       ///< goes into the field when the field has the keyboard
    bool took_letters_ = false;  ///< `typed_` grew in this frame
    bool has_caret_ = false;     ///< the field's caret is where the letters go
    bool has_keyboard_ = false;  ///< the field had it in the previous frame
    bool wants_row_ = false;     ///< scroll to the selected row
    std::string answer_;
    std::string handed_in_;                      ///< the answer that was judged last
    std::string answers_;                        ///< key and variant that the answer belongs to
    std::map<std::string, std::string> drafts_;  ///< unfinished answers, by key and variant
};

/// "a number   ·   2 points   ·   solved 3 times, the last 2 in a row"
std::string facts_of(const Exercise& exercise, const ExerciseRecord& record);
/// Slides, and whether the program may be used.
std::string what_is_allowed(const Exercise& exercise);
/// Names of the inputs of a program.
std::string inputs_of_program(const Exercise& exercise);
/// How to answer in the program, where this differs from paper, and the unit.
std::string how_to_answer(const Task& task);
/// "Right.", "Not correct: wrong sign."
std::string title_of(const Judged& judged);

/// True if the answer is a lesson file.
bool is_file(ExerciseKind kind);
/// True if the answer is typed into the field and consists only of numbers.
bool is_of_numbers(ExerciseKind kind);

}  // namespace jw::host
