#include <cmath>
#include <numbers>

#include "core/eigen/decompositions.hpp"
#include "core/elementary/elementary.hpp"
#include "core/integrate/radau.hpp"

namespace jw {

namespace {

/// Nodes of Radau IIA on (0, 1]: the zeros of P_s - P_(s-1), by bisection.
VectorX radau_nodes(int stages) {
    VectorX c(stages);
    const auto legendre = [](int n, double x) {
        double before = 1.0;
        double now = x;
        for (int k = 1; k < n; ++k) {
            const double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
            before = now;
            now = next;
        }
        return n == 0 ? 1.0 : now;
    };
    const auto value = [&](double x) { return legendre(stages, x) - legendre(stages - 1, x); };
    for (int i = 0; i < stages - 1; ++i) {
        // each of these intervals contains exactly one zero
        double left = -elementary::cos(std::numbers::pi * i / (stages - 0.5));
        double right = -elementary::cos(std::numbers::pi * (i + 1) / (stages - 0.5));
        const bool rising = value(left) < 0.0;
        for (int k = 0; k < 200; ++k) {
            const double middle = 0.5 * (left + right);
            ((value(middle) < 0.0) == rising ? left : right) = middle;
        }
        c(i) = 0.5 * (1.0 + 0.5 * (left + right));
    }
    c(stages - 1) = 1.0;
    return c;
}

/// The one real eigenvalue of `a`, whose number of rows is odd.
double real_eigenvalue(const MatrixX& a) {
    const Eigen::RealSchur<MatrixX> schur(a, false);
    const MatrixX& T = schur.matrixT();
    // a pair of complex eigenvalues is a block of two rows
    Eigen::Index k = 0;
    while (k + 1 < T.rows() && T(k + 1, k) != 0.0) { k += 2; }
    return T(k, k);
}

}  // namespace

RadauTable radau_table(int stages) {
    RadauTable table;
    table.c = radau_nodes(stages);
    // a integrates polynomials of degree below s exactly from 0 to c_i: a V = C with the powers V and their
    // integrals C
    MatrixX powers(stages, stages);
    MatrixX integrals(stages, stages);
    for (int i = 0; i < stages; ++i) {
        for (int k = 0; k < stages; ++k) {
            powers(i, k) = elementary::pow(table.c(i), k);
            integrals(i, k) = elementary::pow(table.c(i), k + 1) / (k + 1);
        }
    }
    const auto powers_lu = powers.transpose().fullPivLu();
    table.a = powers_lu.solve(integrals.transpose()).transpose();
    table.gamma_0 = real_eigenvalue(table.a);
    // quadrature of order s with the node 0 besides, weight gamma_0
    VectorX moments(stages);
    for (int k = 0; k < stages; ++k) { moments(k) = 1.0 / (k + 1) - (k == 0 ? table.gamma_0 : 0.0); }
    const VectorX b_hat = powers_lu.solve(moments);
    const VectorX difference = b_hat - table.a.row(stages - 1).transpose();
    table.e = table.a.transpose().fullPivLu().solve(difference);
    return table;
}

}  // namespace jw
