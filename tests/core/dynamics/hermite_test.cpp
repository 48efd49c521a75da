#include <catch2/catch.hpp>

#include "core/numerics/hermite.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

/// Coefficients of a polynomial and of its derivatives, by the rule.
using Polynomial = std::vector<double>;

Polynomial random_polynomial(test::Random& random, std::size_t coefficients) {
    Polynomial out(coefficients);
    for (double& c : out) { c = random.number(); }
    return out;
}

Polynomial derivative(const Polynomial& p) {
    Polynomial out;
    for (std::size_t k = 1; k < p.size(); ++k) { out.push_back(static_cast<double>(k) * p[k]); }
    return out;
}

double at_time(const Polynomial& p, double t) {
    double value = 0.0;
    double power = 1.0;
    for (const double c : p) {
        value += c * power;
        power *= t;
    }
    return value;
}

/// Two numbers at once, each a polynomial.
std::vector<HermitePolynomial::Node> nodes_of(
    const std::vector<Polynomial>& numbers, const std::vector<double>& times) {
    std::vector<HermitePolynomial::Node> nodes;
    for (const double t : times) {
        HermitePolynomial::Node node;
        node.t = t;
        node.known.resize(static_cast<Eigen::Index>(numbers.size()), 3);
        for (std::size_t n = 0; n < numbers.size(); ++n) {
            const Polynomial rate = derivative(numbers[n]);
            const auto row = static_cast<Eigen::Index>(n);
            node.known(row, 0) = at_time(numbers[n], t);
            node.known(row, 1) = at_time(rate, t);
            node.known(row, 2) = 0.5 * at_time(derivative(rate), t);
        }
        nodes.push_back(node);
    }
    return nodes;
}

}  // namespace

TEST_CASE("A polynomial through ends of steps is the one that they lie on", "[core][dynamics][hermite]") {
    using Meets = HermitePolynomial::Meets;
    const auto [count, meets] = GENERATE(
        std::pair(2, Meets::values_and_rates), std::pair(2, Meets::second_derivatives_too),
        std::pair(3, Meets::second_derivatives_too), std::pair(4, Meets::second_derivatives_too));
    const auto seed = GENERATE(1U, 2U, 3U);
    CAPTURE(count, static_cast<int>(meets), seed);
    test::Random random(seed);
    // as many coefficients as there are known values
    const auto known = static_cast<std::size_t>(count) * static_cast<std::size_t>(meets);
    const std::vector<Polynomial> numbers{random_polynomial(random, known), random_polynomial(random, known)};
    const std::vector<double> times{-0.4, 0.1, 0.7, 1.0};
    HermitePolynomial polynomial;
    // an earlier fit has no effect
    polynomial.fit(nodes_of({random_polynomial(random, 12), {1.0}}, times), Meets::second_derivatives_too);
    polynomial.fit(nodes_of(numbers, {times.begin(), times.begin() + count}), meets);
    for (const double t : {-0.4, -0.3, 0.05, 0.5, 1.0}) {
        CAPTURE(t);
        polynomial.evaluate(t);
        for (Eigen::Index n = 0; n < 2; ++n) {
            const Polynomial& number = numbers[static_cast<std::size_t>(n)];
            // differences of up to third powers of 1 / 0.3 s in double
            CHECK(polynomial.value()(n) == Approx(at_time(number, t)).margin(1e-8));
            CHECK(polynomial.rate()(n) == Approx(at_time(derivative(number), t)).margin(1e-7));
        }
    }
}
