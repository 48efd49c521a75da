#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Draws lesson, step, source, number of the step and time; the line below shows the progress of the story.
void draw_title(const Canvas& canvas, const Box& box, const View& view);

/// Draws what happened in the step, and the author's text about it.
void draw_caption(const Canvas& canvas, const Box& box, const View& view);

/// Height that a caption of this width needs to show every sentence, `box.height` if that is enough.
float caption_height(const Canvas& canvas, const Box& box, const View& view);

/// Joins the lines of a text from a lesson's file; an empty line starts a new paragraph.
std::string run_on(std::string_view text);

}  // namespace jw::panels
