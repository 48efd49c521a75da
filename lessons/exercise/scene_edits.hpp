#pragma once

#include <span>
#include <string>
#include <vector>

#include "lessons/lesson/exercise.hpp"

/// Changes of a lesson file as text, so that its comments and everything else stay unchanged.
///
/// A key is a path: "joint.B.axis", "body.dial.rotation.angle_deg", "driver.turn.polynomial_deg.1",
/// "motion.to_s". Entries of a list of tables are named by their `name`, or by their number from 0.
namespace jw {

struct EditedScene {
    std::string text;
    std::string problem;  ///< "there is no 'joint.B.axis' that could be set"; empty if all edits were made
};

/// The scene with the edits made one after the other.
EditedScene with_edits(std::string scene, std::span<const SceneEdit> edits);

/// The scene without the tables of these names, such as "expect". Each is removed up to the next header that
/// stays, with the comments in front of that header.
std::string without_tables(const std::string& scene, const std::vector<std::string>& names);

/// The scene without the keys `text` and `summary` of the lesson, its joints and its drivers, in all
/// languages.
std::string without_texts(const std::string& scene);

/// Value of a key as TOML; empty if there is none.
std::string value_in(const std::string& scene, const std::string& key);

/// The tables [[expect]] of a lesson, as TOML.
std::string claims_in(const std::string& scene);

}  // namespace jw
