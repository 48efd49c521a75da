#include <cstdio>
#include <limits>

#include "core/numerics/svd.hpp"
#include "core/poses/rank.hpp"
#include "tests/soak/property.hpp"
#include "tests/support/long_double_svd.hpp"
#include "tests/support/moved_positions.hpp"
#include "tests/support/scene_builder.hpp"

/// Φq entry by entry, and its singular values, also at poses that are nearly singular.
namespace jw::test {

namespace {

// truncation h⁴ and rounding 1e-19 / h leave about 1e-15 of the size of a row; core works in double
constexpr reference::Real kStep = 1e-4L;
constexpr double kAllowed = 1e-10;
// a drive has to be away from zero for its derivative to count
constexpr double kTime = 0.3;

std::string off_by(const char* what, Eigen::Index row, double off, double allowed) {
    char text[160];
    std::snprintf(
        text, sizeof text, "%s %d is off by %.2g of its size (allowed %.2g)", what, static_cast<int>(row),
        off, allowed);
    return text;
}

/// Unit of every column: lengths in the size of the scene, turns in rad.
template <class C>
VectorX units_of(const System& system, Eigen::Index columns, double length) {
    VectorX units = VectorX::Ones(columns);
    for (const int body : system.moving_bodies()) {
        units.segment<3>(system.body_column(body, C::kAngular)).setConstant(length);
    }
    return units;
}

/// Φq of the choice C against differences of Φ as the slides write it, in long double.
template <class C>
std::string differs(const System& system, const State& state, double length) {
    Assembler<C> assembler(system);
    assembler.assemble_phi_and_jacobian(state, kTime);
    const MatrixX& ours = assembler.jacobian();
    const VectorX units = units_of<C>(system, ours.cols(), length);
    const VectorX none = VectorX::Zero(ours.cols());
    constexpr bool homogeneous = C::kChoice != CoordinateChoice::true_euler_parameters;
    MatrixX theirs(ours.rows(), ours.cols());
    for (Eigen::Index k = 0; k < ours.cols(); ++k) {
        const VectorX along = units(k) * VectorX::Unit(ours.cols(), k);
        const auto phi = [&](reference::Real t) {
            return reference::phi(
                system, moved<C>(system, state, along, none, t), kTime, homogeneous, C::kNormalised);
        };
        theirs.col(k) = first_difference_of(phi, kStep).template cast<double>();
    }
    for (Eigen::Index row = 0; row < ours.rows(); ++row) {
        const double size = theirs.row(row).cwiseAbs().maxCoeff();
        const double off = (ours.row(row).transpose().cwiseProduct(units) - theirs.row(row).transpose())
                               .cwiseAbs()
                               .maxCoeff();
        // two zeros agree
        if (!(off <= kAllowed * size)) { return off_by("row", row, off / size, kAllowed); }
    }
    return {};
}

}  // namespace

Verdict jacobians_agree(const Generated& generated) {
    const Mechanism& m = generated.mechanism;
    const System system(m, everything(m));
    if (system.rows() == 0) { return not_asked("there is no constraint"); }
    const double L = generated.length;
    Random random(static_cast<unsigned>(generated.recipe.seed));
    const State start = start_state(m);
    // at the start the rows are satisfied; at the disturbed pose nothing vanishes by chance
    for (const State& state : {start, disturbed(m, start, random, 0.3 * L, 0.3)}) {
        for (const std::string& wrong :
             {differs<TrueEulerParameters>(system, state, L),
              differs<ModifiedEulerParameters>(system, state, L), differs<OmegaLocal>(system, state, L),
              differs<OmegaGlobal>(system, state, L)}) {
            if (!wrong.empty()) { return fails(wrong); }
        }
    }
    return holds();
}

Verdict spectra_agree(const Generated& generated) {
    const Mechanism& m = generated.mechanism;
    const System system(m, everything(m));
    if (system.rows() == 0) { return not_asked("there is no constraint"); }
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(start_state(m), 0.0);
    const MatrixX& jacobian = assembler.jacobian();
    const Svd svd = svd_of(jacobian);
    if (!svd.sound) { return fails("the decomposition does not pass its own check"); }
    const VectorX exact = long_double_singular_values(jacobian);
    const double off = (svd.sigma - exact).cwiseAbs().maxCoeff();
    // two bounds: the promised one, and that of Jacobi rotations, a few roundings of the largest
    const double few = 10.0 * std::sqrt(static_cast<double>(jacobian.rows() + jacobian.cols())) *
                       std::numeric_limits<double>::epsilon() * svd.sigma(0);
    if (!(off <= svd.error)) { return fails(off_by("singular value", 0, off, svd.error)); }
    if (!(off <= few)) { return fails(off_by("singular value", 0, off, few)); }
    // a verdict that is reported as decided is that of long double, also near a singular pose
    const RankReport report = analyse_rank(system, jacobian, assembler.phi());
    const int rank = report.rank - m.thetas_count();
    if (report.decided && generated.condition < 1e7 && rank != generated.rank) {
        return fails(
            "the rank is said to be " + std::to_string(rank) + " and decided, reference " +
            std::to_string(generated.rank));
    }
    return holds();
}

}  // namespace jw::test
