#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include <Eigen/SVD>

#include "core/jets/majorants.hpp"
#include "tests/support/proved_primitives.hpp"

/// Bounds of the primitives against their exact jets, at random poses of a region and along random paths.
using namespace jw;
using namespace jw::test;

namespace {

using Exact = ModifiedEulerParameters;
using Region = BodyKinematics<Majorants>;

constexpr int kRegions = 40;
constexpr int kPoses = 30;

Region random_region(Random& random) {
    Region region;
    region.r = random.vector(2.0);
    region.p = random.unit_p();
    region.A = homogeneous_rotation_matrix(region.p);
    region.reach_r = random.number(0.01, 0.5);
    region.reach_p = random.number(0.01, 0.4);
    region.size_of_p = 1.0 + region.reach_p;
    return region;
}

struct Pose {
    Vec3 r;
    Vec4 p;
};
Pose pose_in(Random& random, const Region& region) {
    const Vec4 way(random.number(), random.number(), random.number(), random.number());
    return {
        region.r + region.reach_r * random.number() * random.direction(),
        region.p + region.reach_p * random.number() * way.normalized()};
}

/// Blocks of the Jacobian at a pose, largest singular value of each difference.
using Blocks = std::array<MatrixX, kBlocks>;
Blocks blocks_at(const ProvedPrimitive& primitive, const Pose& i, const Pose& j, double theta) {
    Blocks blocks;
    std::visit(
        [&](const auto& c) {
            const auto jet = equations<Content::jacobian>(
                c, kinematics_at<Exact>(i.r, i.p), kinematics_at<Exact>(j.r, j.p), Theta{theta, 0.0});
            using J = std::decay_t<decltype(jet)>;
            for (MatrixX& block : blocks) { block = MatrixX::Zero(J::kDim, 1); }
            if constexpr ((J::kSides & kBodyI) != 0) {
                blocks[kR_i] = jet.block_i.template leftCols<3>();
                blocks[kP_i] = jet.block_i.template rightCols<4>();
            }
            if constexpr ((J::kSides & kBodyJ) != 0) {
                blocks[kR_j] = jet.block_j.template leftCols<3>();
                blocks[kP_j] = jet.block_j.template rightCols<4>();
            }
            if constexpr ((J::kSides & kTheta) != 0) { blocks[kArtificial] = jet.block_theta; }
        },
        primitive);
    return blocks;
}

double largest_singular_value(const MatrixX& m) { return Eigen::JacobiSVD<MatrixX>(m).singularValues()(0); }

VectorX value_at(const ProvedPrimitive& primitive, const Pose& i, const Pose& j, double theta) {
    VectorX value;
    std::visit(
        [&](const auto& c) {
            value = equations<Content::jacobian>(
                        c, kinematics_at<Exact>(i.r, i.p), kinematics_at<Exact>(j.r, j.p), Theta{theta, 0.0})
                        .value;
        },
        primitive);
    return value;
}

/// Cubic path of a number of coordinates: value and derivatives from its coefficients.
template <int N>
struct Cubic {
    Eigen::Matrix<double, N, 4> c;
    Eigen::Matrix<double, N, 1> at(double t) const {
        return c.col(0) + t * (c.col(1) + t * (c.col(2) + t * c.col(3)));
    }
    /// Bounds of |x^(k)| / k! for t in [0, 1].
    TaylorSeries series() const {
        return {
            0.0, c.col(1).norm() + 2.0 * c.col(2).norm() + 3.0 * c.col(3).norm(),
            c.col(2).norm() + 3.0 * c.col(3).norm(), c.col(3).norm(), 0.0};
    }
};

}  // namespace

TEST_CASE("Bounds of derivatives of every primitive hold in all of a region", "[core][majorants]") {
    Random random(71);
    for (int n = 0; n < kRegions; ++n) {
        const Region i = random_region(random);
        const Region j = random_region(random);
        const BoundedTheta theta{random.number(-2.0, 2.0), random.number(0.1, 1.0), {}};
        for (const ProvedPrimitive& primitive : all_primitives(random)) {
            DerivativeBounds bounds;
            VectorX middle;
            double away = 0.0;
            double size = 0.0;
            std::visit(
                [&](const auto& c) {
                    const auto jet = equations<Content::jacobian>(c, i, j, theta);
                    bounds = jet.bounds;
                    middle = jet.value;
                    away = jet.away;
                    size = jet.size;
                },
                primitive);
            CHECK(
                (value_at(primitive, {i.r, i.p}, {j.r, j.p}, theta.value) - middle).norm() <=
                1e-13 * (1.0 + size));
            CAPTURE(n, primitive.index());
            for (int k = 0; k < kPoses; ++k) {
                const Pose a_i = pose_in(random, i);
                const Pose a_j = pose_in(random, j);
                const double a_theta = theta.value + theta.reach * random.number();
                const Blocks a = blocks_at(primitive, a_i, a_j, a_theta);
                const VectorX value = value_at(primitive, a_i, a_j, a_theta);
                CHECK((value - middle).norm() <= away * (1.0 + 1e-12));
                CHECK(value.norm() <= size * (1.0 + 1e-12));
                // one block of coordinates changes at a time, by a little: the change of every block of the
                // Jacobian is bounded
                const double step = 1e-6;
                for (std::size_t d = 0; d < kBlocks; ++d) {
                    Pose b_i = a_i;
                    Pose b_j = a_j;
                    double b_theta = a_theta;
                    const Vec3 way_r = step * random.direction();
                    const Vec4 way_p = step * random.unit_p();
                    if (d == kR_i) { b_i.r += way_r; }
                    if (d == kP_i) { b_i.p += way_p; }
                    if (d == kR_j) { b_j.r += way_r; }
                    if (d == kP_j) { b_j.p += way_p; }
                    if (d == kArtificial) { b_theta += step; }
                    const Blocks b = blocks_at(primitive, b_i, b_j, b_theta);
                    for (std::size_t c = 0; c < kBlocks; ++c) {
                        CAPTURE(c, d);
                        CHECK(largest_singular_value(a[c]) <= bounds.first[c] * (1.0 + 1e-12));
                        // differences are exact to their curvature and rounding
                        CHECK(largest_singular_value(b[c] - a[c]) <= bounds.second[c][d] * step + 1e-10);
                    }
                }
            }
        }
    }
}

TEST_CASE("Bounds of a point and an arm and of products are reached", "[core][majorants]") {
    Region away;
    away.r = Vec3(3.0, 0.0, 0.0);
    away.reach_r = 0.5;
    const auto point = equations<Content::jacobian>(S{Vec3::Zero(), Vec3::Zero()}, away, Region{}, {});
    CHECK(point.away == Approx(0.5));
    Region turned;
    turned.reach_p = 0.1;
    turned.size_of_p = 1.5;
    // an arm of 2 m: two parameters, one of which is off by 0.1
    const auto arm_end =
        equations<Content::jacobian>(S{Vec3(2.0, 0.0, 0.0), Vec3::Zero()}, turned, Region{}, {});
    CHECK(arm_end.away == Approx(2.0 * 2.0 * 1.5 * 0.1));
    CHECK(point.size == Approx(3.5));
    const ScrewAdvance screw{Vec3::UnitX(), Vec3::Zero(), Vec3::Zero(), -0.3, 0.0, 0.0};
    CHECK(equations<Content::jacobian>(screw, Region{}, Region{}, {0.5, 1.0, {}}).away == Approx(0.3));
    Region i;
    i.reach_p = 0.1;
    i.size_of_p = 1.1;
    const auto bounds =
        equations<Content::jacobian>(S{Vec3(0.0, 0.0, 2.0), Vec3::Zero()}, i, Region{}, {}).bounds;
    // |A s'| = |p|² |s'|
    CHECK(bounds.first[kR_i] == 1.0);
    CHECK(bounds.first[kP_i] == Approx(2.0 * 2.0 * 1.1));
    CHECK(bounds.second[kP_i][kP_i] == Approx(2.0 * 2.0));
    CHECK(bounds.second[kR_i][kP_i] == 0.0);
    const auto product =
        equations<Content::jacobian>(N1{Vec3(2.0, 0.0, 0.0), Vec3(0.0, 3.0, 0.0)}, i, Region{}, {}).bounds;
    CHECK(product.first[kP_j] == Approx(1.1 * 1.1 * 2.0 * 2.0 * 3.0));
    CHECK(product.second[kP_i][kP_j] == Approx(2.0 * 2.0 * 1.1 * 2.0 * 3.0));
}

TEST_CASE(
    "Formulas of bodies near by have bounds, and where they have none no number is one",
    "[core][majorants]") {
    Random random(73);
    int bounded = 0;
    int unbounded = 0;
    for (int n = 0; n < kRegions; ++n) {
        const Region i = random_region(random);
        const Region j = random_region(random);
        std::vector<ProvedPrimitive> formulas = other_formulas(random);
        // a factor without bounds beside one that does not change
        for (const double factor : {1.0, 0.0}) {
            FormulaEquation other = std::get<FormulaEquation>(formulas.back());
            other.formula.steps.push_back({FormulaStep::Kind::number, factor});
            other.formula.steps.push_back({FormulaStep::Kind::product, 0.0});
            formulas.emplace_back(other);
        }
        for (std::size_t k = 0; k < formulas.size(); ++k) {
            CAPTURE(n, k);
            const auto& formula = std::get<FormulaEquation>(formulas[k]);
            const auto jet = equations<Content::jacobian>(formula, i, j, BoundedTheta{});
            const auto path = equations<Content::motion>(formula, i, j, BoundedTheta{});
            const bool has_bounds = std::isfinite(jet.away);
            (has_bounds ? bounded : unbounded) += 1;
            CHECK(std::isfinite(path.away) == has_bounds);
            for (std::size_t order = 1; order < path.bounds.size(); ++order) {
                CHECK(std::isfinite(path.bounds[order]) == has_bounds);
            }
            for (std::size_t c = 0; c < kBlocks; ++c) {
                CHECK(std::isfinite(jet.bounds.first[c]) == has_bounds);
                for (std::size_t d = 0; d < kBlocks; ++d) {
                    CHECK(std::isfinite(jet.bounds.second[c][d]) == has_bounds);
                }
            }
        }
    }
    // both do occur
    CHECK(bounded > 4 * kRegions);
    CHECK(unbounded > kRegions);
}

TEST_CASE("Bounds along a path hold for every primitive", "[core][majorants]") {
    Random random(72);
    for (int n = 0; n < kRegions; ++n) {
        Region i = random_region(random);
        Region j = random_region(random);
        BoundedTheta theta{random.number(-2.0, 2.0), random.number(0.1, 1.0), {}};
        // cubic paths that stay in the regions
        const auto cubic = [&]<int N>(const Eigen::Matrix<double, N, 1>& from, double reach) {
            Cubic<N> path;
            path.c.col(0) = from;
            for (int k = 1; k < 4; ++k) {
                for (int row = 0; row < N; ++row) { path.c(row, k) = random.number(); }
                path.c.col(k) *= reach / 3.0 / path.c.col(k).norm();
            }
            return path;
        };
        const auto r_i = cubic(i.r, i.reach_r);
        const auto r_j = cubic(j.r, j.reach_r);
        const auto p_i = cubic(i.p, i.reach_p);
        const auto p_j = cubic(j.p, j.reach_p);
        const auto angle = cubic(Eigen::Matrix<double, 1, 1>(theta.value), theta.reach);
        i.r_series = r_i.series();
        i.p_series = p_i.series();
        j.r_series = r_j.series();
        j.p_series = p_j.series();
        theta.series = angle.series();
        for (const ProvedPrimitive& primitive : all_primitives(random)) {
            CAPTURE(n, primitive.index());
            TaylorSeries bounds{};
            std::visit(
                [&](const auto& c) { bounds = equations<Content::motion>(c, i, j, theta).bounds; },
                primitive);
            const auto value = [&](double t) {
                return value_at(primitive, {r_i.at(t), p_i.at(t)}, {r_j.at(t), p_j.at(t)}, angle.at(t)(0));
            };
            // central differences of first to fourth order
            const double h = 0.02;
            for (int k = 0; k < 10; ++k) {
                const double t = random.number(0.1, 0.9);
                const VectorX before2 = value(t - 2.0 * h), before = value(t - h), now = value(t),
                              after = value(t + h), after2 = value(t + 2.0 * h);
                const std::array<VectorX, 5> derivative{
                    now, (after - before) / (2.0 * h), (after - 2.0 * now + before) / (h * h) / 2.0,
                    (after2 - 2.0 * after + 2.0 * before - before2) / (2.0 * h * h * h) / 6.0,
                    (after2 - 4.0 * after + 6.0 * now - 4.0 * before + before2) / (h * h * h * h) / 24.0};
                for (std::size_t order = 1; order < derivative.size(); ++order) {
                    CAPTURE(order, t);
                    // differences are mean values over the interval around t: bounded as well, up to rounding
                    CHECK(derivative[order].norm() <= bounds[order] + 1e-7);
                }
            }
        }
    }
}
