#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lessons/lesson/lesson.hpp"

namespace jw {

/// Draws figures of exercises: a lesson's scene without panels. They show bodies, joints, their names and
/// vectors, but no numbers, rank or rows. Context, shaders and fonts are expensive, so they are made once for
/// all figures. A figure depends only on its lesson, not on figures drawn before.
class ExerciseFigures {
public:
    /// @param width,height  in pixels
    /// @throws std::runtime_error if OSMesa or a font is missing
    ExerciseFigures(int width, int height);
    ~ExerciseFigures();
    ExerciseFigures(const ExerciseFigures&) = delete;
    ExerciseFigures& operator=(const ExerciseFigures&) = delete;

    /// A PNG file; the same lesson gives the same bytes.
    /// @param as_given  true: all joints and drivers at the poses of the file, whether they fit or not;
    ///                  false: everything assembled, or as given if that is impossible
    std::vector<std::uint8_t> png_of(const Lesson& lesson, bool as_given);

private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

}  // namespace jw
