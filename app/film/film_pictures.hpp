#pragma once

#include <vector>

#include "app/session/story/story.hpp"

/// A lesson as a film: its pictures, and how long each is shown.
namespace jw::film {

/// A picture of a film.
struct FilmPicture {
    int step = 0;          ///< of the story; its text and numbers are shown
    double share = 1.0;    ///< part of the way from the previous pose, 0 to 1
    double seconds = 0.0;  ///< how long it is shown

    bool operator==(const FilmPicture&) const = default;
};

struct FilmPace {
    double fps = 30.0;       ///< pictures per second while bodies move
    bool shows_ways = true;  ///< shows the way of bodies that a step moves: Newton, closing joints
};

/// The pictures of the steps `first` to `last`, both included. Stills are shown as long as it takes to read
/// them, the motion at its own pace. The way to a pose takes a part of the time of its step.
std::vector<FilmPicture> pictures_of_film(const Story& story, int first, int last, const FilmPace& pace);

/// Pose between two poses: points move on straight lines, bodies turn evenly about one axis, the shorter way.
/// @param share  0: `from`, 1: `to`
State pose_between(const State& from, const State& to, double share);

/// Total time of the pictures [s].
double seconds_of(const std::vector<FilmPicture>& pictures);

}  // namespace jw::film
