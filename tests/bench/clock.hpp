#pragma once

#include <algorithm>
#include <ctime>

/// Processor time, for measurements by hand.
namespace jw {

inline double cpu_microseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Least time of several rounds: other work of the machine can only add to it.
template <class F>
double least_time(F&& f) {
    double least = 1e300;
    for (int round = 0; round < 10; ++round) {
        const double start = cpu_microseconds();
        f();
        least = std::min(least, cpu_microseconds() - start);
    }
    return least;
}

}  // namespace jw
