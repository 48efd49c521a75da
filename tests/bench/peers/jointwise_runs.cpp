#include "tests/bench/peers/jointwise_runs.hpp"

#include <cstdio>

#include "core/integrate/simulation.hpp"

namespace jw::peers {

namespace {

Outcome simulate(
    const Lesson& lesson, const PeerScene& scene, const SimulationSettings& settings, double limit) {
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    // the clock starts here: the models of the other engines are also built before theirs starts
    Run run(scene, limit);
    std::vector<double> times{0.0};
    for (int k = 1; k <= 100; ++k) { times.push_back(run.sample_time(k)); }
    const auto& point = *lesson.dynamics->point;
    int sample = 0;
    const SimulationOutcome outcome = simulation.run(times, [&](double, const std::vector<double>& y) {
        if (sample > 0) { run.at_sample(sample, simulation.point(y, point.body, point.point_local)); }
        ++sample;
    });
    Outcome out;
    out.milliseconds = run.milliseconds();
    out.error = run.error();
    out.evaluations = outcome.counts.evaluations;
    out.projections = outcome.counts.projections;
    out.out_of_time = run.out_of_time();
    if (outcome.failure) { out.remark = "ended early"; }
    return out;
}

}  // namespace

void measure_jointwise(const Lesson& lesson, const PeerScene& scene, double limit, Report& report) {
    for (const MethodName& method : kMethods) {
        if (!method.adaptive) { continue; }
        SimulationSettings settings;
        settings.method = method.method;
        for (settings.tolerance = 1e-2; settings.tolerance > 1e-13; settings.tolerance *= kTighter) {
            const Outcome outcome =
                least_of_several([&] { return simulate(lesson, scene, settings, limit); });
            char setting[30];
            std::snprintf(setting, sizeof setting, "tolerance %.1e", settings.tolerance);
            report.add(std::string(method.name), setting, outcome);
            if (outcome.out_of_time || outcome.error < kEnough) { break; }
        }
    }
}

}  // namespace jw::peers
