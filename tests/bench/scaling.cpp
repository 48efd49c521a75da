#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/integrate/simulation.hpp"
#include "tests/bench/clock.hpp"
#include "tests/support/dynamics_scenes.hpp"

/// `scaling`: microseconds of one evaluation of the equations of motion from 10 to 1000 bodies, in both kinds
/// of coordinates, and the exponent of the growth: 1 is linear in the number of bodies.
namespace {

using namespace jw;

double evaluation_time(const Lesson& lesson, Formulation formulation) {
    SimulationSettings settings;
    settings.formulation = formulation;
    const Simulation simulation(lesson.mechanism, lesson.dynamics->loads, settings);
    MotionEquations& equations = simulation.integrated();
    const std::vector<double> y = simulation.integrated_start();
    std::vector<double> y_dot(y.size());
    equations.choose_rows(0.0, y.data());
    const int count = std::max(4, 20'000 / equations.bodies());
    const double time = least_time([&] {
        for (int k = 0; k < count; ++k) { equations.evaluate(0.0, y.data(), y_dot.data()); }
    });
    return time / count;
}

struct Family {
    const char* name;
    Lesson (*of)(int bodies);
};

constexpr std::array kFamilies{
    Family{"hinge chain", [](int bodies) { return test::chain(test::ChainJoint::revolute, bodies); }},
    Family{"ball chain", [](int bodies) { return test::chain(test::ChainJoint::spherical, bodies); }},
    // n windows have 2 n + 1 rods
    Family{"n four-bar", [](int bodies) { return test::n_four_bar(bodies / 2); }}};
constexpr std::array kBodies{10, 30, 100, 300, 1000};

void measure(const Family& family, const FormulationName& coordinates) {
    std::printf("%-12s %-8s", family.name, std::string(coordinates.name).c_str());
    double first = 0.0;
    double last = 0.0;
    for (const int bodies : kBodies) {
        last = evaluation_time(family.of(bodies), coordinates.formulation);
        if (first == 0.0) { first = last; }
        std::printf("%9.2f", last);
        std::fflush(stdout);
    }
    const double times_as_many = static_cast<double>(kBodies.back()) / kBodies.front();
    std::printf("%10.3f\n", std::log(last / first) / std::log(times_as_many));
}

}  // namespace

int main() {
    std::printf("us of an evaluation of  ");
    for (const int bodies : kBodies) { std::printf("%6d   ", bodies); }
    std::printf("bodies; exponent\n");
    for (const Family& family : kFamilies) {
        for (const FormulationName& coordinates : kFormulations) { measure(family, coordinates); }
    }
    return 0;
}
