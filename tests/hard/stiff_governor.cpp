#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"

namespace jw::hard {

Result stiff_governor() {
    const DynamicScene scene = shipped_scene("dynamics/governor.toml");
    const double share = 0.1;  // the first second
    const auto run = [&](Method method, double tolerance) {
        return run_of(scene, adaptive(method, tolerance), share);
    };
    const Trajectory naive_coarse = run(Method::explicit_8, 1e-3);
    const Trajectory naive_fine = run(Method::explicit_8, 1e-7);
    const Trajectory coarse = run(Method::implicit_5, 1e-3);
    const Trajectory fine = run(Method::implicit_9, 1e-8);
    const double naive_gain = double(naive_fine.counts.evaluations) / double(naive_coarse.counts.evaluations);

    Result result;
    result.naive = "the dampers require short steps at any tolerance, so a lower accuracy saves nothing.";
    result.ours = "the step follows the visible motion, and errors follow the tolerance.";
    // stability limits the naive steps at any tolerance, so their number is bounded below by half the
    // measured count. Ours is bounded above by twice the measured count, its errors by one tolerance at 1e-3
    // and ten at 1e-8
    result.measurements = {
        of_both(
            "evaluations in 1 s, tolerance 1e-3", double(naive_coarse.counts.evaluations), at_least(5000),
            double(coarse.counts.evaluations), at_most(500)),
        of_both("position error there [m]", naive_coarse.position, any(), coarse.position, at_most(1e-3)),
        of_both(
            "evaluations, tolerance 1e-7 (naive), 1e-8", double(naive_fine.counts.evaluations),
            at_least(5000), double(fine.counts.evaluations), at_most(2500)),
        of_both("position error there [m]", naive_fine.position, any(), fine.position, at_most(1e-7)),
        of_naive("evaluations, tight by loose tolerance", naive_gain, at_most(1.5)),
    };
    return result;
}

}  // namespace jw::hard
