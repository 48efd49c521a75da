#include "app/host/tabs/rest_tab.hpp"

#include <array>
#include <cmath>
#include <exception>
#include <numbers>
#include <utility>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/session/rest/small_motion.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::host {

namespace {

using panels::Box;
using Complex = std::complex<double>;

constexpr std::array kSeeks{
    EnumWord<Seek>{Seek::where_it_rests, "rest", tr_later("where the forces lead")},
    EnumWord<Seek>{Seek::nearest, "nearest", tr_later("the nearest, stable or not")}};

// pieces of a search that are done in one frame, divided by the square of the number of bodies: 5 ms
constexpr std::size_t kPiecesAtOnce = 2000;
constexpr double kPeriod = 3.0;  // of every motion in the picture [s], as of free motions
constexpr double kFolds = 4.0;   // factors of e in a period of a motion that grows or decays
// largest movement in the picture [rad, extents]: visible, and still similar to a small motion
constexpr double kAmplitude = 0.3;
constexpr double kLeastAmplitude = 1e-3;

/// The largest amplitude, or a half, a quarter ... of it, at which the ends of the motion can be assembled.
double amplitude_of(const RestView& view, std::size_t mode) {
    double amplitude = kAmplitude;
    const auto is_too_large = [&] {
        for (const Complex z : {Complex(1.0), Complex(-1.0), Complex(0.0, 1.0), Complex(0.0, -1.0)}) {
            if (!pose_in_mode(view, mode, amplitude * z)) { return true; }
        }
        return false;
    };
    while (amplitude > kLeastAmplitude && is_too_large()) { amplitude *= 0.5; }
    return amplitude;
}

/// What the picture shows of a small motion.
std::string how_it_is_shown(Complex s) {
    const std::string period = number_text(kPeriod);
    if (s == 0.0) { return tr("Nothing pushes it back. The picture moves it to and fro."); }
    if (s.imag() != 0.0) { return tr("The picture shows it enlarged, with a period of {0} s.", period); }
    return s.real() > 0.0
               ? tr("It moves away and does not come back. The picture begins again every {0} s.", period)
               : tr("It returns without swinging. The picture begins again every {0} s.", period);
}

}  // namespace

Complex place_in_motion(Complex s, double seconds) {
    const double cycle = seconds / kPeriod - std::floor(seconds / kPeriod);
    if (s.imag() == 0.0 && s.real() > 0.0) { return std::exp(kFolds * (cycle - 1.0)); }
    if (s.imag() == 0.0 && s.real() < 0.0) { return std::exp(-kFolds * cycle); }
    return std::polar(1.0, (2.0 * cycle - 0.5) * std::numbers::pi);
}

void RestTab::begin(const Session& session) {
    lesson_ = session.as_told().lesson;
    sought_ = seek_;
    search_.reset();
    view_ = {};
    failure_.clear();
    choose(kAtRest);
    const auto search = std::make_shared<RestSearch>(*lesson_, RestRequest{.seek = seek_, .held = {}});
    const auto piece = [lesson = lesson_, search](const std::stop_token&) -> std::optional<RestView> {
        if (search->go_on()) { return std::nullopt; }
        return search->view();
    };
    const std::size_t bodies = lesson_->mechanism.bodies.size();
    for (std::size_t k = 0; k < kPiecesAtOnce / (bodies * bodies); ++k) {
        if (auto view = piece({})) { return take(*std::move(view)); }
    }
    search_ = std::make_unique<Background<RestView>>(piece);
}

void RestTab::take(RestView view) {
    view_ = std::move(view);
    failure_ = view_.failure;
    words_ = words_of(view_);
}

void RestTab::choose(int shown) {
    shown_ = shown;
    time_ = 0.0;
    pose_.reset();
    is_drawn_ = false;
    if (shown >= 0) { amplitude_ = amplitude_of(view_, static_cast<std::size_t>(shown)); }
}

bool RestTab::advance(const Session& session, double seconds) {
    const bool is_opened = seen_ == 0;
    const bool is_new = !is_of(session) || sought_ != seek_;
    const bool is_found = has_news() && !is_new;
    try {
        if (is_new) { begin(session); }
        if (is_found) { take(std::exchange(search_, nullptr)->take()); }
    } catch (const std::exception& error) { failure_ = error.what(); }
    if (is_opened && shown_ == kStep) { choose(kAtRest); }
    if (!is_opened && !is_new && seen_ != session.version()) { choose(kStep); }
    seen_ = session.version();
    const bool shows_step = shown_ == kStep || search_ || !failure_.empty();
    if (shows_step || (is_drawn_ && !is_moving())) { return is_new || is_found; }
    if (is_moving()) {
        time_ += seconds;
        const Complex s = view_.outcome.motions.modes[static_cast<std::size_t>(shown_)].s;
        auto pose =
            pose_in_mode(view_, static_cast<std::size_t>(shown_), amplitude_ * place_in_motion(s, time_));
        // between the ends of the motion, a pose may be missing: the last one stays
        if (pose) { pose_ = std::move(pose); }
    }
    picture_ = picture_at_rest(session.story(), session.style(), view_, pose_);
    ++version_;
    is_drawn_ = true;
    return !is_moving();
}

Replacement RestTab::picture(const Session& session) const {
    const bool is_shown = is_drawn_ && is_of(session) && seen_ == session.version();
    return {is_shown ? &picture_ : nullptr, version_};
}

void RestTab::draw(const LessonUi& ui, const Box& box) {
    Area area(ui, "rest", box, true);
    section(ui, tr("Equilibrium of the whole lesson, at t = 0"));
    const bool is_known = is_of(ui.session) && seek_ == sought_ && !search_;
    const std::string& result = failure_.empty() ? words_.verdict : failure_;
    ImGui::TextWrapped("%s", is_known ? result.c_str() : tr("The equilibrium is searched for …"));
    if (const auto seek = radio_buttons(kSeeks, seek_, ui.px(228.0F))) { seek_ = *seek; }
    if (!is_known || !failure_.empty()) { return; }
    controls(ui);
    section(ui, tr("Values at rest"));
    for (const std::string& quantity : words_.quantities) { note(ui, quantity); }
}

void RestTab::controls(const LessonUi& ui) {
    section(ui, tr("The picture shows"));
    const auto radio = [&](const std::string& label, int shown) {
        if (ImGui::RadioButton(label.c_str(), shown_ == shown)) { choose(shown); }
    };
    radio(tr("the step"), kStep);
    radio(tr("the equilibrium"), kAtRest);
    for (std::size_t k = 0; k < words_.motions.size(); ++k) {
        const auto& [in_time, joints] = words_.motions[k];
        radio(tr("small motion {0}", k + 1), static_cast<int>(k));
        note(ui, in_time);
        note(ui, joints);
        if (shown_ == static_cast<int>(k)) { note(ui, how_it_is_shown(view_.outcome.motions.modes[k].s)); }
    }
}

}  // namespace jw::host
