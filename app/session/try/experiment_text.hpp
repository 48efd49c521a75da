#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/session/try/session.hpp"
#include "app/session/wording/typed_words.hpp"

/// Actions as sentences that a person can type: "form hinge drop x", "take out D p1 x". docs/command-line.md
/// lists them.
namespace jw {

/// The experiment that `text` asks for. Whether it is possible is not checked here.
/// @param session  what names, step numbers and "drag ... by" refer to
/// @return nothing, with what is wrong and what was expected in `error`, if it cannot be understood
std::optional<Experiment> read_experiment(
    const std::string& text, const Session& session, std::string& error);

/// The experiment in `text`, if it edits the lesson; no session is needed to read it.
/// @return nothing if `text` is not such an experiment, or cannot be understood
std::optional<Experiment> read_edit(const std::string& text, const Lesson& lesson);

/// The sentence that read_experiment reads as exactly this experiment, with every number exact, as long as
/// the lesson does not change.
/// @param experiment  about joints, drivers and bodies that the lesson has
std::string text_of(const Experiment& experiment, const Lesson& lesson);

/// Parts of sentences: geometry of joints, functions of drivers.
namespace experiment_text {

/// A member of JointGeometry and its name in sentences.
template <class T>
struct GeometryKey {
    const char* name;
    T JointGeometry::*member;
};
inline constexpr std::array kVectors{
    GeometryKey<Vec3>{"s_i", &JointGeometry::s_i_local}, GeometryKey<Vec3>{"s_j", &JointGeometry::s_j_local},
    GeometryKey<Vec3>{"P_i", &JointGeometry::P_i_local}, GeometryKey<Vec3>{"P_j", &JointGeometry::P_j_local},
    GeometryKey<Vec3>{"h_i", &JointGeometry::h_i_local}, GeometryKey<Vec3>{"h_j", &JointGeometry::h_j_local},
    GeometryKey<Vec3>{"u_i", &JointGeometry::u_i_local}, GeometryKey<Vec3>{"u_j", &JointGeometry::u_j_local}};
inline constexpr std::array kNumbers{
    GeometryKey<double>{"length", &JointGeometry::length},
    GeometryKey<double>{"alpha", &JointGeometry::alpha}, GeometryKey<double>{"d_0", &JointGeometry::d_0},
    GeometryKey<double>{"theta_0", &JointGeometry::theta_0},
    GeometryKey<double>{"ratio", &JointGeometry::ratio}};
inline constexpr std::array kOptional{
    GeometryKey<std::optional<double>>{"theta_start", &JointGeometry::theta_start},
    GeometryKey<std::optional<double>>{"theta_dot_start", &JointGeometry::theta_dot_start},
    GeometryKey<std::optional<double>>{"angle_dot_start", &JointGeometry::angle_dot_start},
    GeometryKey<std::optional<double>>{"displacement_dot_start", &JointGeometry::displacement_dot_start}};

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

}  // namespace experiment_text

}  // namespace jw
