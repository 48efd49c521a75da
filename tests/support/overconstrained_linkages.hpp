#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tests/support/random_mechanisms.hpp"

/// Loops of hinges that move although counting gives them no freedom, with random dimensions, anywhere.
namespace jw::test {

struct Hinge {
    Eigen::Isometry3d frame;  ///< of the link behind the hinge, z along the axis
    Vec3 at = Vec3::Zero();   ///< a point of the axis
};

/// Loop of hinges, one after the other; the ground is the link between the last one and the first.
struct HingeLoop {
    std::string name;
    std::vector<Hinge> hinges;
    double turn_deg = 360.0;  ///< by which the first hinge can be driven
    /// How far the turns of all hinges since the start [rad] are from what the loop allows.
    std::function<double(const std::vector<double>&)> off;
};

namespace detail {

inline constexpr double kPi = std::numbers::pi;

inline Eigen::Isometry3d turn(double angle, const Vec3& axis) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis));
}
inline Eigen::Isometry3d about_z(double angle) { return turn(angle, Vec3::UnitZ()); }
/// Transform along a link to its next hinge.
inline Eigen::Isometry3d link(double length, double twist) {
    return Eigen::Translation3d(length, 0.0, 0.0) * turn(twist, Vec3::UnitX());
}
inline double apart(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * kPi)); }

/// The loop at a random place; points of the axes are moved along the axes.
inline HingeLoop laid(HingeLoop loop, Random& random) {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.linear() = rotation_matrix(random.unit_p());
    place.translation() = random.vector();
    for (Hinge& hinge : loop.hinges) {
        hinge.frame = place * hinge.frame;
        hinge.at = hinge.frame.translation() + 0.3 * random.number() * hinge.frame.linear().col(2);
    }
    return loop;
}

}  // namespace detail

/// Four hinges in a loop: links a, b, a, b with twists alpha, beta, alpha, beta, sin(alpha) b = sin(beta) a.
/// @source Bennett, A new mechanism, Engineering 76 (1903)
struct Bennett {
    double alpha;
    double beta;
    double a;
    double theta;  ///< angle of the first hinge at the start

    double b() const { return a * std::sin(beta) / std::sin(alpha); }
    double ratio() const { return std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha)); }
    /// Angle of the second hinge, continuous for theta within (0, 2 pi); the way back is the same.
    double next(double at) const {
        return 2.0 * std::atan2(ratio() * std::cos(0.5 * at), std::sin(0.5 * at));
    }
};

inline Bennett random_bennett(Random& random) {
    const double alpha = 0.9 + 0.4 * random.number();
    const double beta = alpha + 0.9 + 0.3 * random.number();
    return {alpha, beta, 1.2 + 0.6 * random.number(), 1.6 + random.number()};
}

inline HingeLoop bennett_loop(const Bennett& b, Random& random) {
    const double phi = b.next(b.theta);
    const std::array angles{b.theta, phi, -b.theta, -phi};
    HingeLoop loop{"Bennett", {}, 360.0, [b](const std::vector<double>& turns) {
                       return detail::apart(turns[1], b.next(b.theta + turns[0]) - b.next(b.theta));
                   }};
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    for (std::size_t k = 0; k < 4; ++k) {
        frame = frame * detail::about_z(angles[k]);
        loop.hinges.push_back({frame});
        frame = frame * detail::link(k % 2 == 0 ? b.a : b.b(), k % 2 == 0 ? b.alpha : b.beta);
    }
    return detail::laid(loop, random);
}

/// Two Bennett linkages with one link in common, which is taken out together with a hinge of it: there the
/// links of both become one.
/// @param offset angle between them
/// @source Goldberg, New five-bar and six-bar linkages in three dimensions, Trans. ASME 65 (1943)
inline HingeLoop joined_bennetts(
    const std::string& name, const Bennett& one, const Bennett& other, double offset, Random& random) {
    using namespace detail;
    const double phi = one.next(one.theta);
    const double other_phi = other.next(one.theta + offset);
    const Eigen::Isometry3d kept = about_z(one.theta) * link(one.a, one.alpha);
    // without the sense of a link's frame, which no one needs
    HingeLoop loop{name, {}, 360.0, [one, phi](const std::vector<double>& turns) {
                       return apart(turns[1], one.next(phi + turns[0]) - one.theta);
                   }};
    loop.hinges = {
        {link(one.b(), one.beta).inverse()},
        {kept * about_z(phi) * link(one.b(), one.beta)},
        {kept},
        {kept * about_z(other_phi) * link(other.b(), other.beta)},
        {about_z(-offset) * link(other.b(), other.beta).inverse()}};
    return laid(loop, random);
}

inline HingeLoop goldberg_loop(Random& random) {
    const Bennett one = random_bennett(random);
    const Bennett other{one.alpha, one.alpha + 0.9 + 0.3 * random.number(), one.a, one.theta};
    return joined_bennetts("Goldberg 5R", one, other, 0.3 * random.number(), random);
}

/// Two rectangular Bennett linkages, one the mirror image of the other.
/// @source Myard, Contribution à la géométrie des systèmes articulés, Bull. Soc. Math. France 59 (1931)
inline HingeLoop myard_loop(Random& random) {
    Bennett one = random_bennett(random);
    one.beta = one.alpha;
    one.alpha = 0.5 * detail::kPi;
    const Bennett other{one.alpha, detail::kPi - one.beta, one.a, one.theta};
    return joined_bennetts("Myard 5R", one, other, 0.0, random);
}

/// Two legs of three parallel hinges each: the body on them moves along a straight line and does not turn.
/// @source Sarrus, Comptes rendus de l'Académie des sciences 36 (1853)
inline HingeLoop sarrus_loop(Random& random) {
    HingeLoop loop{"Sarrus", {}, 15.0, [](const std::vector<double>& turns) {
                       return std::max(
                           std::abs(turns[0] + turns[1] + turns[2]),
                           std::abs(turns[3] + turns[4] + turns[5]));
                   }};
    for (const double leg : {0.0, 1.2 + 0.5 * random.number()}) {
        // z along the hinges, x across the way, y along it; a knee of about a right angle
        const double rising = 0.8 + 0.2 * random.number();
        const double back = 2.3 + 0.2 * random.number();
        const Vec3 foot(1.5 + 0.3 * random.number(), random.number(), 0.0);
        const Vec3 knee = foot + (1.0 + 0.2 * random.number()) * Vec3(std::cos(rising), std::sin(rising), 0);
        const Vec3 top = knee + (1.0 + 0.2 * random.number()) * Vec3(std::cos(back), std::sin(back), 0);
        std::array points{foot, knee, top};
        if (leg > 0.0) { std::swap(points[0], points[2]); }
        for (const Vec3& point : points) {
            loop.hinges.push_back({detail::turn(leg, Vec3::UnitY()) * Eigen::Translation3d(point)});
        }
    }
    return detail::laid(loop, random);
}

/// Three hinges anywhere, and the same after half a turn about a line.
/// @source Bricard, Leçons de cinématique II (1927)
inline HingeLoop line_symmetric_loop(Random& random) {
    HingeLoop loop{"Bricard, line-symmetric", {}, 10.0, [](const std::vector<double>& turns) {
                       double most = 0.0;
                       for (std::size_t k = 0; k < 3; ++k) {
                           most = std::max(most, std::abs(turns[k] - turns[k + 3]));
                       }
                       return most;
                   }};
    for (int k = 0; k < 3; ++k) {
        Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
        frame.linear() = rotation_matrix(random.unit_p());
        const double around = detail::kPi / 3.0 * (k + 0.3 * random.number());
        frame.translation() = Vec3(std::cos(around), std::sin(around), 0.4 * random.number());
        loop.hinges.push_back({frame});
    }
    for (std::size_t k = 0; k < 3; ++k) {
        loop.hinges.push_back({detail::about_z(detail::kPi) * loop.hinges[k].frame});
    }
    return detail::laid(loop, random);
}

/// Six equal links with twists α and -α in turn, the same after a third of a turn; α = π/2 is the orthogonal
/// one. cos²α + sin²α (cos θ + cos φ) + (1 + cos²α) cos θ cos φ = 2 cos α sin θ sin φ
/// @source Chen, You and Tarnai, Threefold-symmetric Bricard linkages for deployable structures, Int. J.
///         Solids Structures 42 (2005)
inline HingeLoop threefold_loop(Random& random, bool is_orthogonal) {
    using namespace detail;
    const double alpha = is_orthogonal ? 0.5 * kPi : 1.3 + 0.15 * random.number();
    const double length = 1.0 + 0.3 * random.number();
    const double c = std::cos(alpha);
    const double s = std::sin(alpha);
    const auto next = [=](double theta) {
        const double x = s * s + (1.0 + c * c) * std::cos(theta);
        const double y = -2.0 * c * std::sin(theta);
        const double phi = std::acos(-(c * c + s * s * std::cos(theta)) / std::hypot(x, y));
        return std::atan2(y, x) + phi;
    };
    const double theta = 0.6 + 0.3 * random.number();
    HingeLoop loop{
        is_orthogonal ? "Bricard, orthogonal" : "Bricard, threefold",
        {},
        10.0,
        [=](const std::vector<double>& turns) {
            return std::max(
                {std::abs(turns[2] - turns[0]), std::abs(turns[4] - turns[0]),
                 apart(turns[1], next(theta + turns[0]) - next(theta))});
        }};
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    for (int k = 0; k < 6; ++k) {
        frame = frame * about_z(k % 2 == 0 ? theta : next(theta));
        loop.hinges.push_back({frame});
        frame = frame * link(length, k % 2 == 0 ? alpha : -alpha);
    }
    return laid(loop, random);
}

using MakeLoop = HingeLoop (*)(Random&);
/// Loops of five and six hinges, one of each class.
inline constexpr std::array<MakeLoop, 6> kHingeLoops{
    goldberg_loop,
    myard_loop,
    sarrus_loop,
    line_symmetric_loop,
    [](Random& random) { return threefold_loop(random, false); },
    [](Random& random) { return threefold_loop(random, true); }};

}  // namespace jw::test
