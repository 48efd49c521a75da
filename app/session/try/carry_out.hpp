#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/try/session.hpp"

/// Experiments in words (experiment_text.hpp), typed instead of clicked: each is carried out to its end.
namespace jw {

struct ExperimentResult {
    bool done = false;
    std::string said;  ///< what was done, or why it was not
};

/// Carries out the experiment in `text`. At the end of a drag or of a followed free motion, the pose becomes
/// the start estimate.
ExperimentResult carry_out(Session& session, const std::string& text);

/// A session in which all of `texts` were carried out, one after the other; each can be undone. Edits at the
/// beginning, in the form of Session::tried, do not tell the story each time.
/// @throws std::runtime_error naming the first one that cannot be done, with the reason
std::unique_ptr<Session> session_after(
    const Lesson& lesson, const std::vector<std::string>& texts, const Storyteller& tell = tell_at_once);

}  // namespace jw
