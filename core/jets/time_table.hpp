#pragma once

#include <array>
#include <cstddef>
#include <vector>

/// Values typed for given times, as measured or taken from a data sheet.
namespace jw {

/// c0 + c1 u + c2 u² + c3 u³ with u = t - start.
struct CubicPiece {
    double start = 0.0;  ///< [s]
    std::array<double, 4> c{};
};

/// Function through given values, with a cubic piece between neighbouring times; before the first and after
/// the last time its rate is constant.
struct TimeTable {
    enum class Interpolation {
        smooth,    ///< natural cubic spline: two continuous derivatives; may overshoot the values
        monotone,  ///< never beyond the two values beside it; its second derivative jumps at the times
    };
    Interpolation interpolation = Interpolation::smooth;
    std::vector<double> times;   ///< [s], increasing, at least two
    std::vector<double> values;  ///< one per time
    std::vector<double> rates;   ///< first derivative at each time, which the interpolation determines

    /// Piece from time k - 1 to time k; piece 0 is before all times, piece `times.size()` after all times.
    CubicPiece piece(std::size_t k) const;
    /// Piece at t; where two pieces meet, the later one, but at the last time the earlier one.
    CubicPiece piece_at(double t) const;
    /// Bounds between two times: entry k bounds |f^(k)| / k!; entry 0 is not used. If a derivative jumps
    /// between them, the bound of the next one is infinite.
    std::array<double, 5> taylor_bounds(double from, double to) const;

    bool operator==(const TimeTable&) const = default;
};

/// The table through these values.
/// @throws std::invalid_argument unless there are at least two times, in increasing order, with a value each
TimeTable table_through(
    std::vector<double> times, std::vector<double> values, TimeTable::Interpolation interpolation);

}  // namespace jw
