#include "core/poses/typed/loose_motion.hpp"

#include <algorithm>
#include <limits>

#include "core/elementary/elementary.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

// convergence is linear, by the misfit times the curvature: a few steps for typed digits
constexpr int kMostSettling = 30;
constexpr double kSettled = 1e-13;
constexpr double kShrinking = 0.5;
// if several motions are free: a few mixtures of them
constexpr int kMostDirections = 3;
constexpr double kNoDirection = 1e-12;

void walk_along(
    const Mechanism& mechanism, int rank, MatrixX free, VectorX direction, double step, int steps,
    std::vector<State>& poses, State state) {
    for (int k = 0; k < steps; ++k) {
        const JointEquations equations(mechanism, state);
        direction = (free * (free.transpose() * direction)).eval();
        // columns are scaled by the unit of length
        const double length = extent(mechanism) / equations.system.length_unit();
        const double size = largest_part(equations.system, direction, length);
        if (!(size > kNoDirection)) { return; }
        direction *= step / size;
        const State predicted = equations.scaled.moved(state, direction);
        State reached = predicted;
        auto free_there = settle(mechanism, rank, reached);
        if (!free_there || !is_on_tangent(
                               movement(equations.system, state, predicted),
                               movement(equations.system, predicted, reached))) {
            return;
        }
        free = std::move(*free_there);
        state = reached;
        poses.push_back(std::move(reached));
    }
}

}  // namespace

Selection joints_of(const Mechanism& mechanism) {
    Selection joints = everything(mechanism);
    joints.drivers.clear();
    return joints;
}

JointEquations::JointEquations(const Mechanism& mechanism, const State& state)
    : system(mechanism, joints_of(mechanism)), scaled(system, 0.0) {
    system.choose_rows(state);
    scaled.look(state);
}

std::optional<MatrixX> settle(const Mechanism& mechanism, int rank, State& state) {
    JointEquations equations(mechanism, state);
    for (int k = 0; k < kMostSettling; ++k) {
        const Svd svd = equations.svd();
        if (!svd.sound || svd.sigma(rank - 1) <= kRankThreshold) { return std::nullopt; }
        // a decomposition is used as long as its corrections shrink
        double first = 0.0;
        double last = std::numeric_limits<double>::infinity();
        for (double size = 0.0;; last = size) {
            const VectorX c = (svd.U.leftCols(rank).transpose() * equations.scaled.phi())
                                  .cwiseQuotient(svd.sigma.head(rank));
            size = c.norm();
            if (!(size <= kShrinking * last)) { break; }
            first = std::max(first, size);
            state = equations.scaled.moved(state, -(svd.V.leftCols(rank) * c));
            for (Vec4& p : state.p) { p.normalize(); }
            equations.scaled.look(state);
            // the error of the pose is the misfit times the first correction, by which the vectors have
            // turned
            if (size <= kSettled && first * equations.misfit() <= kSettled) {
                return svd.V.rightCols(svd.V.cols() - rank);
            }
            if (size <= kSettled) { break; }
        }
    }
    return std::nullopt;
}

std::vector<State> walk(const Mechanism& mechanism, int rank, const State& start, double step, int steps) {
    const Svd svd = JointEquations(mechanism, start).svd();
    const MatrixX free = svd.V.rightCols(svd.V.cols() - rank);
    std::vector<State> poses{start};
    for (int d = 0; d < std::min(kMostDirections, static_cast<int>(free.cols())); ++d) {
        // no two weights are equal, so that mixtures of several free motions break every symmetry of the
        // scene
        VectorX weights(free.cols());
        for (Eigen::Index k = 0; k < weights.size(); ++k) {
            weights(k) = elementary::cos(1.0 + 2.4 * static_cast<double>(k) + d);
        }
        const VectorX direction = free * weights;
        walk_along(mechanism, rank, free, direction, step, steps, poses, start);
        walk_along(mechanism, rank, free, -direction, step, steps, poses, start);
    }
    return poses;
}

}  // namespace jw
