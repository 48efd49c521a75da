#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/site/lesson_page.hpp"
#include "render/files/image.hpp"

namespace jw::site {

/// Receiver of each picture as a PNG, and of its path below the top of the site.
using TakePicture = std::function<void(const std::string& path, const std::vector<std::uint8_t>& png)>;

/// Draws the pictures that the page of a lesson and its card show.
void draw_pictures(
    const SiteLesson& lesson, const Story& story, const std::vector<Station>& stations,
    const TakePicture& take);

/// Picture of half the width and height, each pixel the mean of four, weighted by their opacity. An odd last
/// column or row is left out.
render::Image halved(const render::Image& image);

}  // namespace jw::site
