#include "app/host/lesson/playback.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/session/output/pace.hpp"
#include "app/session/story/timeline.hpp"

namespace jw::host {

namespace {

constexpr double kSlowest = 0.25;
constexpr double kFastest = 4.0;
constexpr double kFreedomSeconds = 3.0;  // there and back
constexpr double kCountdown = 0.25;      // time between two updates of the countdown [s]

}  // namespace

void Playback::play_or_pause() {
    playing_ = !playing_;
    step_waited_ = 0.0;
}

void Playback::play() {
    playing_ = true;
    step_waited_ = 0.0;
}

void Playback::faster() { speed_ = std::min(kFastest, 2.0 * speed_); }

void Playback::slower() { speed_ = std::max(kSlowest, 0.5 * speed_); }

void Playback::next_speed() { speed_ = speed_ < kFastest ? 2.0 * speed_ : kSlowest; }

void Playback::begin_step() {
    step_waited_ = 0.0;
    freedom_ = -1;
}

void Playback::stop() {
    begin_step();
    playing_ = false;
}

void Playback::follow(int freedom) {
    playing_ = false;
    freedom_ = freedom;
    freedom_time_ = 0.0;
}

std::optional<int> Playback::step_after(double seconds, const Session& session) {
    if (!playing_) { return std::nullopt; }
    const int last = last_step(session.story());
    const double due = seconds_of_step(session.story(), session.view());
    step_waited_ += seconds * speed_;
    int step = session.index();
    while (step < last && step_waited_ >= due) {
        step_waited_ -= due;
        ++step;
        // moments of a motion are equally long; any other step is shown from its beginning
        const Step& reached = session.story().steps()[static_cast<std::size_t>(step)];
        if (session.step().kind != Step::Kind::motion || reached.kind != Step::Kind::motion) {
            step_waited_ = 0.0;
            break;
        }
    }
    playing_ = step != last;
    return step == session.index() ? std::nullopt : std::optional<int>(step);
}

std::optional<ShowFreedom> Playback::freedom_after(double seconds) {
    if (freedom_ < 0) { return std::nullopt; }
    freedom_time_ += seconds * speed_;
    const double turn = 2.0 * std::numbers::pi * freedom_time_ / kFreedomSeconds;
    return ShowFreedom{freedom_, std::sin(turn)};
}

std::optional<double> Playback::seconds_to_next_still(const Session& session) const {
    if (!playing_ || session.step().kind == Step::Kind::motion) { return std::nullopt; }
    const double step = seconds_of_step(session.story(), session.view());
    return std::max(0.0, (step - step_waited_) / speed_);
}

double Playback::seconds_to_change(const Session& session) const {
    if (freedom_ >= 0) { return kMoving; }
    if (!playing_) { return std::numeric_limits<double>::infinity(); }
    const double step = seconds_of_step(session.story(), session.view());
    const double left = (step - step_waited_) / speed_;
    // during a still, the timeline shows a countdown
    return std::max(kMoving, session.step().kind == Step::Kind::motion ? left : std::min(left, kCountdown));
}

}  // namespace jw::host
