#include "app/hard/cases.hpp"

#include <array>

namespace jw::hard {

namespace {

constexpr std::array kCases{
    Case{
        "kept-pair-at-90", "The kept pair driven to 90 degrees",
        "Two of the three rows of a parallel constraint are independent, but which two depends on the axis: "
        "a revolute joint whose axis turns with its first body by 90 degrees loses the pair chosen at the "
        "start.",
        "the pair of the start is kept", "the rule chooses again at every pose",
        "parallel/which-two-of-three.toml", kept_pair_at_right_angle},
};

}  // namespace

std::span<const Case> cases() { return kCases; }

}  // namespace jw::hard
