#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "core/jets/power_series.hpp"
#include "tests/support/proved_primitives.hpp"

/// Power series of the primitives against their values at other points of the path.
using namespace jw;
using namespace jw::test;

namespace {

using Exact = ModifiedEulerParameters;
constexpr int kPaths = 20;

/// r and p are quadratic in s, θ is linear.
struct RandomPath {
    BodyKinematics<PowerSeries> series;

    explicit RandomPath(Random& random) {
        for (int k = 0; k < 3; ++k) {
            series.r.col(k) = random.vector(1.0);
            series.p.col(k) = random.unit_p();
        }
    }
    BodyKinematics<Exact> at(double s) const {
        const Vec3 r = series.r.col(0) + s * (series.r.col(1) + s * series.r.col(2));
        const Vec4 p = series.p.col(0) + s * (series.p.col(1) + s * series.p.col(2));
        return kinematics_at<Exact>(r, p);
    }
};

/// Largest difference between the series of a primitive and its value at s, and the largest excess of a
/// coefficient over the sum of the sizes of its terms.
struct Comparison {
    double difference = 0.0;
    double size = 0.0;
    double excess = 0.0;
    double last = 0.0;  ///< size of the last term
};
Comparison compared(
    const ProvedPrimitive& primitive, const RandomPath& i, const RandomPath& j, double theta_0, double rate,
    double s) {
    Comparison out;
    SeriesOfTheta theta;
    theta.value(0) = theta_0;
    theta.value(1) = rate;
    std::visit(
        [&](const auto& c) {
            const auto jet = equations<Content::motion>(c, i.series, j.series, theta);
            auto sum = jet.value;
            double power = 1.0;
            for (int k = 1; k < kOrders; ++k) {
                power *= s;
                sum += power * jet.coefficient(k);
                out.size += power * jet.size(k);
                out.excess = std::max(out.excess, jet.coefficient(k).norm() / (jet.size(k) + 1e-12) - 1.0);
            }
            out.last = power * jet.size(kOrders - 1);
            const auto value =
                equations<Content::jacobian>(c, i.at(s), j.at(s), Theta{theta_0 + s * rate, 0.0}).value;
            out.difference = (value - sum).norm();
        },
        primitive);
    return out;
}

}  // namespace

TEST_CASE("Power series of the primitives have their values along a path", "[core][power-series]") {
    Random random(29);
    const auto unit = [&] { return random.direction(); };
    for (int n = 0; n < kPaths; ++n) {
        // polynomials of degree 8 in s at most: the series is not truncated
        const std::vector<ProvedPrimitive> primitives = polynomial_primitives(random);
        const RandomPath i(random);
        const RandomPath j(random);
        for (const ProvedPrimitive& primitive : primitives) {
            CAPTURE(n, primitive.index());
            const Comparison c = compared(primitive, i, j, random.number(), random.number(), 0.9);
            CHECK(c.difference <= 1e-13 * (c.size + 10.0));
            CHECK(c.excess <= 1e-12);
        }
        // the truncated terms are of order 9: an order less would leave 1e-7 of the terms
        for (const ScrewAngleForm form :
             {ScrewAngleForm::rotation, ScrewAngleForm::cosine, ScrewAngleForm::sine}) {
            const Comparison c =
                compared(ScrewAngle{unit(), unit(), unit(), form}, i, j, random.number(), 1.0, 0.01);
            CHECK(c.difference <= 1e-14 * (c.size + 10.0));
            CHECK(c.excess <= 1e-12);
        }
    }
}

TEST_CASE(
    "Power series of formulas have their values up to the order that is cut off", "[core][power-series]") {
    Random random(37);
    for (int n = 0; n < kPaths; ++n) {
        const std::vector<ProvedPrimitive> formulas = other_formulas(random);
        const RandomPath i(random);
        const RandomPath j(random);
        for (std::size_t k = 0; k < formulas.size(); ++k) {
            CAPTURE(n, k);
            // at a tenth of the distance that the series reaches: the truncation error is below the last term
            const Comparison c = compared(formulas[k], i, j, 0.0, 0.0, 0.01);
            CHECK(c.difference <= c.last + 1e-14 * (c.size + 10.0));
            CHECK(c.excess <= 1e-12);
        }
    }
}

TEST_CASE("Sine and cosine of a series keep their sum of squares to every order", "[core][power-series]") {
    Random random(31);
    using Scalar = Jet<PowerSeries, Content::motion, 1, kTheta>;
    Scalar x;
    x.value(0) = 0.7;
    for (int k = 1; k < kOrders; ++k) { x.w(k) = random.number(); }
    const Scalar one = dot(sin(x), sin(x)) - scaled(-1.0, dot(cos(x), cos(x)));
    CHECK(one.value(0) == Approx(1.0));
    for (int k = 1; k < kOrders; ++k) { CHECK(std::abs(one.w(k)) < 1e-13); }
    // sin x = x - x³/6 + ... of x = s
    Scalar s;
    s.w(1) = 1.0;
    const double factorials[] = {0.0, 1.0, 0.0, -6.0, 0.0, 120.0, 0.0, -5040.0, 0.0};
    for (int k = 1; k < kOrders; ++k) {
        const double f = factorials[static_cast<std::size_t>(k)];
        CHECK(sin(s).w(k) == Approx(f == 0.0 ? 0.0 : 1.0 / f).margin(1e-16));
    }
}
