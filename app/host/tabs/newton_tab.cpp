#include "app/host/tabs/newton_tab.hpp"

#include <algorithm>
#include <numbers>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/plot/comparison.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw::host {

namespace {

using panels::Box;

// more ghosts than this hide each other
constexpr std::size_t kMostGhosts = 12;
constexpr float kLeastHeight = 280.0F;  // of the comparison
// up to this size all runs are done in one frame, in 0.1 s; above it, one run per frame
constexpr std::size_t kMostBodiesAtOnce = 50;

/// The step from which the current joint or driver was closed. If there is no current one: the step of the
/// most instructive closing, -1 if nothing is added.
int start_of_solve(const Session& session) {
    const std::vector<Step>& steps = session.story().steps();
    int k = session.index();
    const Step::Kind kind = steps[static_cast<std::size_t>(k)].kind;
    if (kind == Step::Kind::motion || kind == Step::Kind::bodies) {
        return start_of_telling_closing(session.story());
    }
    while (k > 0 && steps[static_cast<std::size_t>(k)].kind != Step::Kind::equations) { --k; }
    return steps[static_cast<std::size_t>(k)].kind == Step::Kind::equations ? k : -1;
}

/// Width of a list at the cursor: at most the rest of the line.
float room_for_choice(const Ui& ui) {
    return std::clamp(ImGui::GetContentRegionAvail().x, 1.0F, ui.px(210.0F));
}

}  // namespace

void NewtonTab::controls(const LessonUi& ui) {
    if (choice_of_ != ui.session.told()) {
        choice_of_ = ui.session.told();
        choice_ = ui.session.lesson().coordinates;
    }
    if (ImGui::RadioButton(tr("methods, in"), compared_ == Compared::methods)) {
        compared_ = Compared::methods;
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(compared_ != Compared::methods);
    host::choose("##choice", room_for_choice(ui), kChoices, choice_);
    ImGui::EndDisabled();
    if (ImGui::RadioButton(tr("coordinates, by"), compared_ == Compared::coordinates)) {
        compared_ = Compared::coordinates;
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(compared_ != Compared::coordinates);
    host::choose("##method", room_for_choice(ui), kNewtonMethods, method_);
    ImGui::EndDisabled();
    ImGui::Checkbox(tr("use the rows pᵀp − 1 in (r, p)"), &normalisation_);
}

void NewtonTab::compute(const Session& session, int start) {
    const NewtonPlan plan{compared_ == Compared::methods, choice_, method_, normalisation_};
    const Key key{session.told(), start, plan};
    if (key == key_ && !is_comparing()) { return; }
    if (key != key_) { runs_ = {}; }
    key_ = key;
    const bool is_large = session.lesson().mechanism.bodies.size() > kMostBodiesAtOnce;
    while (run_next_way(session.story(), start, plan, runs_) && !is_large) {}
    if (!is_comparing()) { choose(chosen_); }
}

void NewtonTab::choose(int run) {
    ghosts_.clear();
    ++version_;
    if (runs_.traces.empty()) { return; }
    chosen_ = std::clamp(run, 0, static_cast<int>(runs_.traces.size()) - 1);
    for (const NewtonIterate& iterate : runs_.traces[static_cast<std::size_t>(chosen_)].iterates) {
        if (ghosts_.size() < kMostGhosts) { ghosts_.push_back(iterate.state); }
    }
}

void NewtonTab::draw(const LessonUi& ui, const Box& box) {
    Area area(ui, "newton", box, true);
    const int start = start_of_solve(ui.session);
    if (start < 0) {
        forget_ghosts();
        key_ = {};
        return note(ui, tr("Nothing is solved: the lesson adds neither joints nor drivers."));
    }
    const Step& from = ui.session.story().steps()[static_cast<std::size_t>(start)];
    const Addition subject = *subject_of(ui.session.lesson(), from);
    const auto k = static_cast<std::size_t>(subject.index);
    const Mechanism& mechanism = ui.session.lesson().mechanism;
    const std::string name =
        subject.kind == Addition::Kind::joint ? mechanism.joints[k].name : mechanism.drivers[k].name;
    section(ui, tr("Closing {0} from the same start, compared", name).c_str());
    controls(ui);
    compute(ui.session, start);
    if (is_comparing()) {
        return note(ui, tr("{0} of {1} compared …", runs_.traces.size(), ways_of(key_.plan)));
    }
    if (ghosts_.empty()) { choose(chosen_); }

    ImGui::TextUnformatted(tr("Iterates in the picture:"));
    for (int run = 0; run < static_cast<int>(runs_.comparison.rows.size()); ++run) {
        const auto way = static_cast<std::size_t>(run);
        const char* const text = tr(key_.plan.by_method ? kNewtonMethods[way].label : kChoices[way].label);
        if (run > 0) { beside_if_it_fits(text, ui.px(228.0F)); }
        if (ImGui::RadioButton(text, chosen_ == run)) { choose(run); }
    }
    const float top = ImGui::GetCursorScreenPos().y + ui.px(8.0F);
    const bool iterates =
        std::ranges::any_of(runs_.traces, [](const NewtonTrace& trace) { return trace.iterates.size() > 1; });
    if (!iterates) {
        return note(
            ui, tr("The equations hold already at the start estimate: there is nothing to iterate. Drag a "
                   "body away at the previous step, then come back."));
    }
    // in a low window the column is scrolled
    const float height = std::max(ui.px(kLeastHeight), box.bottom() - top - ui.px(10.0F));
    const Box place{
        ImGui::GetCursorScreenPos().x + ui.px(2.0F), top, ImGui::GetContentRegionAvail().x - ui.px(6.0F),
        height};
    plot_.hovered = chosen_;
    const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    panels::newton_comparison_panel(canvas, place, runs_.comparison, plot_);
    ImGui::SetCursorScreenPos({place.x, place.y});
    if (box.bottom() - top - ui.px(10.0F) < height) { ImGui::Dummy({1.0F, height}); }
}

}  // namespace jw::host
