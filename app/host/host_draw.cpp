#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/host/host.hpp"
#include "app/host/parts/browser.hpp"
#include "app/host/parts/menu.hpp"
#include "app/host/parts/timeline_bar.hpp"
#include "app/host/tabs/tabs.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/frame/caption.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::host {

namespace {

namespace theme = panels::theme;
using panels::Box;
using panels::Canvas;

int angular_of(CoordinateChoice choice) {
    return with_choice(choice, [](auto c) { return decltype(c)::kAngular; });
}

/// What the pointer is over in the panels; of a cell of the matrix, its row and its column.
struct Pointed {
    Pointable row;
    Pointable column;
    Pointable other;

    Pointable first() const { return other ? other : (row ? row : column); }
};

Pointed pointed_at(const std::vector<panels::HotSpot>& spots, const ImVec2& mouse) {
    Pointed found;
    for (const panels::HotSpot& spot : spots) {
        if (!spot.box.contains(panels::Point{mouse.x, mouse.y})) { continue; }
        const Pointable::Kind kind = spot.link.kind;
        Pointable& under = kind == Pointable::Kind::row      ? found.row
                           : kind == Pointable::Kind::column ? found.column
                                                             : found.other;
        under = spot.link;
    }
    return found;
}

std::string tip_of_cell(const Session& session, int row, int column) {
    const MatrixView& matrix = session.view().matrix;
    if (row >= matrix.values.rows() || column >= matrix.values.cols()) { return {}; }
    const MatrixView::Row& r = matrix.rows[static_cast<std::size_t>(row)];
    const MatrixView::Column& c = matrix.columns[static_cast<std::size_t>(column)];
    return "∂(" + r.owner + " · " + r.label + ") / ∂(" + c.owner + " · " + c.symbol +
           ") = " + number_text(matrix.values(row, column), 6);
}

std::string tip_of_row(const Session& session, int row) {
    const View& view = session.view();
    for (const EquationGroup& group : view.equations) {
        for (const EquationRow& r : group.rows) {
            if (r.row == row) {
                return row_label(*session.step().system, row) + " = " + number_text(r.value, 6) +
                       (group.unit == "-" ? "" : " " + group.unit);
            }
        }
    }
    return row < session.step().system->rows(true) ? row_label(*session.step().system, row) : std::string();
}

std::string tip_of(const Session& session, const Pointable& link) {
    const Mechanism& mechanism = session.lesson().mechanism;
    const auto k = static_cast<std::size_t>(link.index);
    switch (link.kind) {
        case Pointable::Kind::body:
            return mechanism.bodies[k].name + (mechanism.bodies[k].fixed ? " (fixed)" : "");
        case Pointable::Kind::joint: {
            const Joint& joint = mechanism.joints[k];
            return joint.name + ": " + std::string(joint.type->name) + ", " +
                   mechanism.bodies[static_cast<std::size_t>(joint.body_i)].name + " – " +
                   mechanism.bodies[static_cast<std::size_t>(joint.body_j)].name;
        }
        case Pointable::Kind::vector: {
            const Joint& joint = mechanism.joints[k];
            if (link.part == Pointable::kVectorD) { return "d of " + joint.name + ", from body i to body j"; }
            const int body = link.part == Pointable::kVectorI ? joint.body_i : joint.body_j;
            return std::string("fixed in body ") + (link.part == Pointable::kVectorI ? "i: " : "j: ") +
                   mechanism.bodies[static_cast<std::size_t>(body)].name;
        }
        case Pointable::Kind::none:
        case Pointable::Kind::row:
        case Pointable::Kind::column: break;
    }
    return {};
}

/// That the pose is not one of the lesson.
void draw_badge(const Canvas& canvas, const Box& scene) {
    const ImFont* const font = canvas.fonts().normal;
    const std::string text = "moved from the step   ·   Escape goes back";
    const Box badge{
        scene.x + canvas.px(12.0F), scene.y + canvas.px(12.0F),
        canvas.text_width(font, text) + canvas.px(20.0F), canvas.line_height(font) + canvas.px(8.0F)};
    canvas.fill(badge, theme::kWarningShade, canvas.px(5.0F));
    canvas.outline(badge, theme::kSubjectMark, panels::hairline(canvas), canvas.px(5.0F));
    canvas.text({badge.x + canvas.px(10.0F), badge.y + canvas.px(4.0F)}, font, theme::kInk, text);
}

/// Words on a sheet at the foot of the 3D picture.
float draw_notice(
    const Canvas& canvas, const Box& scene, float bottom, const std::string& text, bool is_error) {
    const ImFont* const font = is_error ? canvas.fonts().mono : canvas.fonts().normal;
    const float margin = canvas.px(12.0F);
    const Box room{scene.x + canvas.px(16.0F), 0.0F, scene.width - canvas.px(32.0F), scene.height};
    const Box inner{room.x + margin, 0.0F, room.width - 2.0F * margin, room.height};
    const std::size_t most = is_error ? 14 : 3;
    const float height = panels::paragraph(canvas.measuring(), inner, font, theme::kInk, text, most);
    const Box sheet{
        room.x, bottom - height - 2.0F * canvas.px(8.0F), room.width, height + 2.0F * canvas.px(8.0F)};
    canvas.fill(sheet, is_error ? theme::kFailureShade : theme::kWarningShade, canvas.px(5.0F));
    canvas.outline(
        sheet, is_error ? theme::kRedundant : theme::kSubjectMark, panels::hairline(canvas), canvas.px(5.0F));
    panels::paragraph(
        canvas, {inner.x, sheet.y + canvas.px(8.0F), inner.width, height}, font, theme::kInk, text, most);
    return sheet.y - canvas.px(6.0F);
}

}  // namespace

void Host::draw_interface() {
    Requests requests;
    spots_.clear();
    const Emphasis lit = session_ ? emphasis() : Emphasis();
    const Canvas canvas = Canvas(ImGui::GetBackgroundDrawList(), fonts_)
                              .pointed(lit, spots_)
                              .in(state_.dark ? render::Tone::dark : render::Tone::light);
    const Ui ui{state_, canvas, requests};
    const Box window{0.0F, 0.0F, static_cast<float>(width_), static_cast<float>(height_)};
    if (shows_lesson()) {
        draw_lesson({ui, *session_, hand_.camera()});
    } else {
        browser(ui, window, entries_, session_ != nullptr);
    }
    draw_messages(ui);
    help_overlay(ui, window);
    carry_out(std::move(requests));
}

void Host::draw_lesson(const LessonUi& ui) {
    const View& view = session_->view();
    panels::draw_annotations(ui.canvas, picture(), hand_.camera(), layout_.scene);
    panels::draw_title(ui.canvas, layout_.title, view);
    panels::draw_caption(ui.canvas, layout_.caption, view);
    if (session_->in_hand()) { draw_badge(ui.canvas, panels::box_of(layout_.scene)); }
    side_column(ui, layout_, tabs_);
    timeline_bar(ui, bar_);

    // what is under the pointer now is lit in the next frame
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool reachable = !ImGui::GetIO().WantCaptureMouse && !state_.help;
    const Pointed pointed = reachable ? pointed_at(spots_, mouse) : Pointed{};
    const Pointable before = state_.pointed_at;
    if (!hand_.is_dragging()) { state_.pointed_at = pointed.first(); }
    hand_.handle(ui, layout_.scene, scene_size(), reachable ? pick_ : Picker{});
    if (state_.pointed_at != before) { settle_ = 2; }

    std::string tip;
    if (pointed.row && pointed.column) {
        tip = tip_of_cell(*session_, pointed.row.index, pointed.column.index);
    } else if (pointed.row) {
        tip = tip_of_row(*session_, pointed.row.index);
    } else if (!hand_.is_dragging()) {
        tip = tip_of(*session_, state_.pointed_at);
    }
    if (!tip.empty() && reachable) { ImGui::SetTooltip("%s", panels::with_minus_signs(tip).c_str()); }
}

void Host::draw_messages(const Ui& ui) {
    const Box scene = shows_lesson()
                          ? panels::box_of(layout_.scene)
                          : Box{0.0F, 0.0F, static_cast<float>(width_), static_cast<float>(height_)};
    float bottom = scene.bottom() - ui.px(10.0F);
    // over the widgets of the browser
    const Canvas canvas(ImGui::GetForegroundDrawList(), ui.canvas);
    if (!message_.empty()) { bottom = draw_notice(canvas, scene, bottom, message_, false); }
    if (!file_errors_.empty()) {
        const std::string kept = session_ ? "The file has mistakes; the last good lesson stays.\n" : "";
        draw_notice(canvas, scene, bottom, kept + file_errors_, true);
    }
}

const Picture& Host::picture() {
    if (!session_) { return picture_; }
    const std::span<const State> ghosts = tabs_.newton.ghosts(session_->told());
    const bool same_ghosts =
        picture_ghosts_ == tabs_.newton.version() && picture_has_ghosts_ == !ghosts.empty();
    if (picture_of_ == session_->version() && picture_link_ == state_.pointed_at && same_ghosts &&
        picture_rows_ == state_.lit_rows) {
        return picture_;
    }
    picture_ = session_->picture();
    add_ghosts(session_->lesson(), session_->style(), ghosts, picture_);
    picture_ghosts_ = tabs_.newton.version();
    picture_has_ghosts_ = !ghosts.empty();
    if (picture_of_ != session_->version()) { ++pose_version_; }
    picture_of_ = session_->version();
    picture_link_ = state_.pointed_at;
    ++picture_version_;
    picture_rows_ = state_.lit_rows;
    light_up(picture_, emphasis());
    return picture_;
}

Emphasis Host::emphasis() const {
    const System& system = *session_->step().system;
    const int angular = angular_of(session_->lesson().coordinates);
    Emphasis lit(system, angular, state_.pointed_at);
    for (const int row : state_.lit_rows) { lit.light(system, angular, Pointable::row(row)); }
    return lit;
}

}  // namespace jw::host
