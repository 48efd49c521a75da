#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/exercises/formulas/formula_plan.hpp"
#include "lessons/lesson/exercise.hpp"
#include "lessons/lesson/lesson.hpp"

/// Exercises with drawn parameters.
namespace jw {

/// An exercise as one student gets it.
struct Variant {
    const Exercise* exercise = nullptr;
    std::uint64_t seed = 0;
    std::string scene;  ///< the lesson file with the drawn values in it; empty without a scene
    std::shared_ptr<const FormulaPlan> plan;  ///< of its formula; nothing if it has none
    Lesson lesson;  ///< of that file, with what is asked (or expected) as its claims
};

/// One drawn variant, accepted or not.
struct VariantDraw {
    std::optional<Variant> variant;
    std::string problem;  ///< why there is no variant
};

/// The variant of a seed, whether it can be used or not. `exercise` must outlive it.
/// @param plan  of its formula, made once for all variants
VariantDraw drawn_variant(
    const Exercise& exercise, std::uint64_t seed, std::shared_ptr<const FormulaPlan> plan);

}  // namespace jw
