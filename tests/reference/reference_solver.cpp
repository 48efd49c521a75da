#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>

#include "tests/reference/closed_forms.hpp"
#include "tests/reference/formulations.hpp"
#include "tests/reference/scenes.hpp"
#include "tests/reference/stored.hpp"

/// Computes the benchmark scenes in long double, each in at least two ways, and prints how far they differ.
namespace jw::reference {
namespace {

struct Way {
    std::string name;
    Trajectory trajectory;
};

/// Trajectories of a scene in several ways; the first is the one to store.
std::vector<Way> computed(const Scene& scene) {
    std::vector<Way> ways;
    const auto add = [&](const char* name, const auto& compute) {
        const std::clock_t begin = std::clock();
        ways.push_back({name, compute()});
        const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        const Sample& end = ways.back().trajectory.back();
        std::printf(
            "  %-58s %20.15Lf %20.15Lf %20.15Lf  %8.2f s\n", name, end.r.x(), end.r.y(), end.r.z(), seconds);
        std::fflush(stdout);
    };
    if (closed_form(scene)) {
        add("elliptic functions", [&] { return *closed_form(scene); });
    }
    if (scene.passes_singular) {
        // close to the separatrix: the rounding of extrapolation, ten times larger, costs a digit here
        add("joint coordinates, Runge-Kutta-Fehlberg 7(8), 1e-18", [&] {
            return integrate(*joint_coordinates(scene), scene.duration, Method::runge_kutta_fehlberg, 1e-18L);
        });
        return ways;
    }
    add("absolute coordinates, Runge-Kutta-Fehlberg 7(8), 1e-17", [&] {
        return integrate(*absolute_coordinates(scene), scene.duration, Method::runge_kutta_fehlberg, 1e-17L);
    });
    char name[80];
    std::snprintf(name, sizeof name, "joint coordinates, extrapolation of order 14, %.0Le", scene.finest);
    add(name, [&] {
        return integrate(*joint_coordinates(scene), scene.duration, Method::extrapolation, scene.finest);
    });
    return ways;
}

/// Largest distance of the first way from the others.
Real agreement(const std::vector<Way>& ways) {
    Real most = 0.0L;
    for (std::size_t k = 1; k < ways.size(); ++k) {
        most = std::max(most, largest_distance(ways[0].trajectory, ways[k].trajectory));
    }
    return most;
}

/// Number of digits after the point in which all ways agree, at most as many as a file holds.
int trusted_digits(Real distance) {
    return std::min(16, static_cast<int>(std::floor(-std::log10(std::max(distance, 1e-30L)))));
}

std::string header_of(const Scene& scene, const std::vector<Way>& ways, Real distance) {
    std::string text = scene.name + " (" + scene.what + "): " + ways[0].name;
    for (std::size_t k = 1; k < ways.size(); ++k) {
        text += (k == 1 ? "; checked by " : " and ") + ways[k].name;
    }
    char numbers[80];
    std::snprintf(
        numbers, sizeof numbers, "; long double; at most %.0Le m apart; %d digits trusted", distance,
        trusted_digits(distance));
    return text + numbers;
}

void run(const Scene& scene, const char* folder) {
    std::printf("%s\n", scene.name.c_str());
    const std::vector<Way> ways = computed(scene);
    const Real distance = agreement(ways);
    std::printf("  at most %.1Le m apart\n", distance);
    if (folder == nullptr) { return; }
    write_trajectory(
        std::filesystem::path(folder) / (scene.name + ".csv"), header_of(scene, ways, distance),
        scene.duration, ways[0].trajectory);
}

}  // namespace
}  // namespace jw::reference

/// reference_solver [--write FOLDER] [NAME...]
int main(int count, char** arguments) {
    const char* folder = nullptr;
    std::vector<std::string> names;
    for (int k = 1; k < count; ++k) {
        if (std::strcmp(arguments[k], "--write") == 0 && k + 1 < count) {
            folder = arguments[++k];
        } else {
            names.emplace_back(arguments[k]);
        }
    }
    for (const auto& scene : jw::reference::all_scenes()) {
        const bool wanted = names.empty() || std::ranges::find(names, scene.name) != names.end();
        if (wanted) { jw::reference::run(scene, folder); }
    }
    return 0;
}
