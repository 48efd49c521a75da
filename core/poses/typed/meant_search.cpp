#include "core/poses/typed/meant_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/poses/large_rank.hpp"
#include "core/poses/position.hpp"
#include "core/poses/rank.hpp"
#include "core/poses/typed/loose_motion.hpp"
#include "core/poses/typed/smallest_changes.hpp"

namespace jw {

namespace {

// a change of the numbers also moves poses, by its size divided by the last singular value that counts
constexpr double kMostEffect = 1e3;
constexpr double kStep = 0.25;  // of the walk, largest turn [rad] or displacement in sizes of the machine
constexpr double kCheckStep = 0.29;  // gives other poses than those of the walk
constexpr int kMostSteps = 14;       // half a turn in each direction
constexpr int kMostCheckSteps = 40;  // nearly two turns
constexpr int kLeastSteps = 4;       // a motion of a radian counts as finite
constexpr int kMostFits = 12;
constexpr int kMostRounds = 4;
// limit of the misfit that all digits together may cause, with those that short numbers have lost; a larger
// one has another cause
constexpr double kDoubtful = 5.0;
// a linear fit leaves errors of second order, which the next fit removes. The limit is as small as changes
// within the half units allow, since errors of weak conditions are as large as the changes that they require
constexpr double kLinearRest = 1e-5;
constexpr double kMostLinearRest = 2e-2;
constexpr double kRounding = 1e-16;
// singular values below it are rounding
constexpr double kExact = 1e-13;
// a joint takes part in the redundancy if its share in the combinations of redundant rows exceeds this:
// joints of a loop have equal shares, all others only the misfit
constexpr double kTakesPart = 1e-3;

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
    MeantSearch(const Mechanism& mechanism, const std::vector<TypedNumber>& numbers, const RankDoubt& doubt)
        : typed_(mechanism), numbers_(numbers), mechanism_(mechanism), rank_(doubt.rank) {
        changes_.setZero(static_cast<Eigen::Index>(numbers.size()));
        verdict_.rank = doubt.rank;
        verdict_.rank_as_typed = doubt.rank_as_typed;
    }

    std::optional<MeantPart> run(State start);

private:
    Conditions conditions(const std::vector<State>& poses) const;
    bool fit(std::vector<State>& poses);
    bool find_meant(State start, std::vector<State> poses);

    const Mechanism& typed_;
    const std::vector<TypedNumber>& numbers_;
    Mechanism mechanism_;
    VectorX changes_;  ///< changes of the numbers in half units
    int rank_;
    TypedVerdict verdict_;
};

/// Makes the vectors from which angles are measured perpendicular to the axis.
void keep_sides_perpendicular(JointGeometry& g) {
    const auto across = [](const Vec3& u, const Vec3& s) {
        return Vec3((u - u.dot(s) / s.squaredNorm() * s).normalized());
    };
    g.u_i_local = across(g.u_i_local, g.s_i_local);
    g.u_j_local = across(g.u_j_local, g.s_j_local);
}

/// Largest effect of half a unit on the scaled rows.
double largest_half_unit(const std::vector<TypedNumber>& numbers, double length_unit) {
    double largest = 0.0;
    for (const TypedNumber& number : numbers) {
        for (const TypedNumber::Change& change : number.changes) {
            const double size = change.scalar != nullptr ? 1.0 : change.direction.norm();
            largest = std::max(largest, number.half_unit * size / (change.is_length() ? length_unit : 1.0));
        }
    }
    return largest;
}

/// Orthonormal columns that span the combinations of rows that vanish at this rank.
MatrixX combinations_of(const JointEquations& equations, int rank) {
    const MatrixX jacobian = equations.scaled.jacobian();
    return svd_of(jacobian.transpose()).V.rightCols(jacobian.rows() - rank);
}

/// Joints with rows that take part in the combinations.
std::vector<int> joints_in(const MatrixX& combinations, const System& system) {
    VectorX parts = VectorX::Zero(static_cast<Eigen::Index>(system.mechanism().joints.size()));
    for (const Constraint& c : system.constraints()) {
        parts(c.joint) += combinations.middleRows(c.first_row, c.rows()).squaredNorm();
    }
    std::vector<int> joints;
    for (Eigen::Index j = 0; j < parts.size(); ++j) {
        if (parts(j) > kTakesPart * kTakesPart) { joints.push_back(static_cast<int>(j)); }
    }
    return joints;
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
        const MatrixX left = combinations_of(equations, rank_);
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

/// Changes the numbers until all equations hold at all poses, which are moved accordingly.
bool MeantSearch::fit(std::vector<State>& poses) {
    for (int k = 0; k < kMostFits; ++k) {
        const Conditions c = conditions(poses);
        if (c.is_met) { return true; }
        // for the total changes, including earlier ones
        const VectorX whole = c.b + c.A * changes_;
        const double rounding = kRounding * std::sqrt(static_cast<double>(c.b.size()));
        std::optional<VectorX> changes;
        for (double rest = kLinearRest; !changes && rest <= kMostLinearRest; rest *= 10.0) {
            changes = smallest_changes(c.A, whole, std::max(rest * c.b.norm(), rounding));
        }
        if (!changes) { return false; }
        changes_ = *changes;
        mechanism_.joints = changed_joints(typed_.joints, numbers_, changes_);
        if (!std::ranges::all_of(
                poses, [&](State& pose) { return settle(mechanism_, rank_, pose).has_value(); })) {
            return false;
        }
    }
    return false;
}

/// Fits the numbers to the poses of a walk until the equations also hold on another, longer walk; its poses
/// at which they do not hold are fitted as well.
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

std::optional<MeantPart> MeantSearch::run(State start) {
    if (!settle(mechanism_, rank_, start)) { return std::nullopt; }
    // a misfit that digits do not explain is usually visible at the first steps of the long walk
    if (conditions(walk(mechanism_, rank_, start, kStep, 1)).excess > kDoubtful) { return std::nullopt; }
    const std::vector<State> poses = walk(mechanism_, rank_, start, kStep, kMostSteps);
    if (static_cast<int>(poses.size()) <= kLeastSteps) { return std::nullopt; }
    const Conditions as_typed = conditions(poses);
    if (as_typed.excess > kDoubtful) { return std::nullopt; }
    verdict_.misfit = as_typed.misfit;
    verdict_.is_told = find_meant(start, poses);
    if (verdict_.is_told) { verdict_.share = changes_.cwiseAbs().maxCoeff(); }
    MeantPart part{verdict_, {}, {}};
    for (std::size_t k = 0; k < numbers_.size(); ++k) {
        part.effects.push_back({numbers_[k].index, as_typed.A.col(static_cast<Eigen::Index>(k)).norm()});
    }
    for (const Joint& joint : (verdict_.is_told ? mechanism_ : typed_).joints) {
        part.geometry.push_back(joint.geometry);
        if (verdict_.is_told && joint.type->has_angle()) { keep_sides_perpendicular(part.geometry.back()); }
    }
    return part;
}

}  // namespace

State best_start(const System& system) {
    State start = start_state(system.mechanism());
    const bool closes = solve_position<OmegaLocal>(system, start, 0.0).ok();
    return closes ? start : closest_fit(system, start, 0.0);
}

std::optional<RankDoubt> find_doubt(const Mechanism& mechanism, const std::vector<TypedNumber>& numbers) {
    const System system(mechanism, joints_of(mechanism));
    if (numbers.empty() || system.rows() == 0 || system.moving_bodies().empty() ||
        system.columns(OmegaLocal::kAngular) > kMostColumnsWithSpectrum) {
        return std::nullopt;
    }
    RankDoubt doubt{best_start(system), 0, 0, {}};
    const JointEquations equations(mechanism, doubt.start);
    const Svd svd = equations.svd();
    if (!svd.sound) { return std::nullopt; }
    const double unit = std::max(1.0, svd.sigma(0));
    const double most = kMostEffect * largest_half_unit(numbers, equations.system.length_unit());
    doubt.rank_as_typed = static_cast<int>(svd.rank(kRankThreshold * unit));
    // the largest gap above singular values that a change of the digits may explain
    double gap = 0.0;
    for (int r = static_cast<int>(svd.rank(kExact * unit)) - 1; r > 0 && svd.sigma(r) <= most; --r) {
        if (svd.sigma(r - 1) / svd.sigma(r) > gap) {
            gap = svd.sigma(r - 1) / svd.sigma(r);
            doubt.rank = r;
        }
    }
    if (doubt.rank == 0) { return std::nullopt; }
    doubt.joints = joints_in(combinations_of(equations, doubt.rank), equations.system);
    return doubt;
}

std::optional<MeantPart> find_meant(
    const Mechanism& mechanism, const std::vector<TypedNumber>& numbers, const RankDoubt& doubt) {
    return MeantSearch(mechanism, numbers, doubt).run(doubt.start);
}

}  // namespace jw
