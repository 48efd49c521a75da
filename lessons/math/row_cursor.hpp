#pragma once

#include <variant>
#include <vector>

#include "lessons/math/math.hpp"

namespace jw::math {

/// A position in a row of nodes; spaces are skipped.
class RowCursor {
public:
    explicit RowCursor(const Row& row) {
        for (const Node& node : row) {
            if (!std::holds_alternative<Space>(node.nucleus)) { nodes_.push_back(&node); }
        }
    }
    bool at_end() const { return at_ >= nodes_.size(); }
    const Node& peek() const { return *nodes_[at_]; }
    const Node* ahead(std::size_t count) const {
        return at_ + count < nodes_.size() ? nodes_[at_ + count] : nullptr;
    }
    const Node& next() { return *nodes_[at_++]; }
    const Node& last() const { return *nodes_[at_ - 1]; }

private:
    std::vector<const Node*> nodes_;
    std::size_t at_ = 0;
};

}  // namespace jw::math
