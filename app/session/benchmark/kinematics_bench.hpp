#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/lesson/lesson.hpp"

/// Speed against error of kinematics: position, velocity and acceleration per moment of a driven motion.
namespace jw {

/// One way to compute the moments of a motion, each from the moment before.
struct KinematicsRun {
    std::string coordinates;    ///< one of kChoices, or "graph" for the way that motions are followed
    std::string rows;           ///< "selected": p1 and p2 by the rule; "n1 pair"
    double microseconds = 0.0;  ///< per moment, the shortest of several repeats
    double iterations = 0.0;    ///< Newton iterations per moment; NaN where they are not counted
    double position = 0.0;      ///< largest error [scene's unit of length, rad]
    double velocity = 0.0;      ///< relative to the largest velocity
    double acceleration = 0.0;  ///< relative to the largest acceleration
    int missed = 0;             ///< moments that were not found
};

struct KinematicsScene {
    std::string name;
    int bodies = 0;  ///< moving bodies
    int equations = 0;
    int moments = 0;
    std::vector<KinematicsRun> runs;
};

/// All ways on the same moments of one lesson. Errors are differences from poses found in (r, ω') with one
/// Newton step beyond the tolerance.
/// @return nothing for a lesson without a driven motion, or if its motion cannot be followed to its end
std::optional<KinematicsScene> bench_kinematics(const Lesson& lesson, const std::string& name);

}  // namespace jw
