#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/clock.hpp"
#include "tests/bench/peers/peer_scene.hpp"

/// Parts that all peers share: the error, the clock, the table.
namespace jw::peers {

/// One run: watches the point at the 100 sample times and the clock.
class Run {
public:
    Run(const PeerScene& scene, double seconds_allowed)
        : scene_(&scene), begin_(cpu_microseconds()), allowed_(seconds_allowed) {}

    /// Point at sample `k`, 1 to 100.
    void at_sample(int k, const Vec3& point);
    double sample_time(int k) const { return scene_->duration * k / 100.0; }
    bool out_of_time() const { return milliseconds() > 1e3 * allowed_; }
    bool complete() const { return samples_ == 100; }
    double error() const;
    double milliseconds() const { return 1e-3 * (cpu_microseconds() - begin_); }

private:
    const PeerScene* scene_;
    double begin_;    ///< [us]
    double allowed_;  ///< [s]
    int samples_ = 0;
    double error_ = 0.0;
};

struct Outcome {
    double milliseconds = 0.0;
    double error = 0.0;  ///< largest distance from the reference [m]; infinite if it did not get to the end
    long evaluations = 0;
    long projections = 0;  ///< onto the constraints, where they can be counted
    std::string remark;    ///< why it did not, in the engine's words
    bool out_of_time = false;
};

/// Error below which a method is not run with tighter tolerances [m].
inline constexpr double kEnough = 1e-10;

/// Ratio of successive tolerances of a sweep. With a coarser ratio, luck would decide which method is first.
inline constexpr double kTighter = 0.5623413251903491;  // four a decade

/// Least time of the same run, repeated until 20 ms or five runs are over: its cost when nothing else
/// disturbs it and everything is in the caches.
Outcome least_of_several(const std::function<Outcome()>& run);

/// Rows of one peer and scene as CSV to stdout, and at the end to stderr what the errors 1e-3, 1e-6 and 1e-9
/// cost at the best settings.
class Report {
public:
    Report(std::string peer, const PeerScene& scene) : peer_(std::move(peer)), scene_(&scene) {}
    void add(const std::string& method, const std::string& setting, const Outcome& outcome);
    void print_best() const;
    /// Writes to stderr the fewest evaluations for the same errors, of these rows and of ours. A tolerance
    /// counts where the three tighter ones that follow in the sweep keep the error as well, so that a single
    /// lucky one does not count.
    void print_fewest_beside(const Report& ours) const;

private:
    struct Row {
        std::string method, setting;
        double milliseconds, error;
        long evaluations, projections;
        bool out_of_time;
    };
    bool is_kept(std::size_t row, double level) const;
    /// Null: no row counts.
    const Row* fewest_at(double level) const;
    std::string peer_;
    const PeerScene* scene_;
    std::vector<Row> rows_;
};

/// Measures a scene by adding rows; no run takes longer than `limit` seconds.
using Measure = std::function<void(const PeerScene& scene, double limit, Report& report)>;

/// Quantities that are compared with ours: time only, or evaluations too, where both evaluate the same
/// equations.
enum class Compared { time, evaluations };

/// The arguments of a peer's program: [--limit SECONDS] [LESSON.toml...]. Without lessons: all below lessons/
/// that have a reference. After the peer every scene is measured with Jointwise. @return exit status
int for_every_scene(
    int count, char** arguments, const char* peer, const Measure& measure,
    Compared compared = Compared::time);

}  // namespace jw::peers
