#include "app/session/story/featured.hpp"

#include <algorithm>

namespace jw {

namespace {

// the vectors and formulas of more than two joints would hide each other
constexpr std::size_t kMostAtOnce = 2;

bool is_few(const std::vector<int>& joints) { return !joints.empty() && joints.size() <= kMostAtOnce; }

/// Joints without a glyph: only their vectors are visible.
std::vector<int> bare_joints(const Mechanism& mechanism) {
    std::vector<int> bare;
    for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
        if (mechanism.joints[k].type->glyph == JointGlyph::none) { bare.push_back(static_cast<int>(k)); }
    }
    return bare;
}

}  // namespace

std::vector<int> featured_joints(const Story& story) {
    const Mechanism& mechanism = story.lesson().mechanism;
    if (story.chosen_joint() >= 0) { return {story.chosen_joint()}; }
    std::vector<int> bare = bare_joints(mechanism);
    if (is_few(bare)) { return bare; }
    std::erase_if(bare, [&](int joint) {
        return std::ranges::none_of(
            mechanism.joints[static_cast<std::size_t>(joint)].type->roles, is_parallel);
    });
    if (is_few(bare)) { return bare; }
    if (story.featured_joint() >= 0) { return {story.featured_joint()}; }
    return {};
}

}  // namespace jw
