#include "tests/reference/stored.hpp"

#include <cstdio>
#include <fstream>

namespace jw::reference {

namespace {

/// Text with 16 digits, as many as a double holds; rounding noise of planar scenes becomes 0.
std::string number(Real value) {
    if (std::abs(value) < 1e-18L) { return "0"; }
    char text[40];
    std::snprintf(text, sizeof text, "%.16Lg", value);
    return text;
}

}  // namespace

void write_trajectory(
    const std::filesystem::path& file, const std::string& header, Real duration,
    const Trajectory& trajectory) {
    std::ofstream out(file);
    out << "# " << header << "\nt,x,y,z,vx,vy,vz\n";
    for (std::size_t k = 0; k < trajectory.size(); ++k) {
        const Sample& s = trajectory[k];
        out << number(duration * static_cast<Real>(k) / kIntervals);
        for (const Vec3& vector : {s.r, s.v}) {
            for (const Real component : vector) { out << ',' << number(component); }
        }
        out << '\n';
    }
}

std::optional<Trajectory> read_trajectory(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    std::getline(in, line);
    Trajectory trajectory;
    while (std::getline(in, line)) {
        Sample s;
        Real t = 0.0L;
        const int read = std::sscanf(
            line.c_str(), "%Lf,%Lf,%Lf,%Lf,%Lf,%Lf,%Lf", &t, &s.r[0], &s.r[1], &s.r[2], &s.v[0], &s.v[1],
            &s.v[2]);
        if (read != 7) { return std::nullopt; }
        trajectory.push_back(s);
    }
    if (trajectory.size() != kIntervals + 1) { return std::nullopt; }
    return trajectory;
}

}  // namespace jw::reference
