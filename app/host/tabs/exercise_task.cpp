#include <algorithm>
#include <utility>

#include <imgui.h>

#include "app/exercises/figure_scene.hpp"
#include "app/exercises/value_latex.hpp"
#include "app/host/tabs/exercise_tab.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"

namespace jw::host {

namespace {

namespace theme = panels::theme;

constexpr int kLinesOfMatrix = 4;
constexpr int kLinesOfFile = 14;

const char* hint_of_field(ExerciseKind kind) {
    switch (kind) {
        case ExerciseKind::number: return "0.5236, 1/3, sqrt(3)/2";
        case ExerciseKind::vector: return "[1, 2, 3]";
        case ExerciseKind::choose: return tr("its number");
        case ExerciseKind::order: return "3, 1, 2";
        case ExerciseKind::code: return tr("file of the program");
        default: return "";
    }
}

void bold_words(const LessonUi& ui, const std::string& text, const render::Colour& colour) {
    rich_words(ui, text, ui.canvas.fonts().bold, colour);
}

/// Text of an author, with formulas.
void author_words(const LessonUi& ui, const std::string& text) {
    rich_words(ui, panels::typeset(panels::run_on(text)), ui.canvas.fonts().normal, theme::kInk);
}

/// Scrolls to the content drawn below `top`; to `top` itself if the content is higher than the column.
void bring_into_sight(const LessonUi& ui, float top) {
    const float height = ImGui::GetWindowHeight() - ui.px(8.0F);
    const float bottom = ImGui::GetCursorPosY();
    const float seen = ImGui::GetScrollY();
    if (top >= seen && bottom <= seen + height) { return; }
    ImGui::SetScrollY(std::max(0.0F, std::min(top, bottom - height)));
}

}  // namespace

void ExerciseTab::task(const LessonUi& ui, const Practice& practice, const ExerciseWork& work) {
    head(ui, practice);
    const Task* const task = practice.task();
    if (task == nullptr) { return note(ui, practice.doing()); }
    if (!task->problem.empty()) {
        return note(ui, tr("This exercise cannot be set with these numbers: {0}", task->problem));
    }
    question(ui, *task);
    answer_field(ui, *task, work);
    buttons(ui, practice);
    tell(ui, practice);
}

/// Shows verdict, hints and solution, and scrolls to the last of them that is new.
void ExerciseTab::tell(const LessonUi& ui, const Practice& practice) {
    const Told now{practice.verdicts_given(), practice.hints_given(), practice.shows_solution()};
    const float at_verdict = ImGui::GetCursorPosY();
    verdict(ui, practice);
    if (now.verdicts != told_.verdicts) { bring_into_sight(ui, at_verdict); }
    const float at_hints = ImGui::GetCursorPosY();
    hints(ui, practice);
    if (now.hints > told_.hints) { bring_into_sight(ui, at_hints); }
    const float at_solution = ImGui::GetCursorPosY();
    solution(ui, practice);
    if (now.solution && !told_.solution) { bring_into_sight(ui, at_solution); }
    told_ = now;
}

void ExerciseTab::head(const LessonUi& ui, const Practice& practice) {
    command_button(ui, Command::exercise_list, tr("List"));
    if (practice.has_variants()) {
        next_button(tr("New numbers"));
        command_button(ui, Command::exercise_anew, tr("New numbers"));
    }
    section(ui, practice.exercise()->title.c_str());
    note(ui, what_is_allowed(*practice.exercise()));
}

void ExerciseTab::question(const LessonUi& ui, const Task& task) {
    const render::Fonts& fonts = ui.canvas.fonts();
    author_words(ui, task.exercise().ask);
    if (task.exercise().kind == ExerciseKind::code) { return note(ui, inputs_of_program(task.exercise())); }
    for (const GivenSymbol& symbol : task.asked.given) {
        ImGui::Dummy({0.0F, ui.px(2.0F)});
        rich_words(ui, "$" + given_latex(symbol) + "$", fonts.normal, theme::kInk);
    }
    choices(ui, task);
    // data that a figure cannot show: the names of the joints, and the places of their points
    const bool has_scene = hands_out_file(task.exercise()) && !task.exercise().asked.empty();
    if (has_scene && ImGui::CollapsingHeader(tr("The scene as a lesson file"))) {
        text_box(ui, "scene", handed_out(task), kLinesOfFile);
    }
}

void ExerciseTab::choices(const LessonUi& ui, const Task& task) {
    const bool pressed_to_choose = task.exercise().kind == ExerciseKind::choose;
    for (std::size_t k = 0; k < task.shown.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        ImGui::PushID(static_cast<int>(k));
        if (pressed_to_choose) {
            if (small_button((" " + number + " ").c_str())) {
                answer_ = number;
                hand_in(ui.requests);
            }
        } else {
            ImGui::TextUnformatted((number + " ").c_str());
        }
        ImGui::SameLine();
        ImGui::BeginGroup();
        author_words(ui, task.shown[k]);
        ImGui::EndGroup();
        ImGui::PopID();
    }
}

/// Passes on to the field the letters that were typed before it had the keyboard. They replace an answer that
/// was judged, and are appended to one that was not finished.
Caret ExerciseTab::hand_over_typed() {
    ImVector<ImWchar>& letters = ImGui::GetIO().InputQueueCharacters;
    // ImGui has received these letters, too
    if (std::exchange(took_letters_, false)) { letters.clear(); }
    if (!has_keyboard_ || typed_.empty()) {
        has_caret_ = false;
        return Caret::stays;
    }
    if (!std::exchange(has_caret_, true)) {
        // ImGui moves the caret only after it has read the letters: all letters wait for the next frame
        typed_.append(letters.begin(), letters.end());
        letters.clear();
        return answer_ == handed_in_ ? Caret::over_all : Caret::at_end;
    }
    for (std::size_t k = typed_.size(); k-- > 0;) {
        letters.insert(letters.begin(), static_cast<ImWchar>(typed_[k]));
    }
    typed_.clear();
    return Caret::stays;
}

void ExerciseTab::hand_in(Requests& requests) {
    requests.answer = answer_;
    handed_in_ = answer_;
}

void ExerciseTab::answer_field(const LessonUi& ui, const Task& task, const ExerciseWork& work) {
    const ExerciseKind kind = task.exercise().kind;
    section(ui, tr("Your answer"));
    note(ui, how_to_answer(task));
    if (kind == ExerciseKind::experiment) {
        for (const std::string& action : work.experiments) { ImGui::BulletText("%s", action.c_str()); }
        if (work.experiments.empty()) { note(ui, tr("none so far")); }
        wants_focus_ = false;
        return;
    }
    if (is_file(kind) && !work.file.empty() && ui.state.has_disk) {
        note(ui, tr("The lesson is also in the file {0}", work.file.string()));
    }
    const Caret caret = hand_over_typed();
    if (wants_focus_) { ImGui::SetKeyboardFocusHere(); }
    wants_focus_ = false;
    const bool large = kind == ExerciseKind::matrix || kind == ExerciseKind::pose;
    const int lines = is_file(kind) ? kLinesOfFile : (large ? kLinesOfMatrix : 1);
    if (text_field(ui, "##answer", hint_of_field(kind), answer_, lines, !is_file(kind), caret)) {
        hand_in(ui.requests);
    }
    has_keyboard_ = ImGui::IsItemActive();
    if (kind == ExerciseKind::code) {
        if (ImGui::Button(tr("Write a starter"))) { ui.requests.starter = answer_; }
        tip_of_item(tr("Writes a program to start from and its input file; existing files are kept."));
    }
}

void ExerciseTab::buttons(const LessonUi& ui, const Practice& practice) {
    const Task& task = *practice.task();
    ImGui::BeginDisabled(practice.is_busy());
    if (ImGui::Button(tr("Check"))) { hand_in(ui.requests); }
    ImGui::EndDisabled();
    tip_of_item(is_file(task.exercise().kind) ? tr("(Ctrl+Enter in the field)") : tr("(Enter)"));
    const auto hints = static_cast<int>(task.exercise().hints.size());
    if (hints > practice.hints_given()) {
        next_button(tr("Hint"));
        command_button(ui, Command::exercise_hint, tr("Hint"));
    }
    if (!practice.shows_solution()) {
        next_button(tr("Show solution"));
        command_button(ui, Command::exercise_solution, tr("Show solution"));
    }
    if (practice.is_busy()) { note(ui, practice.doing()); }
}

void ExerciseTab::verdict(const LessonUi& ui, const Practice& practice) {
    const AnswerVerdict* const verdict = practice.verdict();
    if (verdict == nullptr) { return; }
    const Judged& judged = verdict->judged;
    ImGui::Dummy({0.0F, ui.px(4.0F)});
    if (judged.right) {
        bold_words(ui, title_of(judged), theme::kAccent);
        if (!practice.task()->exercise().why.empty() && !practice.shows_solution()) {
            author_words(ui, practice.task()->exercise().why);
        }
        return;
    }
    bold_words(ui, title_of(judged), theme::kRedundant);
    for (const std::string& sentence : judged.feedback) {
        rich_words(ui, sentence, ui.canvas.fonts().normal, theme::kInk);
    }
    if (!verdict->wrong.empty()) {
        note(ui, tr("Your answer; wrong entries have a box:"));
        marked_matrix(ui, verdict->given, verdict->wrong);
    }
    if (judged.slide.empty()) { return; }
    if (const SlideLesson* const lesson = practice.lesson_about(judged.slide)) {
        const std::string label = tr("Open the lesson of {0}", shown_slides(judged.slide));
        if (ImGui::Button(label.c_str())) { ui.requests.open = lesson->file.string(); }
        tip_of_item(lesson->title);
    }
}

void ExerciseTab::hints(const LessonUi& ui, const Practice& practice) {
    const int given = practice.hints_given();
    if (given == 0 || practice.task() == nullptr) { return; }
    const std::vector<Text>& all = practice.task()->exercise().hints;
    section(ui, tr("Hint {0} of {1}", given, all.size()).c_str());
    for (int k = 0; k < given; ++k) { author_words(ui, all[static_cast<std::size_t>(k)]); }
}

void ExerciseTab::solution(const LessonUi& ui, const Practice& practice) {
    if (!practice.shows_solution()) { return; }
    section(ui, tr("Solution"));
    if (!practice.is_solved()) { note(ui, tr("This variant does not count as solved.")); }
    const Task& task = *practice.task();
    const render::Fonts& fonts = ui.canvas.fonts();
    if (task.exercise().kind == ExerciseKind::build) {
        text_box(ui, "solution", solution_words(task), kLinesOfFile);
    } else {
        rich_words(ui, solution_words(task), fonts.normal, theme::kInk);
    }
    author_words(ui, task.exercise().why);
}

}  // namespace jw::host
