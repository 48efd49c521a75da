#pragma once

#include <vector>

#include "app/session/story/story.hpp"

/// A lesson as a film: which pictures, and how long each is shown.
namespace jw::film {

/// A picture, in the order in which they are shown.
struct FilmPicture {
    int step = 0;          ///< of the story, whose words and numbers it shows
    double share = 1.0;    ///< of the way from the pose before that bodies have come, 0 to 1
    double seconds = 0.0;  ///< how long it is shown

    bool operator==(const FilmPicture&) const = default;
};

struct FilmPace {
    double fps = 30.0;       ///< pictures per second of what moves
    bool shows_ways = true;  ///< bodies are seen on their way where a step moves them: Newton, closing joints
};

/// The pictures of the steps `first` to `last`, both included. Stills are shown as long as it takes to read
/// them, the motion at its own pace. A way takes part of the time of its step.
std::vector<FilmPicture> pictures_of_film(const Story& story, int first, int last, const FilmPace& pace);

/// Pose on the way between two: points go straight, bodies turn evenly about one axis, the shorter way round.
/// @param share  0: `from`, 1: `to`
State pose_between(const State& from, const State& to, double share);

/// Time that all of them take [s].
double seconds_of(const std::vector<FilmPicture>& pictures);

}  // namespace jw::film
