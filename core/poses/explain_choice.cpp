#include <algorithm>
#include <limits>
#include <vector>

#include "core/equations/assembler.hpp"
#include "core/poses/least_squares.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

constexpr double kRounding = 1e-15;  // singular values below this part of the largest are rounding

/// Condition of two rows of p1 or p2, or of a single row.
double condition_of_rows(const MatrixX& rows) {
    const VectorX sigma = singular_values_of(rows);
    const Eigen::Index directions = std::min<Eigen::Index>(rows.rows(), 2);
    if (sigma.size() < directions || directions == 0 || sigma(directions - 1) <= kRounding * sigma(0)) {
        return std::numeric_limits<double>::infinity();
    }
    return sigma(0) / sigma(directions - 1);
}

/// Keeps only the two bodies of the joint: the conditions of its rows do not need others.
void keep_bodies_of_joint(Mechanism& alone, State& state) {
    Joint& joint = alone.joints.front();
    const auto i = at(joint.body_i);
    const auto j = at(joint.body_j);
    alone.bodies = {alone.bodies[i], alone.bodies[j]};
    state.r = {state.r[i], state.r[j]};
    state.p = {state.p[i], state.p[j]};
    joint.body_i = 0;
    joint.body_j = 1;
}

/// All rows of one p1 / p2 constraint in a form, (r, ω') columns of its moving bodies in the scene's unit.
MatrixX complete_rows(const System& system, const Constraint& c, const State& state, ParallelForm form) {
    Mechanism alone;
    alone.bodies = system.mechanism().bodies;
    alone.joints = {system.mechanism().joints[static_cast<std::size_t>(c.joint)]};
    alone.joints[0].parallel_form = form;
    alone.joints[0].without.clear();
    State local = state;
    if (system.columns(3) > kMostDenseColumns) { keep_bodies_of_joint(alone, local); }
    local.theta.assign(static_cast<std::size_t>(alone.thetas_count()), 0.0);
    const System system_alone(alone, everything(alone));
    Assembler<OmegaLocal> assembler(system_alone);
    assembler.assemble_phi_and_jacobian(local, 0.0);
    const auto own = std::ranges::find(system_alone.constraints(), c.role, &Constraint::role);
    MatrixX rows = assembler.jacobian().middleRows(own->first_row, own->equations);
    for (const int body : system_alone.moving_bodies()) {
        rows.middleCols<3>(system_alone.body_column(body, 3)) *= system.length_unit();
    }
    return rows;
}

/// The rows of `all` that a mask does not leave out.
MatrixX without_rows(const MatrixX& all, unsigned left_out) {
    std::vector<int> kept;
    for (int k = 0; k < all.rows(); ++k) {
        if (((left_out >> k) & 1U) == 0) { kept.push_back(k); }
    }
    return all(kept, Eigen::all);
}

}  // namespace

RowChoice explain_choice(const System& system, int constraint, const State& state, int previous) {
    const Constraint& c = system.constraints()[static_cast<std::size_t>(constraint)];
    const Joint& joint = system.mechanism().joints[static_cast<std::size_t>(c.joint)];

    RowChoice choice;
    choice.form = joint.parallel_form;
    choice.dropped = c.dropped;
    choice.previous = previous;
    choice.taken_out = c.taken_out;
    choice.s_i =
        rotation_matrix(state.p[static_cast<std::size_t>(c.body_i)]) * joint.geometry.s_i_local.normalized();

    const MatrixX all_three = complete_rows(system, c, state, ParallelForm::all_three);
    for (unsigned k = 0; k < 3; ++k) {
        choice.pair_condition[k] = condition_of_rows(without_rows(all_three, 1U << k));
    }
    const MatrixX all = joint.parallel_form == ParallelForm::pair
                            ? complete_rows(system, c, state, ParallelForm::pair)
                            : all_three;
    choice.form_condition = condition_of_rows(without_rows(all, c.left_out()));
    return choice;
}

}  // namespace jw
