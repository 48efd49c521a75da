#include "tests/hard/variants.hpp"

#include <cmath>

#include "app/session/story/story.hpp"
#include "core/eigen/decompositions.hpp"
#include "core/equations/assembler.hpp"
#include "tests/hard/shipped.hpp"

namespace jw::hard {

Mechanism assembled_mechanism(std::string_view name) { return assembled_mechanism(shipped_lesson(name)); }

Mechanism assembled_mechanism(const Lesson& lesson) {
    const State state = assembled(lesson);
    Mechanism mechanism = lesson.mechanism;
    mechanism.drivers.clear();
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        mechanism.bodies[b].r = state.r[b];
        mechanism.bodies[b].p = state.p[b];
    }
    std::size_t theta = 0;
    for (Joint& joint : mechanism.joints) {
        if (joint.type->artificial > 0) { joint.geometry.theta_start = state.theta[theta++]; }
    }
    return mechanism;
}

Mechanism with_form(Mechanism mechanism, ParallelForm form) {
    for (Joint& joint : mechanism.joints) { joint.parallel_form = form; }
    return mechanism;
}

Equations equations_of(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(start_state(mechanism), 0.0);
    return {assembler.jacobian(), assembler.phi()};
}

RankReport verdict_on(const Mechanism& mechanism) {
    const System system(mechanism, everything(mechanism));
    return rank_of(system, start_state(mechanism), 0.0);
}

int rank_by_elimination(MatrixX matrix, double threshold) {
    const Eigen::Index most = std::min(matrix.rows(), matrix.cols());
    for (Eigen::Index k = 0; k < most; ++k) {
        Eigen::Index row = 0;
        Eigen::Index column = 0;
        const auto rest = matrix.bottomRightCorner(matrix.rows() - k, matrix.cols() - k);
        if (rest.cwiseAbs().maxCoeff(&row, &column) <= threshold) { return static_cast<int>(k); }
        matrix.row(k).swap(matrix.row(k + row));
        matrix.col(k).swap(matrix.col(k + column));
        for (Eigen::Index other = k + 1; other < matrix.rows(); ++other) {
            matrix.row(other) -= matrix(other, k) / matrix(k, k) * matrix.row(k);
        }
    }
    return static_cast<int>(most);
}

VectorX by_normal_equations(const MatrixX& J, const VectorX& b) {
    return (J.transpose() * J).ldlt().solve(J.transpose() * b);
}

int mobility_by_counting(const Mechanism& mechanism) {
    int mobility = 6 * mechanism.moving_bodies_count();
    for (const Joint& joint : mechanism.joints) { mobility -= 6 - joint.type->dof; }
    return mobility;
}

Vec3 Dice::vector(double size) {
    // one number after the other: the compiler chooses in which order it evaluates arguments
    Vec3 v;
    for (double& entry : v) { entry = number(-size, size); }
    return v;
}

Vec3 Dice::direction() {
    Vec3 v = vector(1.0);
    while (v.norm() < 0.2) { v = vector(1.0); }
    return v.normalized();
}

Vec4 Dice::turn() {
    const double angle = number(0.0, 3.14159);
    return euler_parameters_of(direction(), angle);
}

State disturbed(const Mechanism& mechanism, Dice& dice) {
    State state = start_state(mechanism);
    const double size = extent(mechanism);
    for (std::size_t b = 1; b < state.r.size(); ++b) {
        state.r[b] += dice.vector(0.05 * size);
        state.p[b] = turned_local(state.p[b], dice.vector(0.05));
    }
    return state;
}

}  // namespace jw::hard
