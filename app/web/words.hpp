#pragma once

#include <string>

namespace jw::web {

/// Words of the page around the picture, which its files have in English, in the present language: JSON with
/// the English ones as keys.
std::string words_of_page();

}  // namespace jw::web
