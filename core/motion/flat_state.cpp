#include "core/motion/flat_state.hpp"

namespace jw {

std::vector<int> moving_bodies_of(const Mechanism& mechanism) {
    std::vector<int> moving;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        if (!mechanism.bodies[b].fixed) { moving.push_back(static_cast<int>(b)); }
    }
    return moving;
}

std::vector<double> flat_start(const Mechanism& mechanism) {
    const std::vector<int> moving = moving_bodies_of(mechanism);
    std::vector<double> y(kNumbersPerBody * moving.size());
    pack(start_state(mechanism), start_motion(mechanism), moving, y.data());
    return y;
}

void pack(const State& state, const Motion& motion, std::span<const int> moving, double* y) {
    for (const int body : moving) {
        vec3(y) = state.r[at(body)];
        vec4(y + 3) = state.p[at(body)];
        vec3(y + 7) = motion.r_dot[at(body)];
        vec3(y + 10) = motion.omega_local[at(body)];
        y += kNumbersPerBody;
    }
}

void unpack(const double* y, std::span<const int> moving, State& state, Motion& motion) {
    for (const int body : moving) {
        state.r[at(body)] = vec3(y);
        state.p[at(body)] = vec4(y + 3);
        motion.r_dot[at(body)] = vec3(y + 7);
        motion.omega_local[at(body)] = vec3(y + 10);
        y += kNumbersPerBody;
    }
}

std::pair<State, Motion> unpacked(const Mechanism& mechanism, std::span<const int> moving, const double* y) {
    std::pair<State, Motion> out{start_poses(mechanism), zero_motion(mechanism)};
    auto& [state, motion] = out;
    unpack(y, moving, state, motion);
    std::size_t theta = 0;
    for (const Joint& joint : mechanism.joints) {
        if (joint.type->artificial == 0) { continue; }
        state.theta[theta] = artificial_angle_with_turns(joint, state);
        motion.theta_dot[theta] = artificial_rate(joint, state, motion, state.theta[theta]);
        ++theta;
    }
    return out;
}

void displace(double* y, const double* six, std::size_t bodies) {
    for (std::size_t n = 0; n < bodies; ++n) {
        double* numbers = body_numbers(y, n);
        vec3(numbers) += vec3(six + 6 * n);
        vec4(numbers + 3) = turned_local(vec4(numbers + 3), vec3(six + 6 * n + 3));
    }
}

std::vector<NumberScale> flat_scales(int size, int numbers_per_body) {
    using Kind = NumberScale::Kind;
    // |ṗ| = |ω| / 2
    const double of_turning = numbers_per_body > kNumbersPerBody ? 2.0 : 1.0;
    std::vector<NumberScale> out;
    for (int k = 0; k < size; ++k) {
        const int c = k % numbers_per_body;
        const Kind kind = c < 3 ? Kind::way : (c < 7 ? Kind::turn : (c < 10 ? Kind::velocity : Kind::omega));
        out.push_back({kind, kind == Kind::omega ? of_turning : 1.0});
    }
    return out;
}

void flat_derivatives(const double* y, const double* y_dot, int bodies, double* out) {
    double* rates = out + kPositionsPerBody * bodies;
    double* halves = rates + kPositionsPerBody * bodies;
    for (int b = 0; b < bodies; ++b) {
        std::copy_n(y, kPositionsPerBody, out);
        std::copy_n(y_dot, kPositionsPerBody, rates);
        vec3(halves) = 0.5 * vec3(y_dot + 7);
        vec4(halves + 3) = 0.5 * p_ddot_of_omega_local(vec4(y + 3), vec3(y + 10), vec3(y_dot + 10));
        y += kNumbersPerBody;
        y_dot += kNumbersPerBody;
        for (double** to : {&out, &rates, &halves}) { *to += kPositionsPerBody; }
    }
}

void flat_state_of(const double* value, const double* rate, int bodies, double* y) {
    for (int b = 0; b < bodies; ++b) {
        const Vec4 p = vec4(value + 3).normalized();
        vec3(y) = vec3(value);
        vec4(y + 3) = p;
        vec3(y + 7) = vec3(rate);
        vec3(y + 10) = omega_local_of(p, vec4(rate + 3));
        value += kPositionsPerBody;
        rate += kPositionsPerBody;
        y += kNumbersPerBody;
    }
}

}  // namespace jw
