#include "core/numerics/block_matrix.hpp"

#include <set>
#include <stdexcept>

namespace jw {

BlockStructure::BlockStructure(const std::vector<std::vector<int>>& neighbours)
    : position_(neighbours.size(), -1), blocks_(static_cast<int>(neighbours.size())) {
    const std::size_t count = neighbours.size();
    std::vector<std::set<int>> left(count);
    std::set<std::pair<std::size_t, int>> by_degree;
    for (std::size_t n = 0; n < count; ++n) {
        left[n].insert(neighbours[n].begin(), neighbours[n].end());
        by_degree.insert({left[n].size(), static_cast<int>(n)});
    }
    const auto set_of = [&](int n) -> std::set<int>& { return left[static_cast<std::size_t>(n)]; };
    std::vector<std::vector<int>> rows(count);
    while (!by_degree.empty()) {
        const int node = by_degree.begin()->second;
        by_degree.erase(by_degree.begin());
        position_[static_cast<std::size_t>(node)] = static_cast<int>(pivots_.size());
        pivots_.push_back({node, {}, {}});
        const std::set<int> touched = set_of(node);
        rows[static_cast<std::size_t>(node)].assign(touched.begin(), touched.end());
        // the neighbours of the pivot become a clique
        for (const int a : touched) {
            by_degree.erase({set_of(a).size(), a});
            set_of(a).erase(node);
            for (const int b : touched) {
                if (a != b) { set_of(a).insert(b); }
            }
            by_degree.insert({set_of(a).size(), a});
        }
    }
    for (Pivot& pivot : pivots_) {
        std::vector<int>& row = rows[static_cast<std::size_t>(pivot.node)];
        std::ranges::sort(row, {}, [&](int n) { return position(n); });
        for (const int node : row) { pivot.uppers.push_back({node, blocks_++}); }
    }
    for (Pivot& pivot : pivots_) {
        for (std::size_t i = 0; i < pivot.uppers.size(); ++i) {
            for (std::size_t j = i; j < pivot.uppers.size(); ++j) {
                pivot.updates.push_back(
                    {block_of(pivot.uppers[i].node, pivot.uppers[j].node), static_cast<int>(i),
                     static_cast<int>(j)});
            }
        }
    }
}

int BlockStructure::block_of(int a, int b) const {
    if (a == b) { return a; }
    const Pivot& pivot = pivots_[static_cast<std::size_t>(position(a))];
    for (const Upper& upper : pivot.uppers) {
        if (upper.node == b) { return upper.block; }
    }
    throw std::invalid_argument("BlockStructure: there is no such block");
}

}  // namespace jw
