#pragma once

#include <string>
#include <string_view>

#include "lessons/lesson/lesson.hpp"

/// Characters that fonts must have.
namespace jw::panels {

/// The characters of a text beyond ASCII, each once, in ascending order.
std::u32string characters_in(std::string_view text);

/// Those of the texts that the lesson shows, and of its names.
std::u32string characters_of(const Lesson& lesson);

/// Those of the program's own sentences in the language of the reader; none for English.
std::u32string characters_of_messages();

/// What to install if some of the characters cannot be shown because the font for Chinese is missing; else
/// empty.
std::string advice_for(std::u32string_view characters);

}  // namespace jw::panels
