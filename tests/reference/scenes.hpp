#pragma once

#include "tests/reference/scene.hpp"

/// The benchmark scenes: the IFToMM library, two kinds of chains, and three that have closed forms or none.
namespace jw::reference {

Scene simple_pendulum();                  ///< A01
Scene four_bars(int windows);             ///< A02
Scene andrews();                          ///< A03
Scene bricard_falling();                  ///< A04
Scene governor();                         ///< A05
Scene chain(int rods, JointKind joints);  ///< CHR, CHS
Scene spatial_slider_crank_falling();
Scene spinning_top();
Scene free_asymmetric_body();

/// All, in the order they are stored.
std::vector<Scene> all_scenes();

}  // namespace jw::reference
