#include <catch2/catch.hpp>

#include <Eigen/Cholesky>

#include "core/numerics/block_matrix.hpp"
#include "core/numerics/linear.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

using Neighbours = std::vector<std::vector<int>>;

void link(Neighbours& neighbours, int a, int b) {
    auto& list = neighbours[static_cast<std::size_t>(a)];
    if (a == b || std::ranges::find(list, b) != list.end()) { return; }
    list.push_back(b);
    neighbours[static_cast<std::size_t>(b)].push_back(a);
}

Neighbours random_graph(test::Random& random, int nodes, double edges_per_node) {
    Neighbours out(static_cast<std::size_t>(nodes));
    const auto any = [&] { return static_cast<int>(random.number(0.0, nodes - 1e-9)); };
    for (int k = 0; k < edges_per_node * nodes; ++k) { link(out, any(), any()); }
    return out;
}

/// Positive definite, with a block for every edge.
MatrixX random_matrix(test::Random& random, const Neighbours& neighbours, int block) {
    const auto nodes = static_cast<int>(neighbours.size());
    MatrixX out = MatrixX::Zero(nodes * block, nodes * block);
    for (int a = 0; a < nodes; ++a) {
        for (const int b : neighbours[static_cast<std::size_t>(a)]) {
            if (b < a) { continue; }
            // a positive semidefinite part on the two nodes
            MatrixX root(2 * block, block);
            for (Eigen::Index k = 0; k < root.size(); ++k) { root(k) = random.number(); }
            const MatrixX part = root * root.transpose();
            out.block(a * block, a * block, block, block) += part.topLeftCorner(block, block);
            out.block(a * block, b * block, block, block) += part.topRightCorner(block, block);
            out.block(b * block, a * block, block, block) += part.bottomLeftCorner(block, block);
            out.block(b * block, b * block, block, block) += part.bottomRightCorner(block, block);
        }
    }
    out.diagonal().array() += 0.1;
    return out;
}

template <int B>
void fill(
    BlockMatrix<B>& matrix, const BlockStructure& structure, const Neighbours& neighbours,
    const MatrixX& dense) {
    matrix.set_zero();
    const auto copy = [&](int a, int b) {
        Eigen::Map<Eigen::Matrix<double, B, B, Eigen::RowMajor>>(matrix.block(structure.block_of(a, b))) =
            dense.block<B, B>(a * B, b * B);
    };
    for (int a = 0; a < structure.nodes(); ++a) {
        copy(a, a);
        for (const int b : neighbours[static_cast<std::size_t>(a)]) {
            if (structure.position(a) < structure.position(b)) { copy(a, b); }
        }
    }
}

template <int B>
void compare_with_dense(unsigned seed, int nodes, double edges_per_node) {
    test::Random random(seed);
    const Neighbours neighbours = random_graph(random, nodes, edges_per_node);
    const MatrixX dense = random_matrix(random, neighbours, B);
    const BlockStructure structure(neighbours);
    BlockMatrix<B> matrix(structure);
    fill(matrix, structure, neighbours, dense);
    VectorX b(nodes * B);
    for (Eigen::Index k = 0; k < b.size(); ++k) { b(k) = random.number(); }
    const Eigen::LDLT<MatrixX> ldlt(dense);
    const VectorX expected = ldlt.solve(b);
    VectorX x = b;
    matrix.factor();
    matrix.solve(x.data());
    CAPTURE(seed, nodes, edges_per_node);
    // rounding 1e-16 times the condition: the largest eigenvalue is below 1e3, the smallest 0.1
    CHECK((x - expected).norm() < 1e-11 * expected.norm());
    double log_determinant = 0.0;
    for (int node = 0; node < nodes; ++node) {
        for (int row = 0; row < B; ++row) { log_determinant -= std::log(matrix.inverse_pivot(node, row)); }
    }
    CHECK(log_determinant == Approx(ldlt.vectorD().array().log().sum()).epsilon(1e-11));
}

}  // namespace

TEST_CASE("Block factors solve as a dense factorisation on random graphs", "[core][dynamics][block]") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        for (const int nodes : {1, 2, 7, 30}) {
            for (const double edges_per_node : {0.0, 0.8, 1.5, 5.0}) {
                compare_with_dense<3>(seed, nodes, edges_per_node);
                compare_with_dense<6>(seed, nodes, edges_per_node);
            }
        }
    }
}

TEST_CASE("Trees fill nothing in, and a ring of n nodes n - 3 blocks", "[core][dynamics][block]") {
    const int nodes = 40;
    test::Random random(5);
    Neighbours tree(static_cast<std::size_t>(nodes));
    for (int n = 1; n < nodes; ++n) { link(tree, n, static_cast<int>(random.number(0.0, n - 1e-9))); }
    CHECK(BlockStructure(tree).blocks() == 2 * nodes - 1);

    Neighbours ring(static_cast<std::size_t>(nodes));
    for (int n = 0; n < nodes; ++n) { link(ring, n, (n + 1) % nodes); }
    CHECK(BlockStructure(ring).blocks() == 2 * nodes + (nodes - 3));
}

TEST_CASE("Every node is eliminated once and sees all that it still touches", "[core][dynamics][block]") {
    test::Random random(9);
    const Neighbours neighbours = random_graph(random, 25, 2.0);
    const BlockStructure structure(neighbours);
    std::vector<bool> seen(25, false);
    for (const BlockStructure::Pivot& pivot : structure.pivots()) {
        seen[static_cast<std::size_t>(pivot.node)] = true;
        for (const int other : neighbours[static_cast<std::size_t>(pivot.node)]) {
            const bool above =
                std::ranges::any_of(pivot.uppers, [&](const auto& u) { return u.node == other; });
            CHECK(above == !seen[static_cast<std::size_t>(other)]);
        }
        for (const auto& upper : pivot.uppers) {
            CHECK(structure.position(upper.node) > structure.position(pivot.node));
        }
    }
    CHECK(std::ranges::all_of(seen, [](bool b) { return b; }));
}
