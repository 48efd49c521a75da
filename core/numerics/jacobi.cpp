#include "core/numerics/jacobi.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jw {

namespace {

constexpr int kMostRounds = 40;  // convergence is quadratic: more than 10 sweeps have not been seen
// columns of a tile: two tiles of X and J with 600 rows stay in the L2 cache
constexpr Eigen::Index kTile = 16;
/// Ratio by which a rotation may reduce a squared norm before its update has lost too many digits.
constexpr double kCancelled = 0.1;

/// Dot product with four partial sums, always in this order: bit-identical on every machine.
double dot(const double* a, const double* b, Eigen::Index n) {
    double s0 = 0.0;
    double s1 = 0.0;
    double s2 = 0.0;
    double s3 = 0.0;
    Eigen::Index k = 0;
    for (; k + 4 <= n; k += 4) {
        s0 += a[k] * b[k];
        s1 += a[k + 1] * b[k + 1];
        s2 += a[k + 2] * b[k + 2];
        s3 += a[k + 3] * b[k + 3];
    }
    for (; k < n; ++k) { s0 += a[k] * b[k]; }
    return (s0 + s2) + (s1 + s3);
}

/// Rotation by an angle with sine s and tan(angle / 2) = tau, written as increments: with the cosine itself,
/// which rounds to 1 for small angles, every small rotation would lengthen both columns.
/// @source Rutishauser, The Jacobi method for real symmetric matrices, Numer. Math. 9 (1966)
void rotate(double* __restrict a, double* __restrict b, Eigen::Index n, double s, double tau) {
    for (Eigen::Index k = 0; k < n; ++k) {
        const double a_k = a[k];
        a[k] -= s * (b[k] + tau * a_k);
        b[k] += s * (a_k - tau * b[k]);
    }
}

class Rounds {
public:
    Rounds(MatrixX& X, MatrixX& J)
        : X_(X),
          J_(J),
          squared_(X.cols()),
          tolerance_(std::sqrt(static_cast<double>(X.rows())) * std::numeric_limits<double>::epsilon()) {}

    /// One sweep over all pairs. @return whether every pair was orthogonal already
    bool all_pairs() {
        rotated_ = false;
        // recomputed, since updated norms drift
        for (Eigen::Index k = 0; k < X_.cols(); ++k) { measure(k); }
        const Eigen::Index count = X_.cols();
        for (Eigen::Index first = 0; first < count; first += kTile) {
            for (Eigen::Index second = first; second < count; second += kTile) {
                tile(first, std::min(first + kTile, count), second, std::min(second + kTile, count));
            }
        }
        return !rotated_;
    }

private:
    double* column(MatrixX& m, Eigen::Index k) { return m.data() + k * m.rows(); }
    void measure(Eigen::Index k) { squared_(k) = dot(column(X_, k), column(X_, k), X_.rows()); }

    void tile(Eigen::Index p_first, Eigen::Index p_end, Eigen::Index q_first, Eigen::Index q_end) {
        for (Eigen::Index p = p_first; p < p_end; ++p) {
            for (Eigen::Index q = std::max(p + 1, q_first); q < q_end; ++q) { pair(p, q); }
        }
    }

    void pair(Eigen::Index p, Eigen::Index q) {
        const double product = dot(column(X_, p), column(X_, q), X_.rows());
        const double size = std::sqrt(squared_(p)) * std::sqrt(squared_(q));
        if (std::abs(product) <= tolerance_ * size) { return; }
        rotated_ = true;
        const double zeta = (squared_(q) - squared_(p)) / (2.0 * product);
        // the square overflows only if the norms differ by a factor of 1e150: then no rotation is needed
        const double t = (zeta < 0.0 ? -1.0 : 1.0) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
        const double c = 1.0 / std::sqrt(1.0 + t * t);
        const double s = c * t;
        const double tau = s / (1.0 + c);
        rotate(column(X_, p), column(X_, q), X_.rows(), s, tau);
        rotate(column(J_, p), column(J_, q), J_.rows(), s, tau);
        update(p, -t * product);
        update(q, t * product);
    }

    void update(Eigen::Index k, double change) {
        const double before = squared_(k);
        squared_(k) += change;
        if (squared_(k) < kCancelled * before) { measure(k); }
    }

    MatrixX& X_;
    MatrixX& J_;
    VectorX squared_;  ///< squared norms of the columns of X
    double tolerance_;
    bool rotated_ = false;
};

}  // namespace

bool make_columns_orthogonal(MatrixX& X, MatrixX& J) {
    Rounds rounds(X, J);
    for (int round = 0; round < kMostRounds; ++round) {
        if (rounds.all_pairs()) { return true; }
    }
    return false;
}

}  // namespace jw
