#pragma once

#include <string>

#include "app/session/session.hpp"

/// Experiments that are typed instead of clicked: each is an action in words (action_text.hpp), carried out
/// to its end.
namespace jw {

struct Trial {
    bool done = false;
    std::string said;  ///< what was done, or why it was not
};

/// Carries out what `text` asks for. A body that is dragged is let go at the end, a free motion that is
/// followed likewise: the pose becomes the start estimate.
Trial try_out(Session& session, const std::string& text);

}  // namespace jw
