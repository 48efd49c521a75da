#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/peers/peer_scene.hpp"

/// A scene as a model for MuJoCo, of Debian or in WebAssembly.
namespace jw::peers {

/// Name of a body in the model.
std::string name_of(int body);

/// The model: a tree of joints; loops are closed by constraints of points.
/// @param hinges  empty, or three letters such as "zxy": hinges about these global axes, and slides, take the
/// place of ball joints and free joints. RK4 keeps its order then, but rates are infinite where the second
/// hinge turns by 90 degrees.
std::string mjcf(const PeerScene& scene, std::string_view hinges = {});

/// Rates of the joint's coordinates at the start, from the velocities of its two bodies.
std::vector<double> rates_of(const PeerScene& scene, const PeerJoint& joint, std::string_view hinges = {});

}  // namespace jw::peers
