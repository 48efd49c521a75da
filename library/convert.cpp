#include "library/convert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "core/quantity/names.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

void expect_size(std::size_t size, std::size_t expected, const char* what) {
    if (size == expected) { return; }
    throw std::invalid_argument(
        std::string("jointwise: ") + what + " has " + std::to_string(size) + " entries; expected " +
        std::to_string(expected) + ", one each of the mechanism");
}

template <class V>
bool all_finite(const std::vector<V>& vectors) {
    return std::ranges::all_of(vectors, [](const V& v) { return v.allFinite(); });
}

bool all_finite(const std::vector<double>& numbers) {
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

std::string name_of_constraint(const jw::System& system, const jw::RowOrigin& origin) {
    const jw::Constraint& constraint = system.constraints()[static_cast<std::size_t>(origin.index)];
    const jw::Joint& joint = system.mechanism().joints[static_cast<std::size_t>(constraint.joint)];
    const std::string role(jw::word_of(constraint.role));
    const std::string component(jw::component_word(joint, constraint.role, origin.component));
    return joint.name + "." + role + (component.empty() ? "" : "." + component);
}

}  // namespace

void read_state(const jw::Mechanism& mechanism, const Pose& pose, jw::State& state) {
    expect_size(pose.r.size(), mechanism.bodies.size(), "r of a pose");
    expect_size(pose.p.size(), mechanism.bodies.size(), "p of a pose");
    expect_size(pose.theta.size(), static_cast<std::size_t>(mechanism.thetas_count()), "theta of a pose");
    if (!std::isfinite(pose.t) || !all_finite(pose.r) || !all_finite(pose.p) || !all_finite(pose.theta)) {
        throw std::invalid_argument("jointwise: a number of a pose is not finite");
    }
    state.r = pose.r;
    state.p = pose.p;
    state.theta = pose.theta;
}

void read_motion(const jw::Mechanism& mechanism, const Rates& rates, jw::Motion& motion) {
    expect_size(rates.r_dot.size(), mechanism.bodies.size(), "r_dot");
    expect_size(rates.omega_local.size(), mechanism.bodies.size(), "omega_local");
    expect_size(rates.theta_dot.size(), static_cast<std::size_t>(mechanism.thetas_count()), "theta_dot");
    if (!all_finite(rates.r_dot) || !all_finite(rates.omega_local) || !all_finite(rates.theta_dot)) {
        throw std::invalid_argument("jointwise: a number of velocities or accelerations is not finite");
    }
    motion.r_dot = rates.r_dot;
    motion.omega_local = rates.omega_local;
    motion.theta_dot = rates.theta_dot;
}

jw::State state_of(const jw::Mechanism& mechanism, const Pose& pose) {
    jw::State state;
    read_state(mechanism, pose, state);
    return state;
}

jw::Motion motion_of(const jw::Mechanism& mechanism, const Rates& rates) {
    jw::Motion motion;
    read_motion(mechanism, rates, motion);
    return motion;
}

std::string number_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string row_name(const jw::System& system, int row) {
    const jw::RowOrigin origin = system.origin(row);
    const auto index = static_cast<std::size_t>(origin.index);
    switch (origin.kind) {
        case jw::RowOrigin::Kind::constraint: return name_of_constraint(system, origin);
        case jw::RowOrigin::Kind::driver:
            return system.mechanism().drivers[static_cast<std::size_t>(system.drivers()[index].driver)].name;
        case jw::RowOrigin::Kind::normalisation: break;
    }
    return system.mechanism().bodies[index].name + ".p";
}

void expect_ascending(const std::vector<double>& times) {
    if (times.empty()) { throw std::invalid_argument("jointwise: there are no times; expected some"); }
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (std::isfinite(times[k]) && (k == 0 || times[k] >= times[k - 1])) { continue; }
        throw std::invalid_argument(
            "jointwise: time " + std::to_string(k) + " is " + number_text(times[k]) +
            "; expected finite times in ascending order");
    }
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
