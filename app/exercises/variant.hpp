#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lessons/exercise/exercise.hpp"
#include "lessons/lesson.hpp"

/// Exercises with drawn parameters.
namespace jw {

/// An exercise as one student gets it.
struct Variant {
    const Exercise* exercise = nullptr;
    std::uint64_t seed = 0;
    std::string scene;  ///< the lesson file with the drawn values in it; empty without a scene
    Lesson lesson;      ///< of that file, with what is asked (or expected) as its claims
};

/// One draw, accepted or not.
struct VariantDraw {
    std::optional<Variant> variant;
    std::string problem;  ///< why there is none
};

/// The variant of a seed, whether it is a good one or not. `exercise` must outlive it.
VariantDraw drawn_variant(const Exercise& exercise, std::uint64_t seed);

}  // namespace jw
