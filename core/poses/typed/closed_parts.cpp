#include "core/poses/typed/closed_parts.hpp"

#include <algorithm>

#include "core/numerics/linear.hpp"

namespace jw {

namespace {

/// Depth-first search over the bodies. The joints on the way are kept until they close a part.
class PartSearch {
public:
    PartSearch(const Mechanism& mechanism, const std::vector<int>& joints)
        : mechanism_(mechanism), joints_of_(mechanism.bodies.size()), order_(mechanism.bodies.size(), 0) {
        for (const int j : joints) {
            const Joint& joint = mechanism.joints[at(j)];
            joints_of_[at(node(joint.body_i))].push_back(j);
            joints_of_[at(node(joint.body_j))].push_back(j);
        }
    }

    std::vector<ClosedPart> run() {
        for (std::size_t b = 0; b < order_.size(); ++b) {
            if (order_[b] == 0) { visit(static_cast<int>(b), -1); }
        }
        return std::move(parts_);
    }

private:
    /// Node of a body in the graph: all fixed bodies are one node.
    int node(int body) const { return mechanism_.bodies[at(body)].fixed ? 0 : body; }
    int visit(int body, int by);
    void close(int base, int joint);

    const Mechanism& mechanism_;
    std::vector<std::vector<int>> joints_of_;
    std::vector<int> order_;  ///< order in which bodies are reached, from 1; 0: not yet
    int reached_ = 0;
    std::vector<int> open_;  ///< joints of parts that are not closed yet
    std::vector<ClosedPart> parts_;
};

/// @param by joint by which the body is reached @return first body in the order that is reached from here
int PartSearch::visit(int body, int by) {
    int first = order_[at(body)] = ++reached_;
    for (const int j : joints_of_[at(body)]) {
        const Joint& joint = mechanism_.joints[at(j)];
        const int other = node(node(joint.body_i) == body ? joint.body_j : joint.body_i);
        const bool is_new = order_[at(other)] == 0;
        if (j == by || order_[at(other)] >= order_[at(body)]) { continue; }
        open_.push_back(j);
        const int reached = is_new ? visit(other, j) : order_[at(other)];
        if (is_new && reached >= order_[at(body)]) { close(body, j); }
        first = std::min(first, reached);
    }
    return first;
}

void PartSearch::close(int base, int joint) {
    const auto from = std::ranges::find(open_, joint);
    ClosedPart part{{from, open_.end()}, base};
    open_.erase(from, open_.end());
    if (part.joints.size() < 2) { return; }
    std::ranges::sort(part.joints);
    parts_.push_back(std::move(part));
}

}  // namespace

std::vector<ClosedPart> closed_parts(const Mechanism& mechanism, const std::vector<int>& joints) {
    return PartSearch(mechanism, joints).run();
}

Mechanism alone(const Mechanism& mechanism, const ClosedPart& part) {
    Mechanism out{mechanism.bodies, {}, {}, {}};
    std::vector<bool> moves(out.bodies.size(), false);
    for (const int j : part.joints) {
        const Joint& joint = out.joints.emplace_back(mechanism.joints[at(j)]);
        moves[at(joint.body_i)] = moves[at(joint.body_j)] = true;
    }
    moves[at(part.base)] = false;
    for (std::size_t b = 0; b < moves.size(); ++b) { out.bodies[b].fixed |= !moves[b]; }
    return out;
}

}  // namespace jw
