#pragma once

#include <string>
#include <string_view>

#include "lessons/lesson/lesson.hpp"

/// Characters that fonts must have.
namespace jw::panels {

/// The characters of a text beyond ASCII, each once, in ascending order.
std::u32string characters_in(std::string_view text);

/// Such characters of the texts that the lesson shows, and of its names.
std::u32string characters_of(const Lesson& lesson);

/// Such characters of the program's own sentences in the language of the reader; none for English.
std::u32string characters_of_messages();

/// Advice to install the font for Chinese, if some of the characters cannot be shown because it is missing;
/// else empty.
std::string advice_for(std::u32string_view characters);

}  // namespace jw::panels
