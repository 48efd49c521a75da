#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/equations/system.hpp"
#include "core/motion/loads.hpp"
#include "core/motion/motion_equations.hpp"
#include "core/numerics/hermite.hpp"

/// Position, velocity and acceleration of a mechanism whose drivers leave no freedom: a fast solver over the
/// graph of joints from one time to the next, used where no rank has to be determined. The normal equations
/// Φq W Φqᵀ that it solves square the condition number, so it declines where digits would be lost.
namespace jw {

class DrivenFrames {
public:
    /// False for a part of a mechanism, for artificial coordinates, and without drivers: the equations of
    /// motion do not support these.
    static bool can_follow(const System& system);
    explicit DrivenFrames(const System& system);

    /// Starts at a pose and determines which rows are redundant.
    /// @return false if the rows leave a freedom, or if one of them is nearly dependent on the others
    bool start(const State& state, const Motion& velocity, const Motion& acceleration, double t);
    /// Advances to time `t` by Newton's method. The start is a pose predicted from position, velocity and
    /// acceleration at up to three earlier times.
    /// @return false if a rank has to be determined or Newton's method led elsewhere; the pose is unchanged
    /// then
    bool advance(double t);
    /// Undoes the last advance.
    void retreat();
    /// Writes the results for the moving bodies into `state`, `velocity` and `acceleration`; the rest stays.
    void write(State& state, Motion& velocity, Motion& acceleration) const;

private:
    bool is_sound(const RowsVerdict& verdict) const;
    void remember();
    void predict(double t);
    bool led_on() const;

    const System* system_;
    Centroidal scene_;  ///< with unit masses: they cancel
    std::unique_ptr<DrivableEquations> equations_;
    double length_ = 1.0;  ///< extent of the mechanism [m]
    double t_ = 0.0;
    double t_before_ = 0.0;
    std::array<HermitePolynomial::Node, 3> latest_;  ///< of r and p, the last `known_` are set
    std::size_t known_ = 0;
    HermitePolynomial path_;
    std::vector<double> y_;
    std::vector<double> y_dot_;
    std::vector<double> predicted_;
    std::vector<double> y_new_;
    std::vector<double> y_dot_new_;
};

}  // namespace jw
