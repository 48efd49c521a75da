#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "core/integrate/simulation.hpp"
#include "core/numerics/triples.hpp"
#include "lessons/read/reader.hpp"
#include "tests/bench/clock.hpp"

/// `evaluations LESSON joints|bodies COUNT [--time]`: so many accelerations at the start of a lesson of
/// dynamics, and nothing else. ./dev count runs it twice under callgrind; the difference is what one
/// evaluation costs. --time prints microseconds of an evaluation and the flops that this core does in a
/// microsecond at its best.
namespace {

using namespace jw;

/// Products and sums in all lanes of the widest registers that core computes in, none of which waits for
/// another.
double peak_flops_per_microsecond() {
    constexpr int kRounds = 2'000'000;
    double flops = 0.0;
    double kept = 0.0;
    const double time = least_time([&] {
        in_registers(widest_registers(), [&]<Lanes V>(std::type_identity<V>) JW_PASS {
            using Register = typename V::Register;
            constexpr std::size_t lanes = sizeof(Register) / sizeof(double);
            const Register factor = Register{} + (1.0 + 1e-9);
            const Register term = Register{} + 1e-9;
            // few enough for the registers, and so many that no product waits for the one before it
            Register products[6];
            Register sums[6];
            for (int k = 0; k < 6; ++k) { products[k] = sums[k] = Register{} + (1.0 + k); }
            for (int round = 0; round < kRounds; ++round) {
                for (Register& x : products) { x *= factor; }
                for (Register& x : sums) { x += term; }
            }
            for (int k = 0; k < 6; ++k) { kept += products[k][0] + sums[k][0]; }
            flops = 12.0 * lanes * kRounds;
        });
    });
    if (kept == 0.0) { std::puts("never: it only keeps the loop alive"); }
    return flops / time;
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
