#pragma once

#include <functional>
#include <span>

#include "app/film/film_pictures.hpp"
#include "app/host/frames/frame_draft.hpp"
#include "app/host/frames/frame_painter.hpp"

/// Draws the pictures of a film or of a folder into files.
namespace jw::film {

/// A picture and the number of its file.
struct NumberedPicture {
    int number = 0;
    FilmPicture picture;
};

/// A lesson to draw: what all pictures of a run have in common.
struct DrawnLesson {
    const Story* story = nullptr;
    int width = 0;
    int height = 0;
    host::FrameLook look;
};

/// Draws the pictures that do not exist yet. Each one depends only on its step, so the pictures are the same
/// in any order and with any number of processes.
/// @param progress  called with the number of pictures that exist
/// @throws std::runtime_error if OSMesa or a font is missing, or a picture cannot be written
void draw_missing(
    const DrawnLesson& lesson, std::span<const NumberedPicture> pictures, const host::FrameDraft& draft,
    const std::function<void(std::size_t there)>& progress);

/// Pictures of part `part` (from 0) of `parts` equal parts. They are consecutive, because neighbours have
/// most in common.
std::span<const NumberedPicture> part_of(std::span<const NumberedPicture> all, int part, int parts);

}  // namespace jw::film
