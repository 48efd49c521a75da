#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/dynamics/simulation.hpp"
#include "lessons/reader.hpp"
#include "tests/bench/clock.hpp"

/// `evaluations LESSON joints|bodies COUNT [--time]`: so many accelerations at the start of a lesson of
/// dynamics, and nothing else. ./dev count runs it twice under callgrind; the difference is what one
/// evaluation costs. --time prints microseconds of an evaluation and the flops that this core does in a
/// microsecond at its best.
namespace {

using namespace jw;

/// Products and sums of two lanes, the width that the program is compiled for, none of which waits for
/// another.
double peak_flops_per_microsecond() {
    using Pair = double __attribute__((vector_size(16)));
    constexpr int kRounds = 2'000'000;
    std::array<Pair, 6> products;
    std::array<Pair, 6> sums;
    products.fill(Pair{1.0, 1.0});
    sums.fill(Pair{1.0, 1.0});
    const Pair factor{1.0 + 1e-9, 1.0 - 1e-9};
    const Pair term{1e-9, -1e-9};
    const double time = least_time([&] {
        std::array<Pair, 6> p = products;
        std::array<Pair, 6> s = sums;
        for (int round = 0; round < kRounds; ++round) {
            for (Pair& x : p) { x *= factor; }
            for (Pair& x : s) { x += term; }
        }
        products = p;
        sums = s;
    });
    if (products[0][0] + sums[0][0] == 0.0) { std::puts("never: it only keeps the loop alive"); }
    return 24.0 * kRounds / time;
}

}  // namespace

int main(int argc, char** argv) {
    const bool times = argc == 5 && std::string_view(argv[4]) == "--time";
    const bool complete = argc == 4 || times;
    const ReadResult read = complete ? read_lesson_file(argv[1]) : ReadResult{};
    const auto formulation =
        std::ranges::find(kFormulations, std::string_view(complete ? argv[2] : ""), &FormulationName::name);
    if (!read.lesson || !read.lesson->dynamics || formulation == kFormulations.end()) {
        std::fprintf(
            stderr, "usage: evaluations LESSON joints|bodies COUNT [--time], for a lesson with [dynamics]\n");
        return 2;
    }
    SimulationSettings settings;
    settings.formulation = formulation->formulation;
    const Simulation simulation(read.lesson->mechanism, read.lesson->dynamics->loads, settings);
    MotionEquations& equations = simulation.integrated();
    const std::vector<double> y = simulation.integrated_start();
    std::vector<double> y_dot(y.size());
    equations.choose_rows(0.0, y.data());
    const long count = std::strtol(argv[3], nullptr, 10);
    const auto evaluate = [&] {
        for (long k = 0; k < count; ++k) { equations.evaluate(0.0, y.data(), y_dot.data()); }
    };
    if (times) {
        const double microseconds = least_time(evaluate) / static_cast<double>(count);
        std::printf("%.4f %.1f\n", microseconds, peak_flops_per_microsecond());
        return 0;
    }
    evaluate();
    std::printf("%d moving bodies, last acceleration %g\n", equations.bodies(), y_dot.back());
    return 0;
}
