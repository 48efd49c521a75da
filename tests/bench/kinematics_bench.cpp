#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "app/session/story.hpp"
#include "lessons/catalogue.hpp"
#include "lessons/reader.hpp"

/// Speed against error of kinematics: position, velocity and acceleration per moment of a motion, in the four
/// coordinate choices. The error is the largest difference from poses found in (r, ω') at a moment's own
/// accuracy, and the residual of all equations. Times are of one run on one machine: compare them within a
/// table only.
namespace jw::bench {
namespace {

constexpr int kMoments = 200;
constexpr int kRepeats = 5;

struct Result {
    double microseconds = 0.0;  ///< per moment, fastest of the repeats
    double iterations = 0.0;    ///< of Newton, per moment
    double residual = 0.0;      ///< largest |Φ|
    double r_error = 0.0;       ///< [scene's unit of length]
    double omega_error = 0.0;   ///< of ω' [rad/s]
};

struct Moment {
    double t = 0.0;
    State state;
    Motion velocity;
};

/// The motion at equal intervals, found in small steps.
std::vector<Moment> reference_of(const Story& story) {
    const Step& start = story.steps().back();
    const MotionPlan& plan = *story.lesson().motion;
    System system = *start.system;
    MotionTracker tracker(system, start.state, plan.from);
    std::vector<Moment> moments;
    for (int k = 0; k <= kMoments; ++k) {
        const double t = plan.from + (plan.to - plan.from) * k / kMoments;
        if (!tracker.advance_to(t)) { return {}; }
        moments.push_back({t, tracker.frame().state, tracker.frame().velocity});
    }
    return moments;
}

/// Every moment from the pose of the one before.
template <class C>
Result measured(const System& system, const std::vector<Moment>& moments) {
    NewtonStepper<C> newton(system);
    Kinematics<C> kinematics(system);
    Result result;
    result.microseconds = 1e300;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        int iterations = 0;
        double seconds = 0.0;
        for (std::size_t k = 1; k < moments.size(); ++k) {
            const auto begin = std::chrono::steady_clock::now();
            newton.start(moments[k - 1].state, moments[k].t);
            const NewtonOutcome outcome = solve(newton);
            kinematics.set_state(newton.state(), moments[k].t);
            const VelocityOutcome velocity = kinematics.solve_velocity(moments[k].velocity);
            const AccelerationOutcome acceleration = kinematics.solve_acceleration(velocity.velocity);
            seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

            iterations += outcome.iterations;
            result.residual = std::max(result.residual, outcome.residual);
            for (const int body : system.moving_bodies()) {
                const auto b = static_cast<std::size_t>(body);
                result.r_error = std::max(
                    result.r_error,
                    (newton.state().r[b] - moments[k].state.r[b]).norm() / system.length_unit());
                result.omega_error = std::max(
                    result.omega_error,
                    (velocity.velocity.omega_local[b] - moments[k].velocity.omega_local[b]).norm());
            }
        }
        result.microseconds =
            std::min(result.microseconds, 1e6 * seconds / (static_cast<double>(moments.size()) - 1.0));
        result.iterations = static_cast<double>(iterations) / (static_cast<double>(moments.size()) - 1.0);
    }
    return result;
}

void print(const char* choice, const Result& r, const Result& first) {
    std::printf(
        "  %-14s %9.1f %7.2f %9.1f   %8.1e   %8.1e   %8.1e\n", choice, r.microseconds,
        r.microseconds / first.microseconds, r.iterations, r.residual, r.r_error, r.omega_error);
}

void run(const std::filesystem::path& file) {
    const ReadResult read = read_lesson_file(file);
    if (!read.lesson || !read.lesson->motion || read.lesson->mechanism.drivers.empty()) { return; }
    const Story story(*read.lesson, poses_only());
    if (story.failure() != nullptr) { return; }
    const std::vector<Moment> moments = reference_of(story);
    if (moments.empty()) { return; }
    const System& system = *story.steps().back().system;
    std::printf(
        "%s: %d moving bodies, %d equations\n", file.stem().c_str(),
        static_cast<int>(system.moving_bodies().size()), system.rows());
    const Result local = measured<OmegaLocal>(system, moments);
    print("omega-local", local, local);
    print("omega-global", measured<OmegaGlobal>(system, moments), local);
    print("rp", measured<TrueEulerParameters>(system, moments), local);
    print("rp-modified", measured<ModifiedEulerParameters>(system, moments), local);
}

}  // namespace
}  // namespace jw::bench

int main() {
    std::printf(
        "position + velocity + acceleration per moment, each from the pose before\n"
        "  coordinates    us/moment   ratio iterations  residual    r error    omega error [rad/s]\n");
    for (const auto& file : jw::lessons_below(jw::catalogue_folder())) {
        // lessons of that chapter fail on purpose
        if (file.parent_path().filename() != "hard") { jw::bench::run(file); }
    }
    return 0;
}
