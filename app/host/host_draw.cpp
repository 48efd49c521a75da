#include <algorithm>
#include <variant>

#include <imgui.h>

#include "app/host/host.hpp"
#include "app/host/parts/bar_buttons.hpp"
#include "app/host/parts/browser.hpp"
#include "app/host/parts/pointed.hpp"
#include "app/host/parts/timeline_bar.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/frame/frame.hpp"
#include "app/panels/parts/rich_text.hpp"

namespace jw::host {

void Host::draw_interface() {
    Requests requests;
    std::vector<panels::HotSpot> spots;
    const Emphasis lit = session_ ? emphasis_of(*session_, state_.lit()) : Emphasis();
    const std::vector<SymbolView> no_symbols;
    const panels::Canvas canvas = panels::Canvas(ImGui::GetBackgroundDrawList(), fonts_.fonts())
                                      .pointed(lit, spots)
                                      .in(state_.tone())
                                      .naming(shows_lesson() ? session_->view().symbols : no_symbols);
    const Ui ui{state_, canvas, requests};
    if (shows_lesson()) {
        draw_lesson({ui, *session_, hand_.camera()}, spots);
    } else {
        browser(ui, layout_, shelf_, desk_.practice().progress(), session_ != nullptr);
    }
    panels::Box room = layout_.whole;
    if (shows_lesson()) {
        // above the answer sheet, so that its field and buttons stay visible
        room = panels::box_of(layout_.scene);
        if (!shows_figure()) { room.height -= predictions_.height({ui, *session_, hand_.camera()}, room); }
    }
    notice_.draw(ui, room, session_ != nullptr);
    help_overlay(ui, layout_.whole);
    if (!is_telling()) { return carry_out(std::move(requests)); }
    // the value of a slider that is still held is applied when the story has been computed
    for (const Experiment& experiment : requests.experiments) {
        const bool is_slider =
            std::holds_alternative<SetGeometry>(experiment) || std::holds_alternative<SetDriver>(experiment);
        if (is_slider) { pulled_ = experiment; }
    }
    if (waiting_sheet(ui, layout_.whole, told_part())) { stop_telling(); }
}

void Host::draw_lesson(const LessonUi& ui, const std::vector<panels::HotSpot>& spots) {
    const View& view = session_->view();
    // a new step is scrolled to its beginning; moments of a motion keep the scroll position
    if (view.step != state_.scrolled_step) {
        if (view.kind != Step::Kind::motion) { state_.column = state_.caption = {}; }
        state_.scrolled_step = view.step;
        state_.symbol = -1;
    }
    const bool figure = shows_figure();
    const panels::Box scene = panels::box_of(layout_.scene);
    const float asked = figure ? 0.0F : predictions_.height(ui, scene);
    const bool is_other_pose = !figure && (session_->in_hand() || replacement().picture != nullptr);
    panels::draw_annotations(
        ui.canvas, picture(), hand_.camera(), layout_.scene,
        asked + (is_other_pose ? badge_height(ui) : 0.0F),
        figure ? panels::BodyNames::all : panels::BodyNames::where_room);
    if (figure) {
        draw_figure(ui);
    } else {
        draw_step(ui, view);
        if (is_other_pose) { draw_badge(ui, scene, asked); }
    }
    side_column(ui, layout_, tabs_, desk_.practice(), desk_.work());
    if (figure) {
        bar_of_figure(ui, layout_);
    } else {
        timeline_bar(ui, layout_);
    }

    // the object under the pointer is highlighted in the next frame
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool reachable = !ImGui::GetIO().WantCaptureMouse && !state_.help && !figure;
    const Pointed pointed = reachable ? pointed_at(spots, {mouse.x, mouse.y}) : Pointed{};
    const Pointable before = state_.pointed_at;
    if (!hand_.is_dragging()) { state_.pointed_at = pointed.first(); }
    hand_.handle(ui, layout_.scene, reachable && !is_telling());
    if (state_.pointed_at != before) { rouse(); }
    predictions_.follow_mouse(ui, pointed, reachable);

    const Pointable link = hand_.is_dragging() ? Pointable() : state_.pointed_at;
    if (reachable) { draw_tip(tip_of(*session_, pointed, link), {mouse.x + 6.0F, mouse.y, 0.0F, 8.0F}); }
    if (!state_.pointed_at && state_.symbol >= 0) {
        const Pointable chosen = Pointable::symbol(state_.symbol);
        const auto spot = std::ranges::find(spots, chosen, &panels::HotSpot::link);
        draw_tip(tip_of(*session_, {}, chosen), spot == spots.end() ? layout_.caption : spot->box);
    }
}

void Host::draw_tip(const std::vector<std::string>& lines, const panels::Box& beside) const {
    const panels::Canvas canvas =
        panels::Canvas(ImGui::GetForegroundDrawList(), fonts_.fonts()).in(state_.tone());
    panels::draw_tip(canvas, {beside, layout_.whole}, lines);
}

/// Draws title and caption of the step.
void Host::draw_step(const LessonUi& ui, const View& view) {
    panels::draw_title(ui.canvas, layout_.title, view);
    const float height = panels::caption_height(ui.canvas, layout_.caption, view);
    scrolled(
        ui, layout_.caption, height, state_.caption,
        [&](const panels::Canvas& canvas, const panels::Box& box) {
            panels::draw_caption(canvas, box, view);
        });
    predictions_.draw(ui, panels::box_of(layout_.scene));
}

const Picture& Host::picture() {
    if (!session_) { return shown_.picture(); }
    if (shows_figure()) { return shown_.of(desk_.figure()->picture()); }
    const Ghosts ghosts{tabs_.newton.ghosts(session_->told()), tabs_.newton.version()};
    return shown_.of(*session_, state_.lit(), ghosts, replacement());
}

Replacement Host::replacement() const {
    return state_.tab == Tab::rest ? tabs_.rest.picture(*session_) : Replacement();
}

}  // namespace jw::host
