#pragma once

#include <algorithm>
#include <vector>

#include "core/integrate/runge_kutta.hpp"

/// Rooted trees, one order condition of Runge-Kutta methods each.
/// @source Butcher; Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, section II.2
namespace jw::test {

/// Children by their index in the list of all trees, largest first, so that every tree appears once.
struct RootedTree {
    std::vector<std::size_t> children;
    int order = 1;         ///< vertices
    double density = 1.0;  ///< γ: product of the orders of all subtrees
};

class RootedTrees {
public:
    /// All trees with up to `order` vertices, ascending.
    explicit RootedTrees(int order) {
        trees_.push_back({});
        for (int n = 2; n <= order; ++n) {
            RootedTree tree;
            tree.order = n;
            tree.density = n;
            grow(tree, n - 1, trees_.size());
        }
    }

    const std::vector<RootedTree>& all() const { return trees_; }

    /// Φ of a tree for weights that need not be the b of the table: Σ weights_s Π (children, through a).
    double weight(const RungeKuttaTable& table, const RungeKuttaTable::Row& weights, std::size_t tree) const {
        const RungeKuttaTable::Row stages = products(table, tree);
        double sum = 0.0;
        for (std::size_t s = 0; s < stages.size(); ++s) { sum += weights[s] * stages[s]; }
        return sum;
    }

private:
    /// Adds children with `left` vertices in all, each before `bound` in the list.
    void grow(const RootedTree& tree, int left, std::size_t bound) {
        if (left == 0) {
            trees_.push_back(tree);
            return;
        }
        for (std::size_t child = bound; child-- > 0;) {
            if (trees_[child].order > left) { continue; }
            RootedTree grown = tree;
            grown.children.push_back(child);
            grown.density *= trees_[child].density;
            grow(grown, left - trees_[child].order, child + 1);
        }
    }

    RungeKuttaTable::Row products(const RungeKuttaTable& table, std::size_t tree) const {
        RungeKuttaTable::Row out{};
        std::fill_n(out.begin(), table.stages, 1.0);
        for (const std::size_t child : trees_[tree].children) {
            const RungeKuttaTable::Row inner = products(table, child);
            for (std::size_t s = 0; s < static_cast<std::size_t>(table.stages); ++s) {
                double sum = 0.0;
                for (std::size_t m = 0; m < s; ++m) { sum += table.a[s][m] * inner[m]; }
                out[s] *= sum;
            }
        }
        return out;
    }

    std::vector<RootedTree> trees_;
};

}  // namespace jw::test
