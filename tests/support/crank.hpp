#pragma once

/// The smallest lesson that moves.
namespace jw::test {

/// A crank on the ground, driven at 90 deg/s.
inline constexpr const char* kCrank = R"(format = 1
title = "A crank"
[[body]]
name = "crank"
[[joint]]
name = "pivot"
type = "revolute"
bodies = ["ground", "crank"]
at = [0, 0, 0]
axis = [0, 0, 1]
[[driver]]
name = "drive"
joint = "pivot"
quantity = "angle"
polynomial_deg = [0, 90]
[motion]
to_s = 1
steps = 4
)";

}  // namespace jw::test
