#pragma once

#include <string>
#include <vector>

#include "app/session/try/experiments.hpp"
#include "app/session/wording/typed_words.hpp"

/// Parts of experiment_text.hpp: geometry of joints, functions of drivers.
namespace jw::experiment_text {

std::vector<std::string> names_of_joints(const Lesson& lesson);
std::vector<std::string> names_of_drivers(const Lesson& lesson);

/// "1 0 -0.5", exact.
std::string numbers_text(const Vec3& v);

/// Reads the words that follow "axis", "point", "length" or "geometry".
SetGeometry read_axis(Words& words, const Lesson& lesson);
SetGeometry read_point(Words& words, const Lesson& lesson);
SetGeometry read_length(Words& words, const Lesson& lesson);
SetGeometry read_geometry(Words& words, const Lesson& lesson);
/// The experiment as "axis" or "point" if that is enough, else as "geometry".
std::string text_of(const SetGeometry& experiment, const Lesson& lesson);

/// Reads the words that follow "driver".
SetDriver read_driver(Words& words, const Lesson& lesson);
std::string text_of(const SetDriver& experiment, const Lesson& lesson);

}  // namespace jw::experiment_text
