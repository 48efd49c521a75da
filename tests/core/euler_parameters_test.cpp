#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "core/jets/euler_parameters.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

// a dozen products of numbers below 10, each rounded to 1e-16
constexpr double kRounding = 2e-14;

}  // namespace

TEST_CASE("A, G and L obey the identities of the book", "[core][euler_parameters]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        const Vec4 p = random.unit_p();
        const Vec3 s = random.vector(3.0);
        CHECK((rotation_matrix(p) - homogeneous_rotation_matrix(p)).norm() < kRounding);
        CHECK((rotation_matrix(p) * rotation_matrix(p).transpose() - Mat3::Identity()).norm() < kRounding);
        CHECK((G_of(p) * p).norm() < kRounding);
        CHECK((L_of(p) * p).norm() < kRounding);
        CHECK((L_of(p).transpose() * s - bar(s) * p).norm() < kRounding);
        CHECK(
            (rotation_matrix(p) * tilde(s) - tilde(rotation_matrix(p) * s) * rotation_matrix(p)).norm() <
            kRounding);
        // off the sphere: A_N = A_H + (pᵀp - 1) I
        const Vec4 q = 1.3 * p;
        const Mat3 difference = rotation_matrix(q) - homogeneous_rotation_matrix(q);
        CHECK((difference - (q.squaredNorm() - 1.0) * Mat3::Identity()).norm() < kRounding);
    }
}

TEST_CASE("Every conversion of slide 13 is undone by its partner", "[core][euler_parameters]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        const Vec4 p = random.unit_p();
        const Mat3 A = rotation_matrix(p);
        const Vec3 w = random.vector(3.0);
        const Vec3 w_dot = random.vector(3.0);
        CHECK((omega_local_of(p, p_dot_of_omega_local(p, w)) - w).norm() < kRounding);
        CHECK((omega_global_of(p, p_dot_of_omega_global(p, w)) - w).norm() < kRounding);
        CHECK((omega_local_dot_of(p, p_ddot_of_omega_local(p, w, w_dot)) - w_dot).norm() < kRounding);
        CHECK((omega_global_dot_of(p, p_ddot_of_omega_global(p, w, w_dot)) - w_dot).norm() < kRounding);
        // ω = A ω', and both give the same ṗ and p̈ (ω̇ = A ω̇')
        CHECK((p_dot_of_omega_local(p, w) - p_dot_of_omega_global(p, A * w)).norm() < kRounding);
        CHECK(
            (p_ddot_of_omega_local(p, w, w_dot) - p_ddot_of_omega_global(p, A * w, A * w_dot)).norm() <
            kRounding);
    }
}

TEST_CASE(
    "p comes back from its matrix for every rotation, half turns included", "[core][euler_parameters]") {
    const double angle = GENERATE(
        0.0, 1e-9, 1e-4, 1.0, 2.0, std::numbers::pi - 1e-9, std::numbers::pi, std::numbers::pi + 1e-9, 5.0);
    for (unsigned seed = 1; seed <= 10; ++seed) {
        test::Random random(seed);
        Vec3 axis = random.direction();
        if (seed <= 3) { axis = Vec3::Unit(seed - 1); }
        const Vec4 p = euler_parameters_of(axis, angle);
        const Vec4 back = euler_parameters_of(rotation_matrix(p));
        CAPTURE(seed, angle);
        CHECK(std::min((back - p).norm(), (back + p).norm()) < kRounding);
        CHECK(back(0) >= 0.0);
    }
}

TEST_CASE("Turning by a rotation vector and measuring it agree", "[core][euler_parameters]") {
    const double angle = GENERATE(0.0, 1e-12, 1e-5, 1.9e-4, 2.1e-4, 0.3, 3.0);
    test::Random random(11);
    const Vec4 p = random.unit_p();
    const Vec3 turn = angle * random.direction();
    CHECK((turn_local_between(p, turned_local(p, turn)) - turn).norm() < kRounding);
    CHECK((turn_local_between(p, -turned_local(p, turn)) - turn).norm() < kRounding);
    CHECK((turned_global(p, rotation_matrix(p) * turn) - turned_local(p, turn)).norm() < kRounding);
}

TEST_CASE(
    "The shortest turn between two directions is one, up to opposite ones", "[core][euler_parameters]") {
    for (unsigned seed = 1; seed <= 3000; ++seed) {
        test::Random random(seed);
        const Vec3 from = random.vector(3.0);
        // random directions, and directions that are opposite exactly or up to 1, 0.1, ... 1e-8 rad
        const double apart = seed % 10 == 9 ? 0.0 : std::pow(0.1, seed % 10);
        const Vec3 aside = perpendicular_to(from);
        const Vec3 opposite = -from + apart * from.norm() * aside.normalized();
        const Vec3 to = seed % 2 == 0 ? random.vector(2.0) : opposite;
        CAPTURE(seed, from.transpose(), to.transpose());
        const Vec4 p = euler_parameters_between(from, to);
        // below 1e-6 rad the axis is that of an exact half turn: 1 + cosine < 1e-12; above, it is known to
        // 1e-16 / 1e-6
        const double tolerance = seed % 2 == 1 && apart < 1e-5 ? 2e-6 : 2e-10;
        CHECK(std::abs(p.norm() - 1.0) < tolerance);
        CHECK((rotation_matrix(p) * from.normalized() - to.normalized()).norm() < tolerance);
        // no turn about another axis is shorter
        CHECK(std::abs(p.tail<3>().dot(from.normalized())) < tolerance);
        CHECK(std::abs(p.tail<3>().dot(to.normalized())) < tolerance);
        CHECK(p(0) >= 0.0);
    }
}
