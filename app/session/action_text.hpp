#pragma once

#include <optional>
#include <string>

#include "app/session/session.hpp"

/// Actions as sentences that a person can type: "form hinge drop x", "take out D p1 x". docs/command-line.md
/// lists them.
namespace jw {

/// The action that `text` asks for. Whether it is possible is found out by whoever carries it out.
/// @param session  what names, step numbers and "drag ... by" refer to
/// @return nothing, with what is wrong and what was expected in `error`, if it cannot be understood
std::optional<Action> read_action(const std::string& text, const Session& session, std::string& error);

/// The sentence that read_action understands as this very action, every number exactly, as long as the lesson
/// is the one that `session` shows.
/// @param action  about joints, drivers and bodies that the lesson has
std::string text_of(const Action& action, const Session& session);

}  // namespace jw
