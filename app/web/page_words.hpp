#pragma once

#include <string>

namespace jw::web {

/// Words of the page around the picture, in the current language: JSON with the English words, which are in
/// the files of the page, as keys.
std::string words_of_page();

}  // namespace jw::web
