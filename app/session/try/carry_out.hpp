#pragma once

#include <string>

#include "app/session/try/session.hpp"

/// Experiments in words (experiment_text.hpp), typed instead of clicked: each is carried out to its end.
namespace jw {

struct ExperimentResult {
    bool done = false;
    std::string said;  ///< what was done, or why it was not
};

/// Carries out what `text` asks for. A body that is dragged is let go at the end, a free motion that is
/// followed likewise: the pose becomes the start estimate.
ExperimentResult carry_out(Session& session, const std::string& text);

}  // namespace jw
