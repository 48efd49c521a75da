#pragma once

#include <functional>
#include <string>

#include "app/film/film_pictures.hpp"
#include "render/image.hpp"

namespace jw::film {

/// A film as one page of HTML that needs nothing else, not even a server: pictures, timeline, chapters,
/// captions that screen readers speak, keys, and the words of all steps.
/// @param picture  gives the picture of that place in `pictures`; asked in their order
std::string film_page(
    const Story& story, const std::vector<FilmPicture>& pictures,
    const std::function<render::Image(std::size_t)>& picture);

}  // namespace jw::film
