#include "app/host/tabs/exercise_tab.hpp"

#include <algorithm>
#include <utility>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

using panels::Box;
using panels::Canvas;
namespace theme = panels::theme;

constexpr float kMark = 18.0F;  // room for the mark before a row

/// Mark of an exercise: empty if new, half if tried, full if solved.
void draw_mark(const Canvas& canvas, panels::Point at, const ExerciseRecord& record) {
    const float radius = canvas.px(5.0F);
    if (record.solved > 0) { return canvas.disc(at, radius, theme::kAccent); }
    canvas.ring(at, radius, record.tried > 0 ? theme::kSubjectMark : theme::kFaint, canvas.px(2.0F));
    if (record.tried > 0) { canvas.disc(at, 0.5F * radius, theme::kSubjectMark); }
}

}  // namespace

void ExerciseTab::draw(
    const LessonUi& ui, const Box& box, const Practice& practice, const ExerciseWork& work) {
    const Area area(ui, "exercises", box, true);
    if (std::exchange(wants_top_, false)) { ImGui::SetScrollY(0.0F); }
    if (practice.chosen() < 0) { return list(ui, practice); }
    task(ui, practice, work);
}

void ExerciseTab::list(const LessonUi& ui, const Practice& practice) {
    section(ui, tr("Exercises of this lesson"));
    if (practice.is_busy()) { note(ui, practice.doing()); }
    if (!practice.problem().empty()) { note(ui, practice.problem()); }
    const auto count = static_cast<int>(practice.exercises().size());
    if (count == 0) {
        if (!practice.is_busy()) { note(ui, tr("This lesson has no exercises.")); }
        return;
    }
    row_ = std::clamp(row_, 0, count - 1);
    note(ui, tr("Up and Down choose, Enter begins. The numbers are new each time."));
    for (int k = 0; k < count; ++k) { row(ui, practice, k); }
    wants_row_ = false;
}

void ExerciseTab::row(const LessonUi& ui, const Practice& practice, int index) {
    const PracticeExercise& entry = practice.exercises()[static_cast<std::size_t>(index)];
    const ExerciseRecord record = practice.progress().of(entry.key);
    const render::Fonts& fonts = ui.canvas.fonts();
    const float mark = ui.px(kMark);
    const float room = std::max(ui.px(60.0F), ImGui::GetContentRegionAvail().x);
    const float inner = room - mark - ui.px(8.0F);
    const std::string below = facts_of(*entry.exercise, record);
    const float title = panels::paragraph_height(ui.canvas, fonts.normal, entry.exercise->title, inner);
    const float height =
        title + panels::paragraph_height(ui.canvas, fonts.small, below, inner) + ui.px(10.0F);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(index);
    if (ImGui::InvisibleButton("exercise", {room, height})) {
        row_ = index;
        ui.requests.exercise = index;
    }
    const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    if (wants_row_ && row_ == index) { ImGui::SetScrollHereY(0.5F); }
    ImGui::PopID();
    const Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const Box box{at.x, at.y, room, height};
    if (row_ == index || hovered) {
        canvas.fill(box, row_ == index ? theme::kSubject : theme::kShade, ui.px(4.0F));
    }
    draw_mark(
        canvas, {at.x + 0.5F * mark, at.y + ui.px(5.0F) + 0.5F * canvas.line_height(fonts.normal)}, record);
    const Box words{at.x + mark, at.y + ui.px(5.0F), inner, height};
    panels::paragraph(canvas, words, fonts.normal, theme::kInk, entry.exercise->title);
    panels::paragraph(canvas, {words.x, words.y + title, inner, height}, fonts.small, theme::kSoft, below);
}

/// Puts a character that can begin a number into the field, and the characters after it. The number of a
/// choice is handed in at once.
bool ExerciseTab::act_on_letter(unsigned character, const Practice& practice, Requests& requests) {
    const Task* const task = practice.task();
    if (task == nullptr || !is_of_numbers(task->exercise().kind)) { return false; }
    constexpr std::u32string_view kFirstOfNumbers = U"0123456789-.[(";
    const auto letter = static_cast<char32_t>(character);
    // the field gets the keyboard one or two frames later; until then, all characters are for it
    if (typed_.empty() && kFirstOfNumbers.find(letter) == std::u32string_view::npos) { return false; }
    if (task->exercise().kind == ExerciseKind::choose && task->shown.size() < 10) {
        answer_ = static_cast<char>(letter);
        hand_in(requests);
        return true;
    }
    typed_ += letter;
    took_letters_ = true;
    wants_focus_ = true;
    return true;
}

bool ExerciseTab::act(const InputEvent& event, const Practice& practice, Requests& requests) {
    if (event.kind == InputEvent::Kind::text) { return act_on_letter(event.character, practice, requests); }
    if (event.kind != InputEvent::Kind::key || !event.down) { return false; }
    // these are the keys of letters that go into the field
    if (!typed_.empty()) { return true; }
    const bool in_list = practice.chosen() < 0;
    switch (event.key) {
        case Key::up:
        case Key::down:
            if (in_list) {
                const int last = std::max(0, static_cast<int>(practice.exercises().size()) - 1);
                row_ = std::clamp(row_ + (event.key == Key::up ? -1 : 1), 0, last);
                wants_row_ = true;
            }
            return in_list;
        case Key::enter:
            if (in_list) {
                requests.exercise = row_;
            } else {
                wants_focus_ = true;
            }
            return true;
        case Key::escape:
            if (in_list) { return false; }
            requests.add(Command::exercise_list);
            return true;
        default: return false;
    }
}

void ExerciseTab::follow(const Practice& practice) {
    const int index = practice.chosen();
    const std::string now = index < 0 || practice.task() == nullptr
                                ? std::string()
                                : practice.exercises()[static_cast<std::size_t>(index)].key + "#" +
                                      std::to_string(practice.task()->variant.seed);
    if (now == answers_) { return; }
    if (!answers_.empty()) { drafts_[answers_] = answer_; }
    answers_ = now;
    typed_.clear();
    handed_in_.clear();
    wants_top_ = true;
    answer_ = now.empty() ? std::string() : drafts_[now];
}

}  // namespace jw::host
