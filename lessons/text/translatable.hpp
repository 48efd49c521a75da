#pragma once

namespace jw {

/// Marks a text of a table as a message that is translated where it is shown
/// (app/session/wording/messages.hpp).
constexpr const char* tr_later(const char* english) { return english; }

}  // namespace jw
