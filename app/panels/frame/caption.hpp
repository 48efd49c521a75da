#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Lesson and step, source, number of the step, time; the line below is how far the story has come.
void draw_title(const Canvas& canvas, const Box& box, const View& view);

/// Draws what happened in the step and the author's words about it.
void draw_caption(const Canvas& canvas, const Box& box, const View& view);

/// Height that a caption of this width needs to show every sentence, `box.height` if that is enough.
float caption_height(const Canvas& canvas, const Box& box, const View& view);

/// Lines of a lesson's file run on; an empty line starts a paragraph.
std::string run_on(std::string_view text);

}  // namespace jw::panels
