#pragma once

#include <string>
#include <string_view>

#include "lessons/lesson.hpp"

/// Which characters fonts must have.
namespace jw::panels {

/// Those beyond ASCII, each once, in ascending order.
std::u32string characters_in(std::string_view text);

/// Those of the texts that a lesson shows now, and of its names.
std::u32string characters_of(const Lesson& lesson);

/// Those of the program's own sentences in the language of the reader; none for English.
std::u32string characters_of_messages();

/// What to install where some of the characters cannot be shown for want of the font for Chinese; else empty.
std::string advice_for(std::u32string_view characters);

}  // namespace jw::panels
