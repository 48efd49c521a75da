#pragma once

#include "lessons/fields/fields.hpp"
#include "lessons/lesson/exercise.hpp"

/// Parts of the reader of exercises.
namespace jw::reading {

/// Keys `vary` and `condition_below`.
void read_draws(Fields& fields, Exercise& exercise);
/// The keys that belong to the kind of the exercise.
void read_answer(Fields& fields, Exercise& exercise);
/// A list of changes of a scene: { key = "joint.B.axis", value = [1, 0, 0] }.
std::vector<SceneEdit> read_edits(Fields& fields, std::string_view key);
/// A node as TOML; empty if the key is not there.
std::string toml_of(Fields& fields, std::string_view key);
/// The entries of a list, each as TOML.
std::vector<std::string> list_of_toml(Fields& fields, std::string_view key);

}  // namespace jw::reading
