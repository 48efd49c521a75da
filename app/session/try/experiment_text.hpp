#pragma once

#include <optional>
#include <string>

#include "app/session/try/session.hpp"

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

}  // namespace jw
