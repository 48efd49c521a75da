#include "app/host/tabs/plot_tab.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/host/tabs/experiment_tab.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

using panels::Box;
using panels::Point;

constexpr double kZoomPerNotch = 1.25;
constexpr float kReach = 12.0F;         // pixels at 720
constexpr float kLeastCurves = 230.0F;  // height of the curves, for three units one below the other

}  // namespace

const char* PlotTab::name() const { return word_of(kTopics, topic_); }

const SeriesSet& PlotTab::set(const Session& session, int joint) {
    if (told_ != session.told()) {
        // the story was computed again: the numbers have changed, the selection of curves stays
        told_ = session.told();
        sets_ = {};
    }
    if (topic_ == Topic::conditions && joint != joint_) { sets_[static_cast<std::size_t>(topic_)].reset(); }
    joint_ = joint;
    std::optional<SeriesSet>& set = sets_[static_cast<std::size_t>(topic_)];
    if (set) { return *set; }
    const Story& story = session.story();
    switch (topic_) {
        case Topic::quantities: {
            const PictureStyle& style = session.style();
            set = motion_series(story, {style.traced_body, style.traced_point_local});
            break;
        }
        case Topic::residuals: set = newton_series(story); break;
        case Topic::singular_values: set = singular_value_series(story); break;
        case Topic::conditions: set = condition_series(story, joint); break;
    }
    return *set;
}

std::string PlotTab::csv(const Session& session) { return csv_of(set(session, joint_)); }

void PlotTab::choose_curves(const SeriesSet& shown) {
    if (ImGui::Button(tr("Curves"))) { ImGui::OpenPopup("curves"); }
    if (!ImGui::BeginPopup("curves")) { return; }
    std::vector<int> chosen = panels::shown_series(shown, state());
    for (std::size_t k = 0; k < shown.series.size(); ++k) {
        const auto index = static_cast<int>(k);
        const auto found = std::ranges::find(chosen, index);
        bool on = found != chosen.end();
        ImGui::PushID(index);
        const Series& series = shown.series[k];
        const std::string label = series.name + (series.unit == "-" ? "" : "  [" + series.unit + "]");
        if (ImGui::Checkbox(label.c_str(), &on)) {
            if (on) {
                chosen.push_back(index);
            } else {
                chosen.erase(found);
            }
            std::ranges::sort(chosen);
            state().shown = chosen;
        }
        ImGui::PopID();
    }
    ImGui::EndPopup();
}

void PlotTab::controls(const LessonUi& ui, const SeriesSet& shown) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float buttons = ImGui::CalcTextSize((tr("Curves") + std::string(tr("All")) + "CSV").c_str()).x +
                          6.0F * style.FramePadding.x + 3.0F * style.ItemSpacing.x + 1.0F;
    const float room = ImGui::GetContentRegionAvail().x - buttons;
    choose("##topic", std::clamp(room, 1.0F, ui.px(240.0F)), kTopics, topic_);
    ImGui::SameLine();
    choose_curves(shown);
    ImGui::SameLine();
    if (ImGui::Button(tr("All"))) { state() = panels::unzoomed(state()); }
    tip_of_item(tr("show everything again"));
    ImGui::SameLine();
    command_button(ui, Command::save_csv, "CSV");
}

void PlotTab::handle(const LessonUi& ui, const panels::PlotLayout& layout, const SeriesSet& shown) {
    const ImGuiIO& io = ImGui::GetIO();
    const Point mouse{io.MousePos.x, io.MousePos.y};
    ImGui::SetCursorScreenPos({layout.box.x, layout.box.y});
    ImGui::InvisibleButton(
        "plot", {std::max(1.0F, layout.box.width), std::max(1.0F, layout.box.height)},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    state().hovered = -1;
    if (ImGui::IsItemActive() && io.MouseDown[1]) {
        state() = panels::panned(state(), layout, mouse, {io.MouseDelta.x, io.MouseDelta.y});
        return;
    }
    const std::optional<double> at = panels::at_of_pixel(layout, mouse);
    if (ImGui::IsItemActive() && at) {
        // the timeline follows the pointer
        const int point = panels::point_near(shown, *at);
        if (point >= 0) {
            ui.state.playback.pause();
            ui.requests.add(GoTo{shown.steps[static_cast<std::size_t>(point)]});
        }
    }
    if (!ImGui::IsItemHovered()) { return; }
    // in a column that can be scrolled, the wheel scrolls
    if (io.MouseWheel != 0.0F && at && ImGui::GetScrollMaxY() <= 0.0F) {
        state() = panels::zoomed(
            state(), layout, mouse, std::pow(kZoomPerNotch, static_cast<double>(io.MouseWheel)));
    }
    if (const auto hit = panels::hit_of(layout, shown, mouse, ui.px(kReach))) {
        state().hovered = hit->series;
    }
}

void PlotTab::draw(const LessonUi& ui, const Box& box) {
    const SeriesSet& shown = set(ui.session, experiment_joint_of(ui));
    Area area(ui, "plots", box, true);
    controls(ui, shown);
    const Box place = rest_of_column(ui, box, kLeastCurves);
    state().cursor = panels::point_of_step(shown, ui.session.index());
    const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const panels::PlotLayout layout = panels::layout_plot(canvas, place, shown, state());
    panels::draw_plot(canvas, layout, shown, state());
    handle(ui, layout, shown);
    end_column_at(place);
}

}  // namespace jw::host
