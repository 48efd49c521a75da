#include "app/host/tabs/price_tab.hpp"

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/plot/comparison.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::host {

namespace {

using panels::Box;
using panels::Point;

// height of a dozen methods, the summary and the curves
constexpr float kLeastPrices = 400.0F;

/// Why this lesson cannot be measured; empty if it can.
std::string why_not(const Lesson& lesson) {
    if (!lesson.dynamics) {
        return tr(
            "This lesson has no masses: nothing is integrated, so there is no error to compare with the "
            "time. Open a lesson on dynamics, for example dynamics/andrews.");
    }
    if (!lesson.dynamics->point) {
        return tr(
            "Errors are measured on the path of one point: name the point as 'point' in [dynamics] of the "
            "lesson.");
    }
    return {};
}

}  // namespace

void PriceTab::forget() {
    job_.reset();
    news_ = {};
    prices_.reset();
    seen_ = 0;
}

void PriceTab::begin(const Session& session) {
    std::optional<Reference> reference;
    if (!session.is_changed()) { reference = stored_reference(lesson_file_); }
    BenchPlan plan;
    plan.treatment = treatment_;
    forget();  // one measurement at a time: two would slow each other down
    job_ = std::make_unique<BenchJob>(session.lesson(), std::move(reference), plan);
}

void PriceTab::look_at_news() {
    if (!job_ || job_->version() == seen_) { return; }
    seen_ = job_->version();
    news_ = job_->news();
    prices_ = prices_of(news_.runs);
}

void PriceTab::controls(const LessonUi& ui) {
    if (is_measuring()) {
        if (ImGui::Button(tr("Stop"))) {
            job_.reset();
            news_.done = true;
        }
    } else {
        if (ImGui::Button(tr("Measure"))) { begin(ui.session); }
        tip_of_item(tr("a sweep of tolerances with every method; takes some seconds"));
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(is_measuring());
    width_beside_label(ui, tr("constraints"), 150.0F);
    if (ImGui::BeginCombo(tr("constraints"), std::string(entry_of(treatment_).name).c_str())) {
        for (const TreatmentName& entry : kTreatments) {
            // left out: it is only for implicit methods, which already use it for projection
            if (entry.treatment == Treatment::tangent) { continue; }
            if (ImGui::Selectable(std::string(entry.name).c_str(), entry.treatment == treatment_)) {
                treatment_ = entry.treatment;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::EndDisabled();
}

void PriceTab::draw(const LessonUi& ui, const Box& box) {
    Area area(ui, "price", box, true);
    if (told_ != ui.session.told()) {
        told_ = ui.session.told();
        forget();
    }
    const std::string unfit = why_not(ui.session.lesson());
    section(ui, tr("Cost of accuracy"));
    if (!unfit.empty()) { return note(ui, unfit); }
    controls(ui);
    look_at_news();
    if (!news_.failure.empty()) { return note(ui, news_.failure); }
    if (!job_ && !prices_) {
        return note(
            ui, tr("Every adaptive method integrates this lesson with tolerances from 3e-2 to 1e-13; the "
                   "error is that of the lesson's point at 100 moments. The fastest method for three digits "
                   "need not be the fastest for nine."));
    }
    if (!news_.origin.empty()) { note(ui, tr("Compared with: {0}", news_.origin)); }
    const Box place = rest_of_column(ui, box, kLeastPrices);
    std::string progress =
        tr(news_.origin.empty() ? tr_later("computing the reference …") : tr_later("measuring …"));
    if (news_.done) { progress = tr("CPU time on this machine"); }
    const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const panels::ComparisonLayout layout =
        panels::price_panel(canvas, place, prices_.value_or(Prices{}), progress, plot_);
    end_column_at(place);
    plot_.hovered = -1;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (std::size_t k = 0; k < layout.rows.size(); ++k) {
        if (layout.rows[k].contains(Point{mouse.x, mouse.y})) { plot_.hovered = static_cast<int>(k); }
    }
}

}  // namespace jw::host
