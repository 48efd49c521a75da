#pragma once

#include <functional>
#include <string>

#include "app/film/film_pictures.hpp"
#include "render/files/image.hpp"

namespace jw::film {

/// A film as one page of HTML that needs nothing else, not even a server: pictures, timeline, chapters,
/// captions for screen readers, keys, and the text of all steps.
/// @param picture  returns the picture for an index into `pictures`; called in their order
std::string film_page(
    const Story& story, const std::vector<FilmPicture>& pictures,
    const std::function<render::Image(std::size_t)>& picture);

}  // namespace jw::film
