#include "jointwise/evaluator.hpp"

#include <cmath>
#include <optional>
#include <variant>

#include "core/kinematics/kinematics.hpp"
#include "core/poses/large_rank.hpp"
#include "core/poses/position.hpp"
#include "library/convert.hpp"
#include "library/inside.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

using AnyAssembler = std::variant<
    jw::Assembler<jw::TrueEulerParameters>, jw::Assembler<jw::ModifiedEulerParameters>,
    jw::Assembler<jw::OmegaLocal>, jw::Assembler<jw::OmegaGlobal>>;

jw::CoordinateChoice choice_of(Coordinates coordinates) {
    switch (coordinates) {
        case Coordinates::true_euler_parameters: return jw::CoordinateChoice::true_euler_parameters;
        case Coordinates::modified_euler_parameters: return jw::CoordinateChoice::modified_euler_parameters;
        case Coordinates::omega_global: return jw::CoordinateChoice::omega_global;
        case Coordinates::omega_local: break;
    }
    return jw::CoordinateChoice::omega_local;
}

AnyAssembler assembler_of(const jw::System& system, Coordinates coordinates) {
    return jw::with_choice(choice_of(coordinates), [&](auto c) {
        return AnyAssembler(std::in_place_type<jw::Assembler<decltype(c)>>, system);
    });
}

NotReached contradicted(
    const jw::System& system, const jw::LinearVerdict& verdict, const char* what, double t) {
    return NotReached(
        std::string("jointwise: ") + what + " at t = " + number_text(t) +
        " s contradict each other; the largest residual is that of " + row_name(system, verdict.worst_row));
}

/// Names of the columns of one moving body, without the body's name and the dot.
std::vector<std::string> words_of_body(Coordinates coordinates) {
    switch (coordinates) {
        case Coordinates::omega_local:
            return {"x", "y", "z", "omega_local.x", "omega_local.y", "omega_local.z"};
        case Coordinates::omega_global: return {"x", "y", "z", "omega.x", "omega.y", "omega.z"};
        case Coordinates::true_euler_parameters:
        case Coordinates::modified_euler_parameters: break;
    }
    return {"x", "y", "z", "e0", "e1", "e2", "e3"};
}

Rank rank_of(const jw::System& system, const jw::RankReport& report) {
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

}  // namespace

struct Evaluator::Inside {
    Inside(const Mechanism& of, Coordinates choice)
        : mechanism(of),
          coordinates(choice),
          system(data(), jw::everything(data())),
          state(jw::start_state(data())),
          assembler(assembler_of(system, choice)) {
        name_rows();
    }

    const jw::Mechanism& data() const { return mechanism.inside().mechanism; }

    void name_rows() {
        names.clear();
        const int rows =
            std::visit([](const auto& a) { return static_cast<int>(a.phi().size()); }, assembler);
        for (int row = 0; row < rows; ++row) { names.push_back(row_name(system, row)); }
    }

    /// Velocities and accelerations are those of (r, ω'), whatever the chosen coordinates.
    jw::Kinematics<jw::OmegaLocal>& kinematics_at(const Pose& pose) {
        read_state(data(), pose, state);
        if (!kinematics) { kinematics.emplace(system); }
        kinematics->set_state(state, pose.t);
        return *kinematics;
    }

    Mechanism mechanism;
    Coordinates coordinates;
    jw::System system;
    jw::State state;  ///< of the pose that is evaluated
    jw::Motion motion;
    AnyAssembler assembler;
    std::optional<jw::Kinematics<jw::OmegaLocal>> kinematics;
    std::vector<std::string> names;
};

Evaluator::Evaluator(const Mechanism& mechanism, Coordinates coordinates)
    : inside_(std::make_unique<Inside>(mechanism, coordinates)) {}
Evaluator::~Evaluator() = default;
Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;

int Evaluator::rows() const { return static_cast<int>(inside_->names.size()); }

int Evaluator::columns() const {
    return std::visit([](const auto& assembler) { return assembler.layout().columns(); }, inside_->assembler);
}

const std::vector<std::string>& Evaluator::row_names() const { return inside_->names; }

std::vector<std::string> Evaluator::column_names() const {
    const jw::Mechanism& mechanism = inside_->data();
    const std::vector<std::string> words = words_of_body(inside_->coordinates);
    std::vector<std::string> names;
    for (const int body : inside_->system.moving_bodies()) {
        for (const std::string& word : words) {
            names.push_back(mechanism.bodies[static_cast<std::size_t>(body)].name + "." + word);
        }
    }
    const std::vector<int> thetas = mechanism.theta_indices();
    for (std::size_t joint = 0; joint < thetas.size(); ++joint) {
        if (thetas[joint] >= 0) { names.push_back(mechanism.joints[joint].name + ".angle"); }
    }
    return names;
}

bool Evaluator::choose_rows(const Pose& pose) {
    read_state(inside_->data(), pose, inside_->state);
    if (!inside_->system.choose_rows(inside_->state)) { return false; }
    inside_->kinematics.reset();
    inside_->name_rows();
    return true;
}

void Evaluator::equations_at(const Pose& pose, const Rates& velocities, Equations& out) {
    Inside& in = *inside_;
    read_state(in.data(), pose, in.state);
    read_motion(in.data(), velocities, in.motion);
    std::visit(
        [&](auto& assembler) {
            assembler.assemble_phi_and_jacobian(in.state, pose.t);
            assembler.assemble_nu(pose.t);
            assembler.assemble_gamma(in.state, in.motion, pose.t);
            out.phi = assembler.phi();
            out.jacobian.resize(assembler.phi().size(), assembler.layout().columns());
            assembler.sparse_jacobian().write(out.jacobian);
            out.nu = assembler.nu();
            out.gamma = assembler.gamma();
        },
        in.assembler);
    if (out.rows != in.names) { out.rows = in.names; }
}

EquationsTable Evaluator::equations_along(const Trajectory& trajectory) {
    const Eigen::Index times = trajectory.times();
    EquationsTable table;
    for (Table* t : {&table.phi, &table.nu, &table.gamma}) { t->resize(times, rows()); }
    table.jacobian.resize(times, Eigen::Index{rows()} * columns());
    Equations now;
    for (int k = 0; k < trajectory.times(); ++k) {
        const Moment moment = trajectory.moment(k);
        equations_at(moment.pose, moment.velocity, now);
        table.phi.row(k) = now.phi;
        table.nu.row(k) = now.nu;
        table.gamma.row(k) = now.gamma;
        Eigen::Map<Table>(table.jacobian.row(k).data(), rows(), columns()) = now.jacobian;
    }
    return table;
}

void Evaluator::phi_at(const Pose& pose, Eigen::VectorXd& out) {
    Inside& in = *inside_;
    read_state(in.data(), pose, in.state);
    std::visit(
        [&](auto& assembler) {
            assembler.assemble_phi_and_jacobian(in.state, pose.t);
            out = assembler.phi();
        },
        in.assembler);
}

Eigen::VectorXd Evaluator::columns_of(const Pose& pose, const Rates& rates) const {
    const jw::State state = state_of(inside_->data(), pose);
    const jw::Motion motion = motion_of(inside_->data(), rates);
    return std::visit(
        [&](const auto& assembler) -> Eigen::VectorXd {
            return assembler.layout().columns_of(state, motion);
        },
        inside_->assembler);
}

Pose Evaluator::assemble(const Pose& estimate, double t) {
    Inside& in = *inside_;
    read_state(in.data(), estimate, in.state);
    if (!std::isfinite(t)) { throw std::invalid_argument("jointwise: the time is not finite"); }
    const jw::PositionOutcome outcome = jw::solve_position<jw::OmegaLocal>(in.system, in.state, t);
    if (outcome.ok()) { return pose_of(in.state, t); }
    const jw::PositionFailure& failure = *outcome.failure;
    throw NotReached(
        "jointwise: the mechanism cannot be assembled at t = " + number_text(t) +
        " s: " + row_name(in.system, failure.row) + " stays off by " + number_text(failure.value));
}

Rank Evaluator::rank_at(const Pose& pose) {
    Inside& in = *inside_;
    read_state(in.data(), pose, in.state);
    jw::Assembler<jw::OmegaLocal> assembler(in.system);
    assembler.assemble_phi_and_jacobian(in.state, pose.t);
    return rank_of(
        in.system,
        jw::analyse_rank_of_any_size(in.system, assembler.sparse_jacobian(), assembler.phi(), false));
}

Rates Evaluator::velocities_at(const Pose& pose) {
    jw::Kinematics<jw::OmegaLocal>& kinematics = inside_->kinematics_at(pose);
    const jw::VelocityOutcome outcome = kinematics.solve_velocity(jw::zero_motion(inside_->data()));
    if (!outcome.verdict.consistent) {
        throw contradicted(inside_->system, outcome.verdict, "velocities", pose.t);
    }
    return rates_of(outcome.velocity);
}

Rates Evaluator::accelerations_at(const Pose& pose, const Rates& velocities) {
    jw::Kinematics<jw::OmegaLocal>& kinematics = inside_->kinematics_at(pose);
    const jw::AccelerationOutcome outcome =
        kinematics.solve_acceleration(motion_of(inside_->data(), velocities));
    if (!outcome.verdict.consistent) {
        throw contradicted(inside_->system, outcome.verdict, "accelerations", pose.t);
    }
    return rates_of(outcome.acceleration);
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
