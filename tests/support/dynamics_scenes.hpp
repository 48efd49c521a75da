#pragma once

#include <filesystem>
#include <vector>

#include "lessons/lesson/lesson.hpp"

/// The scenes of dynamics that are measured and shown, for any number of bodies. All start assembled, with
/// velocities that the joints allow. Definitions: IFToMM library of computational benchmark problems, and two
/// chains for scaling; points and their ends are those of docs/ and of the references in them.
namespace jw::test {

/// A01: a ball on a massless rod, let go at the height of its pin.
Lesson simple_pendulum();
/// A02: n + 1 upright rods side by side, n couplers, all in one line twice a turn.
Lesson n_four_bar(int n);
/// A03: Andrews' squeezing mechanism, seven bodies, 50 ms.
Lesson andrews_mechanism();
/// A04: six hinges along edges of a cube fall; one of the 30 equations repeats the others.
Lesson falling_bricard();
/// A05: a flyball governor on springs so stiff that explicit methods creep.
Lesson flyball_governor();

/// n rods of 1 m in a row, from the origin along x: hinges z, y, z, y ..., or balls.
enum class ChainJoint { revolute, spherical };
Lesson chain(ChainJoint joint, int n);

/// The spatial slider-crank of the loops, without a motor.
Lesson falling_slider_crank();
/// A heavy symmetric top on its tip.
Lesson spinning_top();
/// A free body that turns about its middle axis.
Lesson free_asymmetric_body();

/// A shipped file and what is in it.
struct SceneFile {
    std::filesystem::path path;  ///< below lessons/
    Lesson lesson;
};
std::vector<SceneFile> dynamics_scene_files();

}  // namespace jw::test
