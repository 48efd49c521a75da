#include "app/host/parts/browser.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw::host {

namespace {

using panels::Box;
using panels::Canvas;
namespace theme = panels::theme;

constexpr float kCardWidth = 216.0F;  // at least; the cards share the width
constexpr float kPictureShape = 0.569F;
constexpr float kWordsHeight = 74.0F;
constexpr float kCardGap = 14.0F;
constexpr float kChapterHeight = 28.0F;

/// "3 exercises", "1 of 3 exercises solved"
std::string exercises_text(const CatalogueEntry& e, const Progress& progress) {
    const std::size_t count = e.exercises.size();
    const auto solved = std::ranges::count_if(e.exercises, [&](const IndexedExercise& exercise) {
        return progress.of(record_key(exercise.file, exercise.name)).solved > 0;
    });
    return solved == 0 ? tr_count(static_cast<int>(count), "{0} exercise", "{0} exercises")
                       : tr_count(
                             static_cast<int>(count), "{1} of {0} exercise solved",
                             "{1} of {0} exercises solved", solved);
}

/// Text of a card below the title: "slide 2 · 3 exercises".
std::string origin_text(const CatalogueEntry& e, const Progress& progress) {
    if (e.exercises.empty()) { return shown_slides(e.source); }
    const std::string exercises = exercises_text(e, progress);
    return e.source.empty() ? exercises : shown_slides(e.source) + "  ·  " + exercises;
}

void draw_card(
    const Canvas& canvas, ImDrawList* list, const Box& card, const CatalogueEntry& e, bool chosen,
    bool hovered, const Progress& progress) {
    canvas.fill(card, theme::kWhite, canvas.px(5.0F));
    const Box picture{
        card.x + 1.0F, card.y + 1.0F, card.width - 2.0F, std::round(kPictureShape * card.width)};
    if (e.thumbnail != nullptr) {
        list->AddImage(e.thumbnail, {picture.x, picture.y}, {picture.right(), picture.bottom()});
    } else {
        canvas.fill(picture, theme::kShade);
        const std::string word = e.error.empty() ? "" : tr("has mistakes");
        canvas.text(
            {picture.centre().x, picture.centre().y}, canvas.fonts().small, theme::kSoft, word,
            panels::Align::centre);
    }
    Box words = panels::shrunk(card, canvas.px(10.0F), 0.0F);
    words.y = picture.bottom() + canvas.px(7.0F);
    words.height = card.bottom() - words.y - canvas.px(4.0F);
    const float height = panels::paragraph(canvas, words, canvas.fonts().normal, theme::kInk, e.title, 2);
    panels::cut_top(words, height + canvas.px(2.0F));
    panels::paragraph(
        canvas, words, canvas.fonts().small, e.error.empty() ? theme::kSoft : theme::kRedundant,
        e.error.empty() ? origin_text(e, progress) : e.error, e.error.empty() ? 1 : 2);
    const render::Colour edge = chosen ? theme::kSubjectMark : (hovered ? theme::kAccent : theme::kLine);
    canvas.outline(card, edge, chosen ? canvas.px(3.0F) : panels::hairline(canvas), canvas.px(5.0F));
}

/// Title of the chapter, or its name: "vectors" -> "Vectors"
std::string headline(const CatalogueEntry& entry) {
    if (!entry.heading.empty()) { return entry.heading; }
    std::string text = tr(entry.chapter.empty() ? tr_later("other") : entry.chapter.c_str());
    if (text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

/// One card at ImGui's cursor, below the name of its chapter if it is the first one. A click opens it.
void card(
    const Ui& ui, LessonList& shelf, const Progress& progress, int index, float width,
    bool first_of_chapter) {
    const CatalogueEntry& entry = shelf.entries()[static_cast<std::size_t>(index)];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float above = ui.px(kChapterHeight);
    const float height = std::round(kPictureShape * width) + ui.px(kWordsHeight);
    const Box box{at.x, at.y + above, width, height};
    ImGui::PushID(index);
    if (ImGui::InvisibleButton("card", {box.width, above + box.height})) {
        shelf.choose(index);
        ui.requests.open = entry.path.string();
    }
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) {
        std::string tip = entry.path.string();
        if (!entry.text.empty()) { tip = panels::run_on(math::plain_words(entry.text)) + "\n\n" + tip; }
        tip_of_item(tip, ui.px(420.0F));
    }
    if (ImGui::IsItemVisible()) {
        const Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
        if (first_of_chapter) {
            canvas.text(
                {at.x, at.y + ui.px(4.0F)}, canvas.fonts().bold, theme::kInk,
                panels::shortened(*canvas.fonts().bold, headline(entry), width));
        }
        draw_card(canvas, ImGui::GetWindowDrawList(), box, entry, shelf.chosen() == index, hovered, progress);
    }
    ImGui::PopID();
}

void search_field(LessonList& shelf, float width) {
    std::array<char, 128> text{};
    shelf.search().copy(text.data(), text.size() - 1);
    ImGui::SetNextItemWidth(width);
    if (ImGui::InputTextWithHint("##search", tr("search title, chapter, text"), text.data(), text.size())) {
        shelf.search_for(text.data());
    }
}

void draw_head(const Canvas& canvas, const Box& box) {
    canvas.fill(box, theme::kPaper);
    canvas.fill({box.x, box.bottom() - 1.0F, box.width, 1.0F}, theme::kLine);
    canvas.text(
        {box.x + canvas.px(16.0F), box.y + canvas.px(8.0F)}, canvas.fonts().title, theme::kInk, "Jointwise");
    const float room = box.width - 2.0F * canvas.px(18.0F);
    const char* const about = tr("spatial kinematics of constrained rigid bodies, joint by joint");
    canvas.text(
        {box.x + canvas.px(18.0F), box.y + canvas.px(36.0F)}, canvas.fonts().small, theme::kSoft,
        panels::shortened(*canvas.fonts().small, about, room));
}

/// Head of an upright window: the name with buttons beside it, and the search below.
void upright_head(const Ui& ui, const Box& box, LessonList& shelf, bool has_lesson) {
    draw_head(ui.canvas, box);
    Area area(ui, "lessons head", box);
    const float help = ImGui::GetFrameHeight();
    const float back = has_lesson ? ui.px(64.0F) + ImGui::GetStyle().ItemSpacing.x : 0.0F;
    ImGui::SetCursorScreenPos({box.right() - ui.px(16.0F) - help - back, box.y + ui.px(3.0F)});
    if (has_lesson) {
        command_button(ui, Command::lessons, tr("Back"), ui.px(64.0F));
        ImGui::SameLine();
    }
    command_button(ui, Command::help, "?", help);
    ImGui::SetCursorScreenPos({box.x + ui.px(16.0F), box.y + ui.px(60.0F)});
    search_field(shelf, box.width - 2.0F * ui.px(16.0F));
}

void head(const Ui& ui, const Box& box, LessonList& shelf, bool has_lesson) {
    draw_head(ui.canvas, box);
    const float width = ui.px(460.0F);
    Area area(
        ui, "lessons head", {box.right() - width, box.y + ui.px(6.0F), width, box.height - ui.px(8.0F)});
    search_field(shelf, ui.px(270.0F));
    ImGui::SameLine();
    command_button(ui, Command::help, "?", ui.px(26.0F));
    if (!has_lesson) { return; }
    ImGui::SameLine();
    command_button(ui, Command::lessons, tr("Back"), ui.px(60.0F));
}

}  // namespace

void browser(
    const Ui& ui, const WindowLayout& window, LessonList& shelf, const Progress& progress, bool has_lesson) {
    Box rest = window.whole;
    ui.canvas.fill(rest, theme::kShade);
    if (window.upright) {
        const float height = ui.px(62.0F) + ImGui::GetFrameHeight() + ui.px(12.0F);
        upright_head(ui, panels::cut_top(rest, height), shelf, has_lesson);
    } else {
        head(ui, panels::cut_top(rest, ui.px(62.0F)), shelf, has_lesson);
    }
    const float margin = ui.px(window.upright ? 4.0F : 20.0F);
    Area area(ui, "lessons", panels::shrunk(rest, margin, ui.px(2.0F)), true);
    const std::vector<int> found = shelf.found();
    if (found.empty()) { return note(ui, tr("No lesson has all of these words.")); }
    const float gap = ui.px(kCardGap);
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>((room + gap) / (ui.px(kCardWidth) + gap)));
    const float width =
        std::floor((room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    const std::string* chapter = nullptr;
    int column = 0;
    for (const int k : found) {
        const CatalogueEntry& entry = shelf.entries()[static_cast<std::size_t>(k)];
        if (column > 0) { ImGui::SameLine(0.0F, gap); }
        card(ui, shelf, progress, k, width, chapter == nullptr || *chapter != entry.chapter);
        chapter = &entry.chapter;
        column = (column + 1) % columns;
    }
}

bool act_in_browser(const InputEvent& event, LessonList& shelf, Requests& requests) {
    const bool typing = ImGui::GetIO().WantTextInput;
    if (event.kind == InputEvent::Kind::text) {
        // letters are for the search even if its field does not have the keyboard
        const bool letter = event.character > ' ' && event.character < 127 && event.character != '?';
        if (!letter || typing) { return typing; }
        shelf.search_for(shelf.search() + static_cast<char>(event.character));
        return true;
    }
    switch (event.key) {
        case Key::left:
        case Key::up: shelf.move_choice(-1); return true;
        case Key::right:
        case Key::down: shelf.move_choice(1); return true;
        case Key::backspace:
            if (!typing) { shelf.erase_letter(); }
            return true;
        case Key::escape:
            if (shelf.search().empty()) { requests.add(Command::lessons); }
            shelf.clear_search();
            return true;
        case Key::enter:
            if (const CatalogueEntry* entry = shelf.chosen_or_first()) {
                requests.open = entry->path.string();
            }
            return true;
        default: return false;
    }
}

}  // namespace jw::host
