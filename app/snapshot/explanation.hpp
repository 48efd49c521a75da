#pragma once

#include <string>
#include <vector>

namespace jw::snapshot {

/// The changes in a lesson file, one line for each key: "radius of rod: 1 mm larger (body.rod.radius, 0.03 →
/// 0.031)". Empty if both files say the same, whatever their comments and layout.
std::vector<std::string> lesson_changes(const std::string& before, const std::string& now);

}  // namespace jw::snapshot
