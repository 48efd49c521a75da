#pragma once

#include <memory>

#include "app/session/picture/picture.hpp"

namespace jw {

/// A lesson's scene at rest, as figures of exercises show it: bodies, joints, their names and vectors, but no
/// numbers, rank or rows.
class Still {
public:
    /// @param as_given  true: all joints and drivers at the poses of the file, whether they fit or not;
    ///                  false: everything assembled, or as given if that is impossible
    Still(const Lesson& lesson, bool as_given);

    const Picture& picture() const { return picture_; }
    const PictureStyle& style() const { return style_; }
    /// The camera that shows everything.
    render::Camera camera(const render::Rect& viewport, const render::Rect& safe) const;

private:
    std::unique_ptr<const Lesson> lesson_;  ///< the lesson of the story
    std::unique_ptr<const Story> story_;
    PictureStyle style_;
    Picture picture_;
};

}  // namespace jw
