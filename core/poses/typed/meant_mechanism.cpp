#include "core/poses/typed/meant_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/poses/position.hpp"
#include "core/poses/rank.hpp"
#include "core/poses/typed/loose_motion.hpp"

namespace jw {

namespace {

// a change of the numbers moves poses, too, by its size over the last singular value that counts
constexpr double kMostEffect = 1e3;
constexpr double kStep = 0.25;  // of the walk, largest turn [rad] or displacement in sizes of the machine
constexpr double kCheckStep = 0.29;  // other poses than those of the walk
constexpr int kMostSteps = 14;       // half a turn in either sense
constexpr int kMostCheckSteps = 40;  // nearly two turns
constexpr int kLeastSteps = 4;       // a motion of a radian is one of finite length
constexpr int kMostFits = 12;
constexpr int kMostRounds = 4;
// what all digits together may change, with those that short numbers have lost; more has another reason
constexpr double kDoubtful = 5.0;
// a linear fit leaves errors of second order, which the next one removes: as few as can be removed by changes
// within the half units, since those of weak conditions are as large as what they ask for
constexpr double kLinearRest = 1e-5;
constexpr double kMostLinearRest = 2e-2;
constexpr double kRounding = 1e-16;
// of the conditions, which are known to about nine digits of a change by half a unit
constexpr double kLeastSingular = 1e-9;
constexpr double kDifference = 1e-5;
// singular values below it are rounding
constexpr double kExact = 1e-13;

/// First-order conditions A x = b for the changes x of the numbers, in half units, with which the equations
/// hold at poses nearby.
struct Conditions {
    MatrixX A;
    VectorX b;
    double misfit = 0.0;  ///< largest |Φ| at the poses, scaled
    bool is_met = true;   ///< up to rounding
    double excess = 0.0;  ///< largest |b| as a multiple of what changes of ±1 can add up to
};

class MeantSearch {
public:
    MeantSearch(const Mechanism& mechanism, const std::vector<TypedNumber>& numbers)
        : typed_(mechanism), numbers_(numbers), mechanism_(mechanism) {
        changes_.setZero(static_cast<Eigen::Index>(numbers.size()));
    }

    std::optional<MeantMechanism> run();

private:
    bool find_rank(const State& start);
    Conditions conditions(const std::vector<State>& poses) const;
    VectorX derivative(const System& system, const State& state, const TypedNumber& number) const;
    bool fit(std::vector<State>& poses);
    bool find_meant(State start, std::vector<State> poses);
    void apply();

    const Mechanism& typed_;
    const std::vector<TypedNumber>& numbers_;
    Mechanism mechanism_;
    VectorX changes_;  ///< changes of the numbers in half units
    int rank_ = 0;
    TypedVerdict verdict_;
};

JointGeometry changed(JointGeometry geometry, const TypedNumber& number, double by) {
    for (const auto& [vector, direction] : number.vectors) { geometry.*vector += by * direction; }
    if (number.scalar != nullptr) { geometry.*number.scalar += by; }
    return geometry;
}

bool is_length(const TypedNumber& number) {
    return number.scalar != nullptr || number.vectors.front().vector == &JointGeometry::P_i_local ||
           number.vectors.front().vector == &JointGeometry::P_j_local;
}

/// Angles are measured from vectors across the axis.
void keep_sides_perpendicular(JointGeometry& g) {
    const auto across = [](const Vec3& u, const Vec3& s) {
        return Vec3((u - u.dot(s) / s.squaredNorm() * s).normalized());
    };
    g.u_i_local = across(g.u_i_local, g.s_i_local);
    g.u_j_local = across(g.u_j_local, g.s_j_local);
}

void MeantSearch::apply() {
    mechanism_.joints = typed_.joints;
    for (std::size_t k = 0; k < numbers_.size(); ++k) {
        JointGeometry& g = mechanism_.joints[at(numbers_[k].joint)].geometry;
        g = changed(g, numbers_[k], changes_(static_cast<Eigen::Index>(k)) * numbers_[k].half_unit);
    }
    // axes keep their lengths
    for (std::size_t j = 0; j < typed_.joints.size(); ++j) {
        for (Vec3 JointGeometry::*axis : {&JointGeometry::s_i_local, &JointGeometry::s_j_local}) {
            const double length = (typed_.joints[j].geometry.*axis).norm();
            (mechanism_.joints[j].geometry.*axis) *= length / (mechanism_.joints[j].geometry.*axis).norm();
        }
    }
}

/// Candidate for the rank: the largest gap above singular values that a change of the digits may explain.
/// @return false if there are none
bool MeantSearch::find_rank(const State& start) {
    const JointEquations equations(mechanism_, start);
    const Svd svd = equations.svd();
    if (!svd.sound) { return false; }
    const double unit = std::max(1.0, svd.sigma(0));
    double half_unit = 0.0;
    for (const TypedNumber& number : numbers_) {
        half_unit = std::max(
            half_unit, number.half_unit / (is_length(number) ? equations.system.length_unit() : 1.0));
    }
    verdict_.rank_as_typed = static_cast<int>(svd.rank(kRankThreshold * unit));
    double gap = 0.0;
    for (int r = static_cast<int>(svd.rank(kExact * unit)) - 1;
         r > 0 && svd.sigma(r) <= kMostEffect * half_unit; --r) {
        if (svd.sigma(r - 1) / svd.sigma(r) > gap) {
            gap = svd.sigma(r - 1) / svd.sigma(r);
            rank_ = r;
        }
    }
    return rank_ > 0;
}

/// Change of the scaled rows per half unit of a number.
VectorX MeantSearch::derivative(
    const System& equations, const State& state, const TypedNumber& number) const {
    VectorX out = VectorX::Zero(equations.rows());
    const Joint& joint = mechanism_.joints[at(number.joint)];
    for (const Constraint& c : equations.constraints()) {
        if (c.joint != number.joint) { continue; }
        const auto values = [&](double by) {
            Constraint moved = c;
            moved.primitive = primitive_of(c.role, changed(joint.geometry, number, by), joint.parallel_form);
            return values_of(moved, state);
        };
        // equations are at most quadratic in a number: the difference is exact up to rounding
        const VectorX change =
            (values(kDifference) - values(-kDifference)) * (number.half_unit / (2.0 * kDifference * c.unit));
        int row = c.first_row;
        for (int k = 0; k < c.equations; ++k) {
            if (c.has_row(k)) { out(row++) = change(k); }
        }
    }
    return out;
}

Conditions MeantSearch::conditions(const std::vector<State>& poses) const {
    const auto count = static_cast<Eigen::Index>(numbers_.size());
    Conditions out;
    for (const State& pose : poses) {
        const JointEquations equations(mechanism_, pose);
        const VectorX phi = equations.scaled.phi();
        const Eigen::Index each = phi.size() - rank_;
        const double rounding = residual_tolerance(equations.system, pose);
        out.misfit = std::max(out.misfit, equations.misfit());
        out.is_met = out.is_met && equations.misfit() <= rounding;
        const MatrixX left = svd_of(equations.scaled.jacobian().transpose()).V.rightCols(each);
        const Eigen::Index row = out.b.size();
        out.A.conservativeResize(row + each, count);
        out.b.conservativeResize(row + each);
        for (Eigen::Index k = 0; k < count; ++k) {
            out.A.block(row, k, each, 1) =
                left.transpose() * derivative(equations.system, pose, numbers_[at(k)]);
        }
        out.b.tail(each) = -(left.transpose() * phi);
        for (Eigen::Index k = row; k < row + each; ++k) {
            if (std::abs(out.b(k)) <= rounding) { continue; }
            const double most = std::max(out.A.row(k).cwiseAbs().sum(), kRounding);
            out.excess = std::max(out.excess, std::abs(out.b(k)) / most);
        }
    }
    return out;
}

/// Smallest x, |x_k| <= 1, with |A x - b| up to `least_rest`. Entries that would be larger are set to ±1, one
/// round after the other.
std::optional<VectorX> smallest_changes(const MatrixX& A, const VectorX& b, double least_rest) {
    VectorX x = VectorX::Zero(A.cols());
    std::vector<bool> is_fixed(at(A.cols()), false);
    for (Eigen::Index round = 0; round < A.cols(); ++round) {
        VectorX rest = b;
        MatrixX free = A;
        for (Eigen::Index k = 0; k < A.cols(); ++k) {
            if (!is_fixed[at(k)]) { continue; }
            rest -= x(k) * A.col(k);
            free.col(k).setZero();
        }
        const Svd svd = svd_of(free);
        VectorX y = VectorX::Zero(A.cols());
        for (Eigen::Index k = 0; k < svd.sigma.size() && rest.norm() > least_rest; ++k) {
            if (svd.sigma(k) <= kLeastSingular * svd.sigma(0)) { break; }
            const double part = svd.U.col(k).dot(rest);
            rest -= part * svd.U.col(k);
            y += part / svd.sigma(k) * svd.V.col(k);
        }
        if (rest.norm() > 2.0 * least_rest) { return std::nullopt; }
        bool is_within = true;
        for (Eigen::Index k = 0; k < A.cols(); ++k) {
            if (is_fixed[at(k)]) { continue; }
            x(k) = y(k);
            if (std::abs(y(k)) <= 1.0) { continue; }
            x(k) = std::copysign(1.0, y(k));
            is_fixed[at(k)] = true;
            is_within = false;
        }
        if (is_within) { return x; }
    }
    return std::nullopt;
}

/// Changes the numbers until all equations hold at all poses, which follow.
bool MeantSearch::fit(std::vector<State>& poses) {
    for (int k = 0; k < kMostFits; ++k) {
        const Conditions c = conditions(poses);
        if (c.is_met) { return true; }
        // of the whole changes, with those made before
        const VectorX whole = c.b + c.A * changes_;
        const double rounding = kRounding * std::sqrt(static_cast<double>(c.b.size()));
        std::optional<VectorX> changes;
        for (double rest = kLinearRest; !changes && rest <= kMostLinearRest; rest *= 10.0) {
            changes = smallest_changes(c.A, whole, std::max(rest * c.b.norm(), rounding));
        }
        if (!changes) { return false; }
        changes_ = *changes;
        apply();
        if (!std::ranges::all_of(poses, [&](State& pose) { return settle(mechanism_, rank_, pose); })) {
            return false;
        }
    }
    return false;
}

/// Fits the numbers to the poses of a walk until the equations hold on another, longer one, too; poses of
/// that one at which they do not are fitted as well.
bool MeantSearch::find_meant(State start, std::vector<State> poses) {
    for (int round = 0; round < kMostRounds; ++round) {
        if (!fit(poses) || !settle(mechanism_, rank_, start)) { return false; }
        const std::vector<State> others = walk(mechanism_, rank_, start, kCheckStep, kMostCheckSteps);
        const std::size_t fitted = poses.size();
        std::ranges::copy_if(others, std::back_inserter(poses), [&](const State& pose) {
            const JointEquations equations(mechanism_, pose);
            return equations.misfit() > residual_tolerance(equations.system, pose);
        });
        if (poses.size() == fitted) { return static_cast<int>(others.size()) > kLeastSteps; }
    }
    return false;
}

std::optional<MeantMechanism> MeantSearch::run() {
    State start = start_state(mechanism_);
    {
        const JointEquations equations(mechanism_, start);
        const std::size_t bodies = equations.system.moving_bodies().size();
        if (numbers_.empty() || equations.system.rows() == 0 || bodies == 0 || bodies > kMostTypedBodies) {
            return std::nullopt;
        }
        if (!solve_position<OmegaLocal>(equations.system, start, 0.0).ok()) {
            start = closest_fit(equations.system, start, 0.0);
        }
    }
    if (!find_rank(start) || !settle(mechanism_, rank_, start)) { return std::nullopt; }
    verdict_.rank = rank_;
    const std::vector<State> poses = walk(mechanism_, rank_, start, kStep, kMostSteps);
    if (static_cast<int>(poses.size()) <= kLeastSteps) { return std::nullopt; }
    const Conditions as_typed = conditions(poses);
    if (as_typed.excess > kDoubtful) { return std::nullopt; }
    verdict_.misfit = as_typed.misfit;
    verdict_.is_told = find_meant(start, poses);
    if (!verdict_.is_told) { return MeantMechanism{verdict_, {}}; }
    verdict_.share = changes_.cwiseAbs().maxCoeff();
    MeantMechanism meant{verdict_, {}};
    for (Joint& joint : mechanism_.joints) {
        if (joint.type->has_angle()) { keep_sides_perpendicular(joint.geometry); }
        meant.geometry.push_back(joint.geometry);
    }
    return meant;
}

}  // namespace

std::optional<MeantMechanism> judge_typed_numbers(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers) {
    return MeantSearch(mechanism, numbers).run();
}

}  // namespace jw
