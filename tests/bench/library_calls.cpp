#include <cstdio>
#include <string>

#include "jointwise/evaluator.hpp"
#include "jointwise/lesson.hpp"
#include "jointwise/trajectory.hpp"
#include "tests/bench/clock.hpp"

/// `library_calls LESSON`: microseconds of one call of functions of the library, one a line. python_calls.py
/// compares them with the same calls from Python.
namespace {

using namespace jointwise;

template <class F>
void show(const char* name, F&& f) {
    constexpr int kCalls = 2000;
    const double time = jw::least_time([&] {
        for (int k = 0; k < kCalls; ++k) { f(); }
    });
    std::printf("%s %.3f\n", name, time / kCalls);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::fprintf(stderr, "usage: library_calls LESSON, with drivers\n");
        return 2;
    }
    const Lesson lesson = read_lesson(argv[1]);
    const Mechanism& m = lesson.mechanism();
    const Pose pose = assemble(m);
    Evaluator evaluator(m);
    const Rates rates = evaluator.velocities_at(pose);
    Equations e;
    Eigen::VectorXd phi;
    double kept = 0.0;
    show("evaluator.equations_at", [&] {
        Equations fresh;
        evaluator.equations_at(pose, rates, fresh);
        kept += fresh.phi(0);
    });
    show("evaluator.equations_at(out)", [&] { evaluator.equations_at(pose, rates, e); });
    show("evaluator.phi_at", [&] { evaluator.phi_at(pose, phi); });
    show("evaluator.columns_of", [&] { kept += evaluator.columns_of(pose, rates)(0); });
    show("evaluator.velocities_at", [&] { kept += evaluator.velocities_at(pose).r_dot[0].x(); });
    show("evaluator.accelerations_at", [&] { kept += evaluator.accelerations_at(pose, rates).r_dot[0].x(); });
    show("evaluator.assemble", [&] { kept += evaluator.assemble(pose, pose.t).r[0].x(); });
    show("equations_at", [&] { kept += equations_at(m, pose, rates).phi(0); });
    show("velocities_at", [&] { kept += velocities_at(m, pose).r_dot[0].x(); });
    if (kept == 1e300) { std::puts("never: it only keeps the calls alive"); }
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
