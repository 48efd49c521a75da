#include <emscripten/emscripten.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/integrate/simulation.hpp"
#include "core/jets/euler_parameters.hpp"
#include "lessons/read/reader.hpp"
#include "tests/bench/peers/mjcf.hpp"
#include "tests/bench/peers/read_scene.hpp"

/// Our half of ./dev peers --only mujoco-web: describes a lesson to race.mjs, and runs it.
namespace jw::peers {
namespace {

using Json = nlohmann::json;

Lesson lesson;
PeerScene scene;
std::string answer;  ///< the last one; JavaScript copies it

Json json_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Energies at the start and, body by body, r̈ of the centre and ω̇, both global: a model of this scene must
/// agree with them.
void add_start(Json& out) {
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, {});
    std::vector<double> start;
    (void)simulation.run({0.0}, [&](double, const std::vector<double>& y) { start = y; });
    const Snapshot snapshot = simulation.snapshot(0.0, start);
    out["kinetic"] = snapshot.kinetic;
    out["potential"] = snapshot.potential;
    const Motion of_centres = simulation.acceleration(0.0, start);
    const Motion as_given = simulation.acceleration_as_given(0.0, start);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const Vec3 omega_dot = rotation_matrix(snapshot.state.p[b]) * as_given.omega_local[b];
        out["accelerations"].push_back({json_of(of_centres.r_dot[b]), json_of(omega_dot)});
    }
}

Json json_of_model(std::string_view hinges) {
    Json out{{"hinges", hinges}, {"text", mjcf(scene, hinges)}};
    for (const PeerJoint& joint : scene.tree) {
        out["rates"].push_back({joint.child, rates_of(scene, joint, hinges)});
    }
    return out;
}

Json json_of_scene() {
    Json out{
        {"name", scene.name},
        {"duration", scene.duration},
        {"gravity", json_of(scene.gravity)},
        {"body", scene.body},
        {"point", json_of(from_centre(scene, scene.body, scene.point))},
        {"loops", scene.loops.size()},
        {"models", {json_of_model({})}},
        {"wrenches", Json::array()}};
    const auto turns_freely = [](const PeerJoint& joint) {
        return joint.kind == Kind::spherical || joint.kind == Kind::free;
    };
    if (std::ranges::any_of(scene.tree, turns_freely)) {
        for (const char* hinges : {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"}) {
            out["models"].push_back(json_of_model(hinges));
        }
    }
    for (const PeerWrench& w : scene.wrenches) {
        out["wrenches"].push_back({w.body, json_of(w.force), json_of(w.torque)});
    }
    for (const Vec3& r : scene.reference) { out["reference"].push_back(json_of(r)); }
    for (const MethodName& method : kMethods) {
        if (method.adaptive) { out["methods"].push_back({method.method, method.name}); }
    }
    add_start(out);
    return out;
}

Json opened(const char* file, const char* reference) {
    ReadResult read = read_lesson_file(file);
    if (!read.lesson) { return {{"why_not", read.report()}}; }
    lesson = std::move(*read.lesson);
    std::string why_not;
    const auto found = read_scene(lesson, reference, why_not);
    if (!found) { return {{"why_not", why_not}}; }
    scene = *found;
    return json_of_scene();
}

}  // namespace
}  // namespace jw::peers

extern "C" {

/// @return the scene as JSON, or an object with the reason `why_not`
EMSCRIPTEN_KEEPALIVE const char* open_scene(const char* file, const char* reference) {
    jw::peers::answer = jw::peers::opened(file, reference).dump();
    return jw::peers::answer.c_str();
}

/// Sets the equations up and integrates the scene, every step proved.
/// @param patience  [ms] of the wall clock: WebAssembly has no other one
/// @return largest distance of the point from the reference at the 100 samples [m]; infinite if the run did
/// not get to the end
EMSCRIPTEN_KEEPALIVE double run_scene(int method, double tolerance, double patience) {
    using namespace jw;
    using peers::lesson, peers::scene;
    const double end = emscripten_get_now() + patience;
    SimulationSettings settings;
    settings.method = static_cast<Method>(method);
    settings.tolerance = tolerance;
    Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    std::vector<double> times;
    for (int k = 0; k <= 100; ++k) { times.push_back(scene.duration * k / 100.0); }
    const auto& point = *lesson.dynamics->point;
    std::size_t samples = 0;
    double error = 0.0;
    const auto receive = [&](double, const std::vector<double>& y) {
        const Vec3 off = simulation.point(y, point.body, point.point_local) - scene.reference[samples++];
        error = std::max(error, off.norm());
    };
    const SimulationOutcome outcome =
        simulation.run(times, receive, [&](const RunState&) { return emscripten_get_now() < end; });
    return outcome.failure || samples != times.size() ? std::numeric_limits<double>::infinity() : error;
}
}
