#include <cstdio>
#include <cstdlib>

#include "core/dynamics/flat_state.hpp"
#include "core/dynamics/motion_equations.hpp"
#include "lessons/reader.hpp"

/// `evaluations LESSON COUNT`: so many accelerations at the start of a lesson of dynamics, and nothing else.
/// ./dev count runs it twice under callgrind; the difference is what one evaluation costs.
int main(int argc, char** argv) {
    using namespace jw;
    const ReadResult read = argc == 3 ? read_lesson_file(argv[1]) : ReadResult{};
    if (!read.lesson || !read.lesson->dynamics) {
        std::fprintf(stderr, "usage: evaluations LESSON COUNT, for a lesson with [dynamics]\n");
        return 2;
    }
    const Centroidal scene = centroidal(read.lesson->mechanism, read.lesson->dynamics->loads);
    const auto equations = block_equations(scene);
    const std::vector<double> y = flat_start(scene.mechanism);
    std::vector<double> y_dot(y.size());
    equations->choose_rows(0.0, y.data());
    const long count = std::strtol(argv[2], nullptr, 10);
    double sum = 0.0;
    for (long k = 0; k < count; ++k) {
        equations->evaluate(0.0, y.data(), y_dot.data());
        sum += y_dot.back();
    }
    std::printf("%zu moving bodies, sum %g\n", y.size() / kNumbersPerBody, sum);
    return 0;
}
