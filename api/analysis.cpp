#include "jointwise/analysis.hpp"

#include "api/convert.hpp"
#include "api/inside.hpp"
#include "core/kinematics/kinematics.hpp"
#include "core/poses/large_rank.hpp"
#include "core/poses/position.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

/// All equations of a mechanism, with the rows of p1 and p2 that its rule keeps at a state.
jw::System system_at(const jw::Mechanism& mechanism, const jw::State& state) {
    jw::System system(mechanism, jw::everything(mechanism));
    system.choose_rows(state);
    return system;
}

NotReached contradicted(
    const jw::System& system, const jw::LinearVerdict& verdict, const char* what, double t) {
    return NotReached(
        std::string("jointwise: ") + what + " at t = " + std::to_string(t) +
        " s contradict each other; the largest residual is that of " + row_name(system, verdict.worst_row));
}

jw::CoordinateChoice choice_of(Coordinates coordinates) {
    switch (coordinates) {
        case Coordinates::true_euler_parameters: return jw::CoordinateChoice::true_euler_parameters;
        case Coordinates::modified_euler_parameters: return jw::CoordinateChoice::modified_euler_parameters;
        case Coordinates::omega_global: return jw::CoordinateChoice::omega_global;
        case Coordinates::omega_local: break;
    }
    return jw::CoordinateChoice::omega_local;
}

}  // namespace

Pose start_pose(const Mechanism& mechanism) {
    return pose_of(jw::start_state(mechanism.inside().mechanism), 0.0);
}

Rates start_rates(const Mechanism& mechanism) {
    return rates_of(jw::start_motion(mechanism.inside().mechanism));
}

Pose assemble(const Mechanism& mechanism, double t) { return assemble(mechanism, start_pose(mechanism), t); }

Pose assemble(const Mechanism& mechanism, const Pose& estimate, double t) {
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    jw::State state = state_of(inside, estimate);
    const jw::System system = system_at(inside, state);
    const jw::PositionOutcome outcome = jw::solve_position<jw::OmegaLocal>(system, state, t);
    if (outcome.ok()) { return pose_of(state, t); }
    const jw::PositionFailure& failure = *outcome.failure;
    throw NotReached(
        "jointwise: the mechanism cannot be assembled at t = " + std::to_string(t) +
        " s: " + row_name(system, failure.row) + " stays off by " + std::to_string(failure.value));
}

Equations equations_at(
    const Mechanism& mechanism, const Pose& pose, const Rates& velocities, Coordinates coordinates) {
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    const jw::State state = state_of(inside, pose);
    const jw::System system = system_at(inside, state);
    Equations equations;
    jw::with_choice(choice_of(coordinates), [&](auto c) {
        jw::Assembler<decltype(c)> assembler(system);
        assembler.assemble_phi_and_jacobian(state, pose.t);
        assembler.assemble_nu(pose.t);
        assembler.assemble_gamma(state, motion_of(inside, velocities), pose.t);
        equations.phi = assembler.phi();
        equations.jacobian = assembler.jacobian();
        equations.nu = assembler.nu();
        equations.gamma = assembler.gamma();
    });
    for (int row = 0; row < equations.phi.size(); ++row) { equations.rows.push_back(row_name(system, row)); }
    return equations;
}

Rank rank_at(const Mechanism& mechanism, const Pose& pose) {
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    const jw::State state = state_of(inside, pose);
    const jw::System system = system_at(inside, state);
    jw::Assembler<jw::OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, pose.t);
    const jw::RankReport report =
        jw::analyse_rank_of_any_size(system, assembler.sparse_jacobian(), assembler.phi(), false);
    Rank rank{
        report.rows,
        report.columns,
        report.rank,
        report.dof,
        report.redundant(),
        report.mobility_by_counting,
        report.decided,
        report.singular_values,
        {},
        {}};
    for (const jw::RedundantRow& row : report.redundant_rows) {
        rank.redundant_rows.push_back(row_name(system, row.row));
    }
    rank.free_motions.resize(report.columns, static_cast<Eigen::Index>(report.free_motions.size()));
    for (std::size_t k = 0; k < report.free_motions.size(); ++k) {
        rank.free_motions.col(static_cast<Eigen::Index>(k)) = report.free_motions[k];
    }
    return rank;
}

Rates velocities_at(const Mechanism& mechanism, const Pose& pose) {
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    const jw::State state = state_of(inside, pose);
    const jw::System system = system_at(inside, state);
    jw::Kinematics<jw::OmegaLocal> kinematics(system);
    kinematics.set_state(state, pose.t);
    const jw::VelocityOutcome outcome = kinematics.solve_velocity(jw::zero_motion(inside));
    if (!outcome.verdict.consistent) { throw contradicted(system, outcome.verdict, "velocities", pose.t); }
    return rates_of(outcome.velocity);
}

Rates accelerations_at(const Mechanism& mechanism, const Pose& pose, const Rates& velocities) {
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    const jw::State state = state_of(inside, pose);
    const jw::System system = system_at(inside, state);
    jw::Kinematics<jw::OmegaLocal> kinematics(system);
    kinematics.set_state(state, pose.t);
    const jw::AccelerationOutcome outcome = kinematics.solve_acceleration(motion_of(inside, velocities));
    if (!outcome.verdict.consistent) { throw contradicted(system, outcome.verdict, "accelerations", pose.t); }
    return rates_of(outcome.acceleration);
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
