#include <catch2/catch.hpp>

#include "core/equations/assembler.hpp"
#include "tests/support/random_mechanisms.hpp"

/// The tables of slides 20-22 in the right forms of docs/notation.md, typed out by hand and evaluated with
/// nothing of the program but A, G, L, tilde and bar.
using namespace jw;

namespace {

// some thirty products of numbers up to 10 and their sums
constexpr double kTableTolerance = 1e-12;

struct Rows {
    MatrixX r_i, angular_i, r_j, angular_j;
    VectorX gamma;
};

/// One body with everything that the tables name.
struct Side {
    Mat3 A;
    Mat34 G, G_dot, L_dot;
    Vec4 p, p_dot;
    Vec3 r_dot, w;          // w: global ω
    Vec3 s_local, B_local;  // B is the P of s
    Vec3 s, B, s_dot, B_dot;
    Mat3 s_, B_, w_, s_dot_;  // tilde

    Side(const Body& body, const Vec3& axis_local, const Vec3& point_local)
        : A(rotation_matrix(body.p)),
          G(G_of(body.p)),
          p(body.p),
          p_dot(0.5 * L_of(body.p).transpose() * body.omega_local),
          r_dot(body.r_dot),
          w(A * body.omega_local),
          s_local(axis_local),
          B_local(point_local),
          s(A * s_local),
          B(A * B_local),
          s_dot(w.cross(s)),
          B_dot(w.cross(B)),
          s_(tilde(s)),
          B_(tilde(B)),
          w_(tilde(w)),
          s_dot_(tilde(s_dot)) {
        G_dot = G_of(p_dot);
        L_dot = L_of(p_dot);
    }
    Vec3 h(const Vec3& v_local) const { return -2.0 * G_dot * L_dot.transpose() * v_local; }
    Vec3 h_true(const Vec3& v_local) const { return h(v_local) - 2.0 * p_dot.squaredNorm() * v_local; }
    Mat34 C_modified(const Vec3& v_local) const { return 2.0 * G * bar(v_local); }
    Mat34 C_true(const Vec3& v_local) const { return 2.0 * (G * bar(v_local) + v_local * p.transpose()); }
};

struct Pair {
    Side i, j;
    Vec3 d, d_dot;
    Mat3 d_;
};

Pair pair_of(const Mechanism& m) {
    const JointGeometry& g = m.joints[0].geometry;
    const Side i(m.bodies[0], g.s_i_local, g.P_i_local);
    const Side j(m.bodies[1], g.s_j_local, g.P_j_local);
    const Vec3 d = m.bodies[1].r + j.B - m.bodies[0].r - i.B;
    return {i, j, d, j.r_dot + j.B_dot - i.r_dot - i.B_dot, tilde(d)};
}

/// Table of p. 299; `local`: for ω′, else for ω (every A left out).
Rows table_299(std::string_view name, const Pair& k, bool local) {
    const Side& i = k.i;
    const Side& j = k.j;
    const Mat3 A_i = local ? i.A : Mat3(Mat3::Identity());
    const Mat3 A_j = local ? j.A : Mat3(Mat3::Identity());
    const Mat3 I = Mat3::Identity();
    const auto s_iT = i.s.transpose();
    const auto s_jT = j.s.transpose();
    const MatrixX zero1 = MatrixX::Zero(1, 3);
    const MatrixX zero3 = MatrixX::Zero(3, 3);
    const auto scalar = [](double g) { return VectorX::Constant(1, g); };
    if (name == "n1") {
        return {
            zero1, -s_jT * i.s_ * A_i, zero1, -s_iT * j.s_ * A_j,
            scalar(-2.0 * i.s_dot.dot(j.s_dot) + i.s_dot.dot(i.w_ * j.s) + j.s_dot.dot(j.w_ * i.s))};
    }
    if (name == "n2") {
        return {
            -s_iT, -(k.d + i.B).transpose() * i.s_ * A_i, s_iT, -s_iT * j.B_ * A_j,
            scalar(
                -2.0 * k.d_dot.dot(i.s_dot) - k.d.dot(i.w_ * i.s_dot) +
                i.s.dot(i.w_ * i.B_dot - j.w_ * j.B_dot))};
    }
    if (name == "p1") {
        return {
            zero3, j.s_ * i.s_ * A_i, zero3, -i.s_ * j.s_ * A_j,
            -2.0 * i.s_dot_ * j.s_dot + j.s_ * i.w_ * i.s_dot - i.s_ * j.w_ * j.s_dot};
    }
    if (name == "p2") {
        return {
            -i.s_, (i.s_ * i.B_ + k.d_ * i.s_) * A_i, i.s_, -i.s_ * j.B_ * A_j,
            -2.0 * i.s_dot_ * k.d_dot + i.s_ * (i.w_ * i.B_dot - j.w_ * j.B_dot) + k.d_ * i.w_ * i.s_dot};
    }
    return {I, -i.B_ * A_i, -I, j.B_ * A_j, -i.w_ * i.B_dot + j.w_ * j.B_dot};
}

/// Tables of p. 201 (true) and p. 203 (modified): the same pattern with C, B and h of the choice.
Rows table_201_203(std::string_view name, const Pair& k, bool modified) {
    const Side& i = k.i;
    const Side& j = k.j;
    const auto C = [&](const Side& side, const Vec3& v) {
        return modified ? side.C_modified(v) : side.C_true(v);
    };
    const auto h = [&](const Side& side, const Vec3& v) { return modified ? side.h(v) : side.h_true(v); };
    const Mat34 C_i = C(i, i.s_local);
    const Mat34 C_j = C(j, j.s_local);
    const Mat34 B_i = C(i, i.B_local);
    const Mat34 B_j = C(j, j.B_local);
    const Vec3 h_i = h(i, i.s_local);
    const Vec3 h_j = h(j, j.s_local);
    const Vec3 h_iB = h(i, i.B_local);
    const Vec3 h_jB = h(j, j.B_local);
    const Mat3 I = Mat3::Identity();
    const auto s_iT = i.s.transpose();
    const auto s_jT = j.s.transpose();
    const MatrixX zero1 = MatrixX::Zero(1, 3);
    const MatrixX zero3 = MatrixX::Zero(3, 3);
    const auto scalar = [](double g) { return VectorX::Constant(1, g); };
    if (name == "n1") {
        return {
            zero1, s_jT * C_i, zero1, s_iT * C_j,
            scalar(i.s.dot(h_j) + j.s.dot(h_i) - 2.0 * i.s_dot.dot(j.s_dot))};
    }
    if (name == "n2") {
        return {
            -s_iT, -s_iT * B_i + k.d.transpose() * C_i, s_iT, s_iT * B_j,
            scalar(-i.s.dot(h_iB - h_jB) + k.d.dot(h_i) - 2.0 * i.s_dot.dot(k.d_dot))};
    }
    if (name == "p1") {
        return {zero3, -j.s_ * C_i, zero3, i.s_ * C_j, i.s_ * h_j - j.s_ * h_i - 2.0 * i.s_dot_ * j.s_dot};
    }
    if (name == "p2") {
        return {
            -i.s_, -i.s_ * B_i - k.d_ * C_i, i.s_, i.s_ * B_j,
            -i.s_ * (h_iB - h_jB) - k.d_ * h_i - 2.0 * i.s_dot_ * k.d_dot};
    }
    return {I, B_i, -I, -B_j, h_iB - h_jB};
}

template <class C>
Rows table_of(std::string_view name, const Pair& k) {
    if constexpr (C::kNormalised) {
        return table_201_203(name, k, C::kChoice == CoordinateChoice::modified_euler_parameters);
    } else {
        return table_299(name, k, C::kChoice == CoordinateChoice::omega_local);
    }
}

}  // namespace

TEMPLATE_TEST_CASE(
    "Jacobian and gamma of n1, n2, p1, p2 and s are those of the tables on pages 201, 203 and 299",
    "[core][tables]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (const std::string_view name : {"n1", "n2", "p1", "p2", "s"}) {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            test::Random random(seed);
            const Mechanism m = test::random_joint(
                random, *find_joint_type(name), ParallelForm::all_three, ScrewAngleForm::rotation);
            CAPTURE(name, seed);
            const Rows table = table_of<TestType>(name, pair_of(m));

            const System system(m, everything(m));
            Assembler<TestType> assembler(system);
            assembler.assemble_phi_and_jacobian(start_state(m), 0.0);
            assembler.assemble_gamma(start_state(m), start_motion(m), 0.0);
            const Eigen::Index rows = system.rows();
            constexpr Eigen::Index angular = TestType::kAngular;
            const MatrixX& J = assembler.jacobian();
            REQUIRE(table.gamma.size() == rows);
            CHECK((J.block(0, 0, rows, 3) - table.r_i).cwiseAbs().maxCoeff() < kTableTolerance);
            CHECK((J.block(0, 3, rows, angular) - table.angular_i).cwiseAbs().maxCoeff() < kTableTolerance);
            CHECK((J.block(0, 3 + angular, rows, 3) - table.r_j).cwiseAbs().maxCoeff() < kTableTolerance);
            CHECK(
                (J.block(0, 6 + angular, rows, angular) - table.angular_j).cwiseAbs().maxCoeff() <
                kTableTolerance);
            CHECK((assembler.gamma().head(rows) - table.gamma).cwiseAbs().maxCoeff() < kTableTolerance);
        }
    }
}

TEST_CASE(
    "The four choices are tied together as slides 18 and 19 say, with the correct gamma#", "[core][tables]") {
    for (const JointType& type : kJointTypes) {
        test::Random random(4);
        const Mechanism m =
            test::random_joint(random, type, ParallelForm::all_three, ScrewAngleForm::rotation);
        CAPTURE(type.name);
        const State state = start_state(m);
        const Motion motion = start_motion(m);
        const System system(m, everything(m));
        const auto assembled = [&](auto choice) {
            Assembler<decltype(choice)> assembler(system);
            assembler.assemble_phi_and_jacobian(state, 0.0);
            assembler.assemble_gamma(state, motion, 0.0);
            return std::pair<MatrixX, VectorX>(
                assembler.jacobian().topRows(system.rows()), assembler.gamma().head(system.rows()));
        };
        const auto [J_true, gamma_true] = assembled(TrueEulerParameters{});
        const auto [J_modified, gamma_modified] = assembled(ModifiedEulerParameters{});
        const auto [J_local, gamma_local] = assembled(OmegaLocal{});
        const auto [J_global, gamma_global] = assembled(OmegaGlobal{});

        VectorX from_true = gamma_true;
        VectorX from_modified = gamma_modified;
        for (int b = 0; b < 2; ++b) {
            const Vec4& p = m.bodies[static_cast<std::size_t>(b)].p;
            const Vec3& w = m.bodies[static_cast<std::size_t>(b)].omega_local;
            const MatrixX true_p = J_true.middleCols<4>(7 * b + 3);
            const MatrixX modified_p = J_modified.middleCols<4>(7 * b + 3);
            const MatrixX local = J_local.middleCols<3>(6 * b + 3);
            CHECK((0.5 * true_p * L_of(p).transpose() - local).cwiseAbs().maxCoeff() < kTableTolerance);
            CHECK((0.5 * modified_p * L_of(p).transpose() - local).cwiseAbs().maxCoeff() < kTableTolerance);
            const MatrixX global = J_global.middleCols<3>(6 * b + 3);
            CHECK((local * rotation_matrix(p).transpose() - global).cwiseAbs().maxCoeff() < kTableTolerance);
            // Φ_p^(m) = 2 Φ_ω′ L + (Φ_p^(m) p) pᵀ
            const MatrixX back = 2.0 * local * L_of(p) + (modified_p * p) * p.transpose();
            CHECK((modified_p - back).cwiseAbs().maxCoeff() < kTableTolerance);
            from_true += 0.25 * w.squaredNorm() * true_p * p;
            from_modified += 0.25 * w.squaredNorm() * modified_p * p;
        }
        CHECK((from_true - gamma_local).cwiseAbs().maxCoeff() < kTableTolerance);
        CHECK((from_modified - gamma_local).cwiseAbs().maxCoeff() < kTableTolerance);
        CHECK((gamma_global - gamma_local).cwiseAbs().maxCoeff() < kTableTolerance);
    }
}
