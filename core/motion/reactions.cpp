#include "core/motion/reactions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/motion/carriers.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/saddle_point.hpp"
#include "core/numerics/svd.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Share above which a component takes part in a member of the family: far above the error of a null vector,
/// which is the error of the state divided by the smallest singular value.
constexpr double kTakesPart = 1e-6;

// accelerations come from factors of Φq M⁻¹ Φqᵀ, whose condition is that of Φq squared
constexpr double kRoundings = 1e5;

/// M q̈ - Q of every moving body: forces, then torques about the centre of mass over ℓ, global.
struct Needed {
    VectorX wrenches;
    double size = 0.0;   ///< size of the terms whose difference this is
    double sizes = 0.0;  ///< at least that of each load by itself
};

/// Sizes of weights, springs and laws, each by itself.
double sizes_by_themselves(const Situation& s, std::span<const BodyKinematics<OmegaLocal>> bodies) {
    const Loads& loads = s.scene->loads;
    double sum = 0.0;
    for (const auto& mass : loads.masses) { sum += mass ? mass->mass * loads.gravity.norm() : 0.0; }
    for (const Spring& spring : loads.springs) { sum += size_of(spring, bodies, s.t); }
    for (const RotationalSpring& spring : loads.rotational_springs) {
        sum += size_of(spring, s.t) / s.length;
    }
    const auto add_law = [&](const auto& load, double length) {
        if (load.law) { sum += load.direction.norm() * size_of(*load.law, bodies, s.t) / length; }
    };
    for (const AppliedForce& force : loads.forces) { add_law(force, 1.0); }
    for (const AppliedTorque& torque : loads.torques) { add_law(torque, s.length); }
    for (const Bushing& bushing : loads.bushings) { sum += size_of(bushing, bodies, s.length); }
    return sum;
}

Needed needed_wrenches(const Situation& s, const Motion& velocity, const Motion& acceleration) {
    const Loads& loads = s.scene->loads;
    std::vector<BodyKinematics<OmegaLocal>> bodies(s.bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        bodies[b].r = s.bodies[b].r;
        bodies[b].p = s.bodies[b].p;
        bodies[b].A = s.bodies[b].A;
        bodies[b].r_dot = velocity.r_dot[b];
        OmegaLocal::set_motion(bodies[b], velocity.omega_local[b]);
    }
    std::vector<BodyForce> forces(bodies.size());
    add_forces(loads, bodies, s.t, forces);
    VectorX inertia(s.size);
    VectorX applied(s.size);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const int first = s.first_of_body[b];
        if (first < 0) { continue; }
        const MassProperties& m = *loads.masses[b];
        const Mat3 A = bodies[b].A / s.length;
        const Vec3 n_local = forces[b].n_local + gyroscopic_torque(m.J_local, velocity.omega_local[b]);
        inertia.segment<6>(first) << m.mass * acceleration.r_dot[b],
            A * (m.J_local * acceleration.omega_local[b]);
        applied.segment<6>(first) << forces[b].f, A * n_local;
    }
    const double size = inertia.norm() + applied.norm();
    return {inertia - applied, size, size + sizes_by_themselves(s, bodies)};
}

Mat3 axes_along(const Vec3& direction) {
    const Vec3 axis = direction.norm() > 0.0 ? direction.normalized() : Vec3::UnitZ();
    const Vec3 across = perpendicular_to(axis);
    Mat3 axes;
    axes << across, axis.cross(across), axis;
    return axes;
}

/// Reaction of a link without its wrench.
Reaction reaction_of(const Link& link, const Situation& situation) {
    const Place place = place_of(link, situation);
    Reaction out;
    out.joint = link.joint;
    out.driver = link.driver;
    out.body_i = link.body_i;
    out.body_j = link.body_j;
    out.point = place.point;
    out.axes = axes_along(place.direction);
    return out;
}

/// All links together: equilibrium x = M q̈ - Q.
class Bracing {
public:
    explicit Bracing(const Situation& situation);

    const std::vector<Reaction>& reactions() const { return reactions_; }
    std::size_t size() const { return carriers_.size(); }
    /// Columns: the smallest solution x, then the family.
    MatrixX answers(const VectorX& needed) const;
    double residual(const VectorX& x, const Needed& needed) const;
    double bound() const;
    Wrench wrench(std::size_t link, const VectorX& x) const;
    double first_lambda(std::size_t link, const VectorX& x) const;

private:
    VectorX part(std::size_t link, const VectorX& x) const {
        return x.segment(first_[link], carriers_[link].wrench.cols());
    }

    double length_;
    double violation_ = 0.0;
    std::vector<Reaction> reactions_;
    std::vector<Carrier> carriers_;
    std::vector<Eigen::Index> first_;
    MatrixX equilibrium_;
};

Bracing::Bracing(const Situation& s) : length_(s.length) {
    Eigen::Index columns = 0;
    for (const Link& link : links_of(s.scene->mechanism)) {
        if (s.first_of_body[at(link.body_i)] < 0 && s.first_of_body[at(link.body_j)] < 0) { continue; }
        reactions_.push_back(reaction_of(link, s));
        carriers_.push_back(carrier_of(link, reactions_.back().point, s));
        violation_ = std::max(violation_, carriers_.back().violation);
        first_.push_back(columns);
        columns += carriers_.back().wrench.cols();
    }
    equilibrium_.resize(s.size, columns);
    for (std::size_t n = 0; n < carriers_.size(); ++n) {
        equilibrium_.middleCols(first_[n], carriers_[n].wrench.cols()) = carriers_[n].equilibrium;
    }
}

MatrixX Bracing::answers(const VectorX& needed) const {
    if (equilibrium_.cols() == 0) { return MatrixX(0, 1); }
    const Svd svd = svd_of(equilibrium_);
    const Eigen::Index rank = svd.rank(rank_threshold(violation_) * svd.sigma(0));
    const MatrixX& V = svd.V;
    const VectorX components = svd.U.leftCols(rank).transpose() * needed;
    MatrixX out(V.rows(), 1 + V.cols() - rank);
    out << V.leftCols(rank) * components.cwiseQuotient(svd.sigma.head(rank)), V.rightCols(V.cols() - rank);
    return out;
}

double Bracing::residual(const VectorX& x, const Needed& needed) const {
    return needed.size > 0.0 ? (equilibrium_ * x - needed.wrenches).norm() / needed.size : 0.0;
}

double Bracing::bound() const {
    return kRoundings * std::numeric_limits<double>::epsilon() + kErrorFactor * violation_;
}

Wrench Bracing::wrench(std::size_t link, const VectorX& x) const {
    const Vec6 six = carriers_[link].wrench * part(link, x);
    return {six.head<3>(), length_ * six.tail<3>()};
}

double Bracing::first_lambda(std::size_t link, const VectorX& x) const {
    return carriers_[link].lambda.row(0).dot(part(link, x));
}

/// Force or torque along the quantity that the driver prescribes: λ belongs to f, or to f² for a distance.
double effort_of(const Driver& driver, double lambda, double t) {
    const bool squared = std::holds_alternative<SquaredDistanceMeasure>(driver.measure);
    return squared ? 2.0 * driver.function.at(t).f * lambda : lambda;
}

void mark_family(Reaction& reaction, const Wrench& member, double length) {
    const auto mark = [](std::array<bool, 3>& unique, const Vec3& part) {
        for (std::size_t k = 0; k < 3; ++k) {
            unique[k] = unique[k] && std::abs(part(static_cast<Eigen::Index>(k))) < kTakesPart;
        }
    };
    const Vec3 torque = member.torque / length;
    mark(reaction.force_unique, reaction.axes.transpose() * member.force);
    mark(reaction.torque_unique, reaction.axes.transpose() * torque);
    mark(reaction.force_unique_global, member.force);
    mark(reaction.torque_unique_global, torque);
}

}  // namespace

bool Reaction::unique() const {
    const auto yes = [](bool b) { return b; };
    return std::ranges::all_of(force_unique, yes) && std::ranges::all_of(torque_unique, yes);
}

Reactions find_reactions(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const Motion& acceleration) {
    const Situation situation(scene, t, state);
    const Bracing bracing(situation);
    const Needed needed = needed_wrenches(situation, velocity, acceleration);
    const MatrixX answers = bracing.answers(needed.wrenches);
    const VectorX smallest = answers.col(0);
    const double residual = bracing.residual(smallest, needed);
    const double of_loads = needed.sizes > 0.0 ? residual * (needed.size / needed.sizes) : 0.0;
    Reactions out{bracing.reactions(), {}, residual, of_loads, bracing.bound()};
    out.family.resize(at(static_cast<int>(answers.cols())) - 1);
    for (std::size_t n = 0; n < out.reactions.size(); ++n) {
        Reaction& reaction = out.reactions[n];
        reaction.wrench = bracing.wrench(n, smallest);
        if (reaction.driver >= 0) {
            const Driver& driver = scene.mechanism.drivers[at(reaction.driver)];
            reaction.effort = effort_of(driver, bracing.first_lambda(n, smallest), t);
        }
        for (std::size_t member = 0; member < out.family.size(); ++member) {
            out.family[member].push_back(
                bracing.wrench(n, answers.col(static_cast<Eigen::Index>(member) + 1)));
            mark_family(reaction, out.family[member].back(), situation.length);
        }
    }
    return out;
}

Reactions reactions_from_body_frames(
    const Centroidal& scene, double t, const State& state, const Motion& velocity,
    const Motion& centroidal_acceleration) {
    return find_reactions(
        scene, t, scene.to_centroidal(state), scene.to_centroidal(state, velocity), centroidal_acceleration);
}

}  // namespace jw
