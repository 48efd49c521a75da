#include <Eigen/SVD>

#include <catch2/catch.hpp>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "core/equations/assembler.hpp"
#include "core/numerics/svd.hpp"
#include "core/poses/least_squares.hpp"
#include "tests/app/session/catalogue_lessons.hpp"
#include "tests/support/long_double_svd.hpp"

namespace jw::test {
namespace {

constexpr std::array kChoices{
    CoordinateChoice::true_euler_parameters, CoordinateChoice::modified_euler_parameters,
    CoordinateChoice::omega_local, CoordinateChoice::omega_global};

MatrixX jacobian_at(const Step& step, CoordinateChoice choice) {
    MatrixX jacobian;
    with_choice(choice, [&](auto c) {
        Assembler<decltype(c)> assembler(*step.system);
        assembler.assemble_phi_and_jacobian(step.state, step.t);
        jacobian = assembler.jacobian();
    });
    return jacobian;
}

/// Jacobian in the scene's units, in which the rank is judged.
MatrixX scaled_jacobian_at(const Step& step) {
    const Scaling scaling = scaling_of<OmegaLocal>(*step.system);
    return scaling.row.cwiseInverse().asDiagonal() * jacobian_at(step, CoordinateChoice::omega_local) *
           scaling.column.asDiagonal();
}

double off_by(const VectorX& sigma, const VectorX& exact) { return (sigma - exact).cwiseAbs().maxCoeff(); }

/// Singular values by Eigen's divide and conquer: right for most matrices, wrong for some of these.
Svd by_eigen(const MatrixX& matrix) {
    const Eigen::BDCSVD<MatrixX> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeFullV);
    Svd out;
    out.sigma = svd.singularValues();
    out.U = svd.matrixU();
    out.V = svd.matrixV();
    check_svd(matrix, out);
    return out;
}

/// True for the steps that are checked: of a motion every tenth moment and all change points, since long
/// double takes its time.
bool is_looked_at(const Step& step, std::size_t index) {
    return step.kind != Step::Kind::motion || step.change_point || index % 10 == 0;
}

}  // namespace

TEST_CASE("The spectra of the steps of every lesson equal those of a long double Jacobi", "[app][svd]") {
    int spectra = 0;
    int wrong_by_eigen = 0;
    for (const auto& file : all_lesson_files()) {
        const Lesson lesson = shipped(file);
        const Story story(lesson);
        for (std::size_t k = 0; k < story.steps().size(); ++k) {
            const Step& step = story.steps()[k];
            if (!is_looked_at(step, k)) { continue; }
            for (const CoordinateChoice choice : kChoices) {
                const MatrixX jacobian = jacobian_at(step, choice);
                if (jacobian.size() == 0) { continue; }
                CAPTURE(file.string(), k, name_of_choice(choice));
                const Svd svd = svd_of(jacobian);
                const VectorX exact = long_double_singular_values(jacobian);
                CHECK(svd.sound);
                CHECK(off_by(svd.sigma, exact) <= svd.error);
                // a few roundings of the largest value
                CHECK(off_by(svd.sigma, exact) <= 1e-14 * std::sqrt(double(jacobian.cols())) * exact(0));

                // the check finds a wrong decomposition, whichever method made it
                const Svd other = by_eigen(jacobian);
                const bool wrong = off_by(other.sigma, exact) > 1e-11 * exact(0);
                CHECK(off_by(other.sigma, exact) <= other.error);
                if (wrong) { CHECK_FALSE(other.sound); }
                wrong_by_eigen += wrong ? 1 : 0;
                ++spectra;
            }
        }
    }
    CAPTURE(wrong_by_eigen);
    CHECK(spectra > 1000);
}

TEST_CASE("The rank at the steps of every lesson is that of a long double Jacobi, and told", "[app][svd]") {
    for (const auto& file : all_lesson_files()) {
        const Lesson lesson = shipped(file);
        const Story story(lesson);
        for (std::size_t k = 0; k < story.steps().size(); ++k) {
            const Step& step = story.steps()[k];
            if (!is_looked_at(step, k)) { continue; }
            const MatrixX scaled = scaled_jacobian_at(step);
            if (scaled.size() == 0) { continue; }
            CAPTURE(file.string(), k, step.t);
            const RankReport report = rank_of(*step.system, step.state, step.t);
            const VectorX exact = long_double_singular_values(scaled);
            CHECK(off_by(report.singular_values, exact) <= report.singular_value_error);
            CHECK(
                std::ranges::count_if(exact, [&](double s) { return s > report.threshold; }) == report.rank);
            // the rank can be undecided only at a change point, where the error of the pose is the root of
            // its residual; an answer repeats the pose of the step before it, which may be a change point
            const bool repeats_change_point = is_asked(step.kind) && story.steps()[k - 1].change_point;
            CHECK((report.decided || step.change_point || repeats_change_point));
            CHECK((doubts_of(*step.system, report).empty() || !report.decided));
        }
    }
}

}  // namespace jw::test
