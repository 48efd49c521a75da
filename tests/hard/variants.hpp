#pragma once

#include <cstdint>
#include <numbers>
#include <random>
#include <string_view>

#include "core/poses/rank.hpp"
#include "lessons/lesson/lesson.hpp"

/// Altered mechanisms of lessons, to see whether verdicts stay the same.
namespace jw::hard {

/// [rad]
inline constexpr double kDegree = std::numbers::pi / 180.0;

/// The joints of a shipped lesson, nothing driven; it starts at the pose that the lesson closes to.
/// @param name below lessons/catalogue
Mechanism assembled_mechanism(std::string_view name);
/// Assembled mechanism of a lesson that has been altered.
Mechanism assembled_mechanism(const Lesson& lesson);

/// The mechanism with p1 and p2 of all joints in this form.
Mechanism with_form(Mechanism mechanism, ParallelForm form);

/// Φq in (r, ω') at the start pose, with its residuals.
struct Equations {
    MatrixX jacobian;
    VectorX phi;
};
Equations equations_of(const Mechanism& mechanism);

/// Verdict of the program on all joints and drivers at the start pose, t = 0.
RankReport verdict_on(const Mechanism& mechanism);

/// Rank as in a textbook: elimination with full pivoting; entries up to `threshold` are zero. Nothing is
/// scaled.
int rank_by_elimination(MatrixX matrix, double threshold);

/// Least squares as in a textbook: JᵀJ x = Jᵀb, which squares the condition number. Nothing is scaled.
VectorX by_normal_equations(const MatrixX& J, const VectorX& b);

/// Grübler's count at all revolutes, prismatic joints ...: 6 for each moving body less what joints take.
int mobility_by_counting(const Mechanism& mechanism);

/// Random numbers that are the same on every machine.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double number(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
    }
    Vec3 vector(double size);
    Vec3 direction();
    Vec4 turn();  ///< unit p

private:
    std::mt19937 engine_;
};

/// A start pose with every moving body up to 0.05 of the machine and 0.05 rad off.
State disturbed(const Mechanism& mechanism, Dice& dice);

}  // namespace jw::hard
