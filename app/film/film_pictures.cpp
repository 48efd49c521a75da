#include "app/film/film_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/session/output/pace.hpp"

namespace jw::film {

namespace {

// part of the time of a step in which bodies move; the rest is for reading
constexpr double kLongestWay = 0.8;   // s
constexpr double kMostOfAStep = 0.5;  // of its time
// a smaller move is not visible: about a pixel of the picture
constexpr double kSmallestMove = 1e-3;  // of the size of the mechanism, and rad

/// The largest move of a body between two poses, relative to the size of the mechanism, or in rad.
double move_between(const State& from, const State& to, double size) {
    double most = 0.0;
    for (std::size_t k = 0; k < to.r.size(); ++k) {
        most = std::max(most, (to.r[k] - from.r[k]).norm() / size);
        // for small angles |p - p'| is half the angle; p and -p are the same rotation
        const double turn = std::min((to.p[k] - from.p[k]).norm(), (to.p[k] + from.p[k]).norm());
        most = std::max(most, 2.0 * turn);
    }
    return most;
}

/// Distance from the middle of all bodies to the farthest one [m], the scale of visible moves.
double size_of(const State& state) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& r : state.r) { middle += r / static_cast<double>(state.r.size()); }
    double size = 0.0;
    for (const Vec3& r : state.r) { size = std::max(size, (r - middle).norm()); }
    return size > 0.0 ? size : 1.0;
}

/// The share of the way at a share of the time, slow at both ends.
double eased(double share) { return share * share * (3.0 - 2.0 * share); }

/// @param from,to  of unit length
Vec4 turned_between(const Vec4& from, Vec4 to, double share) {
    double cosine = from.dot(to);
    if (cosine < 0.0) {
        to = -to;
        cosine = -cosine;
    }
    const double angle = std::acos(std::min(cosine, 1.0));
    // below this, sine and angle agree to the last bit
    if (angle < 1e-8) { return (from + share * (to - from)).normalized(); }
    return (std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / std::sin(angle);
}

}  // namespace

State pose_between(const State& from, const State& to, double share) {
    if (share >= 1.0) { return to; }
    State between = to;
    for (std::size_t k = 0; k < to.r.size(); ++k) {
        between.r[k] = from.r[k] + share * (to.r[k] - from.r[k]);
        between.p[k] = turned_between(from.p[k].normalized(), to.p[k].normalized(), share);
    }
    for (std::size_t k = 0; k < std::min(to.theta.size(), from.theta.size()); ++k) {
        between.theta[k] = from.theta[k] + share * (to.theta[k] - from.theta[k]);
    }
    return between;
}

std::vector<FilmPicture> pictures_of_film(const Story& story, int first, int last, const FilmPace& pace) {
    std::vector<FilmPicture> pictures;
    for (int k = first; k <= last; ++k) {
        const View view = view_of(story, k, ViewParts::without_matrix);
        const double seconds = seconds_to_look(view, 1.0 / pace.fps);
        const State& pose = story.steps()[at(k)].state;
        const bool may_move = pace.shows_ways && k > first && view.kind != Step::Kind::motion;
        int ways = 0;
        if (may_move) {
            const State& before = story.steps()[at(k - 1)].state;
            if (move_between(before, pose, size_of(pose)) > kSmallestMove) {
                ways = static_cast<int>(std::min(kLongestWay, kMostOfAStep * seconds) * pace.fps);
            }
        }
        for (int n = 0; n < ways; ++n) {
            pictures.push_back({k, eased((n + 1.0) / (ways + 1.0)), 1.0 / pace.fps});
        }
        pictures.push_back({k, 1.0, seconds - ways / pace.fps});
    }
    return pictures;
}

double seconds_of(const std::vector<FilmPicture>& pictures) {
    return std::accumulate(pictures.begin(), pictures.end(), 0.0, [](double sum, const FilmPicture& picture) {
        return sum + picture.seconds;
    });
}

}  // namespace jw::film
