#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lessons/lesson.hpp"

namespace jw {

/// Draws figures of exercises: a lesson's scene without panels. Bodies, joints, their names and vectors;
/// nothing that tells numbers, rank or rows. What is expensive, context, shaders and fonts, is made once for
/// all figures; a figure depends on its lesson alone, not on those drawn before.
class ExerciseFigures {
public:
    /// Pixels.
    /// @throws std::runtime_error if OSMesa or a font is missing
    ExerciseFigures(int width, int height);
    ~ExerciseFigures();
    ExerciseFigures(const ExerciseFigures&) = delete;
    ExerciseFigures& operator=(const ExerciseFigures&) = delete;

    /// A PNG file; the same lesson gives the same bytes.
    /// @param as_given  true: all joints and drivers at the poses of the file, whether they fit or not;
    /// false:
    ///                  everything put together, and as given where that is impossible
    std::vector<std::uint8_t> png_of(const Lesson& lesson, bool as_given);

private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

}  // namespace jw
