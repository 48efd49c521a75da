#include "core/poses/contradiction.hpp"

#include <algorithm>
#include <cmath>

#include "core/elementary/elementary.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/closest_fit.hpp"
#include "core/poses/newton.hpp"

namespace jw {

namespace {

// weight of all other equations: they are satisfied so much better that the last one's gap is its own to four
// digits
constexpr double kWeightOfOthers = 300.0;
// share of the largest residual at the closest fit: joints with a smaller one are not involved
constexpr double kShares = 0.02;
// every omission requires a solve
constexpr std::size_t kMostTried = 64;

/// Subsystems that are solved one by one.
class Parts {
public:
    Parts(const System& whole, const State& start, double t) : whole_(&whole), start_(&start), t_(t) {}

    System part(const Selection& selection) const {
        System part(whole_->mechanism(), selection);
        part.inherit_rows(*whole_);
        return part;
    }
    bool closes(const Selection& selection) const {
        const System system = part(selection);
        NewtonStepper<OmegaLocal> newton(system);
        newton.start(*start_, t_);
        return solve(newton).converged && left_out_rows_hold(system, newton.state());
    }

private:
    const System* whole_;
    const State* start_;
    double t_;
};

/// First entry of `all` that does not close together with the earlier ones; -1 if there is none.
/// @param with  gives the selection of the first n of them
template <class With>
int first_that_fails(const Parts& parts, const std::vector<int>& all, const With& with) {
    if (all.size() > kMostTried) { return -1; }
    // usually the last one was added to a system that closed
    if (!all.empty() && parts.closes(with(all.size() - 1))) { return static_cast<int>(all.size()) - 1; }
    for (std::size_t n = 1; n <= all.size(); ++n) {
        if (!parts.closes(with(n))) { return static_cast<int>(n) - 1; }
    }
    return -1;
}

std::vector<int> first_of(const std::vector<int>& all, std::size_t count) {
    return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// Pose at which all rows hold except those marked.
template <class IsLast>
State fit_of_others(const System& system, const State& fit, double t, const IsLast& is_last) {
    VectorX weights(system.rows());
    for (int row = 0; row < system.rows(); ++row) {
        weights(row) = is_last(system.origin(row)) ? 1.0 : kWeightOfOthers;
    }
    return closest_fit(system, fit, t, weights);
}

/// Length of a squared distance; 0 if rounding made it negative.
double length_of(double square) { return std::sqrt(std::max(square, 0.0)); }

/// Gap of a constraint at `state`: an angle [rad], a distance or a difference of lengths [m].
double gap_of(const System& system, const Constraint& c, const State& state) {
    const VectorX values = values_of(c, state);
    const JointGeometry& g = system.mechanism().joints[static_cast<std::size_t>(c.joint)].geometry;
    switch (traits_of(c.role).dimension) {
        case Dimension::none: return elementary::asin(std::min(1.0, values.norm() / c.unit));
        case Dimension::length: return values.norm() * system.length_unit() / c.unit;
        case Dimension::of_author: return values.norm();
        case Dimension::square: break;
    }
    return std::abs(length_of(values(0) + g.length * g.length) - g.length);
}

/// Joints that share the largest residual at the closest fit; `last` comes last.
std::vector<int> joints_that_share(const System& system, const State& fit, double t, int last) {
    ScaledEquations equations(system, t);
    equations.look(fit);
    const VectorX size = equations.phi().cwiseAbs();
    std::vector<int> joints;
    for (const int joint : system.selection().joints) {
        double most = 0.0;
        for (const Constraint& c : system.constraints()) {
            if (c.joint == joint && c.rows() > 0) {
                most = std::max(most, size.segment(c.first_row, c.rows()).maxCoeff());
            }
        }
        if (joint != last && most >= kShares * size.maxCoeff()) { joints.push_back(joint); }
    }
    joints.push_back(last);
    return joints;
}

Contradiction of_joints(
    const Parts& parts, const std::vector<int>& all, std::size_t last, const State& fit, double t) {
    const System system = parts.part({first_of(all, last + 1), {}});
    const State whole_fit = closest_fit(system, fit, t);
    Contradiction found;
    found.joints = joints_that_share(system, whole_fit, t, all[last]);
    const auto of_last = [&](const RowOrigin& origin) {
        return system.constraints()[static_cast<std::size_t>(origin.index)].joint == all[last];
    };
    const State others_hold = fit_of_others(system, whole_fit, t, of_last);
    double most = -1.0;
    for (const Constraint& c : system.constraints()) {
        if (c.joint != all[last] || c.rows() == 0) { continue; }
        const double size = values_of(c, others_hold).norm() / c.unit;
        if (size <= most) { continue; }
        most = size;
        found.role = c.role;
        found.gap = gap_of(system, c, others_hold);
    }
    return found;
}

Contradiction of_drivers(
    const Parts& parts, const Selection& all, std::size_t last, const State& fit, double t) {
    Contradiction found;
    const std::vector<int> drivers = first_of(all.drivers, last + 1);
    for (std::size_t k = 0; k < last; ++k) {
        std::vector<int> others = drivers;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
        if (parts.closes({all.joints, others})) { found.drivers.push_back(drivers[k]); }
    }
    found.drivers.push_back(drivers.back());

    const System system = parts.part({all.joints, drivers});
    const int row = system.drivers().back().row;
    const State others_hold = fit_of_others(system, fit, t, [&](const RowOrigin& origin) {
        return origin.kind == RowOrigin::Kind::driver && origin.index == static_cast<int>(last);
    });
    ScaledEquations equations(system, t);
    equations.look(others_hold);
    const double off = equations.raw()(row);
    const Driver& driver = system.mechanism().drivers[static_cast<std::size_t>(drivers.back())];
    found.asked = driver.function.at(t).f;
    found.found = found.asked + off;
    if (std::holds_alternative<SquaredDistanceMeasure>(driver.measure)) {
        found.found = length_of(found.asked * found.asked + off);
    }
    found.gap = std::abs(found.found - found.asked);
    return found;
}

}  // namespace

std::optional<Contradiction> find_contradiction(
    const System& system, const State& start, const State& fit, double t) {
    const Selection& all = system.selection();
    const Parts parts(system, start, t);
    if (!all.drivers.empty() && parts.closes({all.joints, {}})) {
        const int last = first_that_fails(parts, all.drivers, [&](std::size_t n) {
            return Selection{all.joints, first_of(all.drivers, n)};
        });
        if (last < 0) { return std::nullopt; }
        return of_drivers(parts, all, static_cast<std::size_t>(last), fit, t);
    }
    const int last = first_that_fails(parts, all.joints, [&](std::size_t n) {
        return Selection{first_of(all.joints, n), {}};
    });
    if (last < 0) { return std::nullopt; }
    return of_joints(parts, all.joints, static_cast<std::size_t>(last), fit, t);
}

}  // namespace jw
