#pragma once

#include "app/commands/options/experiment_option.hpp"
#include "app/commands/options/frame_range.hpp"
#include "app/commands/options/render_options.hpp"

namespace jw {

/// Carries out `jointwise render`: draws the steps of `range`, or this process's part of them, and puts them
/// together as a film or a folder.
/// @throws CommandError, std::runtime_error if something cannot be drawn or written; existing files stay
void draw(
    const RenderOptions& options, const CheckedRender& checked, const ChangedLesson& changed,
    const Story& story, const FrameRange& range, const Streams& streams);

}  // namespace jw
