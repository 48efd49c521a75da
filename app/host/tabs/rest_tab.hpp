#pragma once

#include <complex>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/host/ui/ui.hpp"
#include "app/session/background/background.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/rest/rest.hpp"

namespace jw::host {

/// Place in a small motion with exponent `s` at a time of its display: z of pose_in_mode with |z| ≤ 1. An
/// oscillation starts at the equilibrium; any other motion begins again after each period.
std::complex<double> place_in_motion(std::complex<double> s, double seconds);

/// The tab "At rest": the equilibrium of the lesson and the small motions about it, one of which the picture
/// shows. They belong to the whole lesson, whatever step is shown. Only lessons with [dynamics] have this
/// tab.
class RestTab {
public:
    void draw(const LessonUi& ui, const panels::Box& box);
    /// Searches, and moves the picture on; call it after each frame in which the tab is shown.
    /// @param seconds  since the last frame, at the speed of the display
    /// @return true if the next frame must be drawn at once
    bool advance(const Session& session, double seconds);

    /// Picture in place of the step's; none while the step is shown.
    Replacement picture(const Session& session) const;
    /// Shows the step again, until the tab is opened the next time or a pose is chosen.
    void show_step() { choose(kStep); }
    /// Call it while another tab is shown. When this one is opened again, the picture shows the same motion
    /// or the equilibrium.
    void leave() { seen_ = 0; }

    /// True while the equilibrium is computed in the background.
    bool is_searching() const { return search_ != nullptr; }
    /// True if the search has ended: the next frame takes over its result.
    bool has_news() const { return search_ && search_->is_done(); }
    void wait() {
        if (search_) { search_->wait(); }
    }
    /// True while a small motion is shown.
    bool is_moving() const { return shown_ >= 0; }
    /// The equilibrium; its outcome is empty until it is found.
    const RestView& found() const { return view_; }
    /// The pose that the picture shows; none while it shows the step or the equilibrium.
    const std::optional<State>& pose() const { return pose_; }

private:
    // what the picture shows; small motions count from 0
    static constexpr int kStep = -2;
    static constexpr int kAtRest = -1;

    void begin(const Session& session);
    void take(RestView view);
    void choose(int shown);
    void controls(const LessonUi& ui);

    bool is_of(const Session& session) const { return lesson_.get() == &session.lesson(); }

    std::shared_ptr<const Lesson> lesson_;  ///< whose equilibrium is searched for
    Seek seek_ = Seek::where_it_rests;
    Seek sought_ = Seek::where_it_rests;  ///< of the search
    std::unique_ptr<Background<RestView>> search_;
    RestView view_;
    RestWords words_;
    std::string failure_;

    std::uint64_t seen_ = 0;  ///< version of the session: if it changes, the picture shows the step
    int shown_ = kStep;
    double amplitude_ = 0.0;  ///< of the motion that is shown [rad, extents]
    double time_ = 0.0;       ///< since it was chosen [s]
    std::optional<State> pose_;
    Picture picture_;
    bool is_drawn_ = false;      ///< picture_ shows what was chosen
    std::uint64_t version_ = 0;  ///< of picture_
};

}  // namespace jw::host
