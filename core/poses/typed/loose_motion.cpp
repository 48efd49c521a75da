#include "core/poses/typed/loose_motion.hpp"

#include <algorithm>

#include "core/elementary/elementary.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

// convergence is linear, by the misfit times the curvature: a few steps for typed digits
constexpr int kMostSettling = 30;
constexpr double kSettled = 1e-13;
// several motions are free: a few mixtures of them
constexpr int kMostDirections = 3;
constexpr double kNoDirection = 1e-12;

Selection joints_of(const Mechanism& mechanism) {
    Selection joints = everything(mechanism);
    joints.drivers.clear();
    return joints;
}

MatrixX free_of(const JointEquations& equations, int rank) {
    const Svd svd = equations.svd();
    return svd.V.rightCols(svd.V.cols() - rank);
}

void walk_along(
    const Mechanism& mechanism, int rank, VectorX direction, double step, int steps,
    std::vector<State>& poses, State state) {
    for (int k = 0; k < steps; ++k) {
        const JointEquations equations(mechanism, state);
        const MatrixX free = free_of(equations, rank);
        direction = (free * (free.transpose() * direction)).eval();
        // columns are scaled by the unit of length
        const double length = extent(mechanism) / equations.system.length_unit();
        const double size = largest_part(equations.system, direction, length);
        if (!(size > kNoDirection)) { return; }
        direction *= step / size;
        const State predicted = equations.scaled.moved(state, direction);
        State reached = predicted;
        if (!settle(mechanism, rank, reached) || !is_on_tangent(
                                                     movement(equations.system, state, predicted),
                                                     movement(equations.system, predicted, reached))) {
            return;
        }
        state = reached;
        poses.push_back(std::move(reached));
    }
}

}  // namespace

JointEquations::JointEquations(const Mechanism& mechanism, const State& state)
    : system(mechanism, joints_of(mechanism)), scaled(system, 0.0) {
    system.choose_rows(state);
    scaled.look(state);
}

bool settle(const Mechanism& mechanism, int rank, State& state) {
    JointEquations equations(mechanism, state);
    for (int k = 0; k < kMostSettling; ++k) {
        const Svd svd = equations.svd();
        if (!svd.sound || svd.sigma(rank - 1) <= kRankThreshold) { return false; }
        const VectorX c =
            (svd.U.leftCols(rank).transpose() * equations.scaled.phi()).cwiseQuotient(svd.sigma.head(rank));
        state = equations.scaled.moved(state, -(svd.V.leftCols(rank) * c));
        for (Vec4& p : state.p) { p.normalize(); }
        if (c.norm() <= kSettled) { return true; }
        equations.scaled.look(state);
    }
    return false;
}

std::vector<State> walk(const Mechanism& mechanism, int rank, const State& start, double step, int steps) {
    const MatrixX free = free_of(JointEquations(mechanism, start), rank);
    std::vector<State> poses{start};
    for (int d = 0; d < std::min(kMostDirections, static_cast<int>(free.cols())); ++d) {
        // no two weights are equal: where several motions are free, no symmetry of the scene survives
        VectorX weights(free.cols());
        for (Eigen::Index k = 0; k < weights.size(); ++k) {
            weights(k) = elementary::cos(1.0 + 2.4 * static_cast<double>(k) + d);
        }
        const VectorX direction = free * weights;
        walk_along(mechanism, rank, direction, step, steps, poses, start);
        walk_along(mechanism, rank, -direction, step, steps, poses, start);
    }
    return poses;
}

}  // namespace jw
