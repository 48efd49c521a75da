#include "app/session/try/hand.hpp"

#include <algorithm>
#include <cmath>

namespace jw {

namespace {

// steps along a free motion, each way: enough to see where it leads, and small enough to stay on it
constexpr int kFollowSteps = 24;

}  // namespace

int closed_step(const Story& story, int index) {
    const auto open = [&](int k) {
        const Step::Kind kind = story.steps()[at(k)].kind;
        return kind == Step::Kind::equations || kind == Step::Kind::iteration || kind == Step::Kind::failed;
    };
    while (index > 0 && open(index)) { --index; }
    return index;
}

Hand::Hand(const Story& story, int index) {
    const Step& held = story.steps()[at(closed_step(story, index))];
    step_ = held;
    step_.rank = nullptr;
    step_.failure.reset();
    step_.ended.clear();
    start_ = held.state;
    system_ = std::make_unique<System>(*held.system);
}

DragOutcome Hand::pull(int body, const Vec3& point_local, const Vec3& target) {
    if (!dragger_) { dragger_ = std::make_unique<Dragger>(*system_, step_.state, step_.t); }
    const DragOutcome outcome = dragger_->pull(body, point_local, target);
    show(dragger_->state());
    return outcome;
}

bool Hand::follow(int motion, double part) {
    if (!followed_ || motion != followed_motion_) {
        const RankReport report = rank_of(*system_, start_, step_.t);
        if (motion < 0 || motion >= static_cast<int>(report.free_motions.size())) { return false; }
        followed_ = follow_free_motion(
            *system_, start_, step_.t, report.free_motions[at(motion)], kFollowSteps, kFreedomStep);
        followed_motion_ = motion;
    }
    const auto last = static_cast<int>(followed_->states.size()) - 1;
    const int way = part < 0.0 ? followed_->start : last - followed_->start;
    const auto steps = static_cast<int>(std::lround(std::clamp(part, -1.0, 1.0) * way));
    show(followed_->states[at(followed_->start + steps)]);
    return true;
}

void Hand::show(const State& state) {
    step_.state = state;
    step_.rank = nullptr;
    // the rows may have been chosen again on the way
    auto system = std::make_shared<System>(*system_);
    system->choose_rows(state);
    step_.system = system;
}

}  // namespace jw
