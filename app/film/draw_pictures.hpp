#pragma once

#include <functional>
#include <span>

#include "app/film/film_pictures.hpp"
#include "app/host/frames/frame_draft.hpp"
#include "app/host/frames/frame_painter.hpp"

/// Drawing the pictures of a film or of a folder into files.
namespace jw::film {

/// A picture and the number of its file.
struct NumberedPicture {
    int number = 0;
    FilmPicture picture;
};

/// A lesson that is drawn: what all pictures of a run have in common.
struct DrawnLesson {
    const Story* story = nullptr;
    int width = 0;
    int height = 0;
    host::FrameLook look;
};

/// Draws those of the pictures that are not there yet. Each depends on nothing but its step, so they are the
/// same in whatever order, and by how many processes, they are drawn.
/// @param progress  told the number of those that are there
/// @throws std::runtime_error if OSMesa or a font is missing, or a picture cannot be written
void draw_missing(
    const DrawnLesson& lesson, std::span<const NumberedPicture> pictures, const host::FrameDraft& draft,
    const std::function<void(std::size_t there)>& progress);

/// Part `part` of `parts` equal ones, counted from 0: pictures next to each other, which have most in common.
std::span<const NumberedPicture> part_of(std::span<const NumberedPicture> all, int part, int parts);

}  // namespace jw::film
