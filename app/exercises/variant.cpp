#include "app/exercises/variant.hpp"

#include <array>
#include <cmath>

#include "app/exercises/kinds.hpp"
#include "app/exercises/random.hpp"
#include "lessons/exercise/scene_edits.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

// a² + b² + c² = n²
constexpr std::array<std::array<int, 4>, 6> kDirections{
    {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}, {6, 6, 7, 11}}};
// e0² + e1² + e2² + e3² = n²
constexpr std::array<std::array<int, 5>, 7> kParameters{
    {{1, 1, 1, 1, 2},
     {1, 2, 2, 4, 5},
     {2, 2, 4, 5, 7},
     {1, 4, 4, 4, 7},
     {2, 4, 5, 6, 9},
     {1, 3, 3, 9, 10},
     {1, 1, 7, 7, 10}}};

/// The numbers in another order and with other signs, divided by the last one.
template <std::size_t N>
std::string shuffled(std::array<int, N> numbers, Random& random) {
    constexpr int kCount = static_cast<int>(N) - 1;
    std::string text = "[";
    for (int k = 0; k < kCount; ++k) {
        std::swap(
            numbers[static_cast<std::size_t>(k)],
            numbers[static_cast<std::size_t>(k + random.below(kCount - k))]);
        const double size = static_cast<double>(numbers[static_cast<std::size_t>(k)]) / numbers[N - 1];
        text += (k > 0 ? ", " : "") + writing::number_text(random.below(2) == 0 ? size : -size);
    }
    return text + "]";
}

std::string drawn_number(const Draw& draw, Random& random) {
    const int steps = static_cast<int>(std::floor((draw.to - draw.from) / draw.step + 1e-9));
    const double value = draw.from + draw.step * random.below(steps + 1);
    // rounded, so that 0.1 + 2 · 0.1 is 0.3
    return writing::number_text(std::round(value * 1e9) / 1e9);
}

std::string drawn_numbers(const Draw& draw, Random& random) {
    if (draw.count == 1) { return drawn_number(draw, random); }
    for (;;) {
        std::string text = "[";
        bool all_zero = true;
        for (int k = 0; k < draw.count; ++k) {
            const std::string number = drawn_number(draw, random);
            all_zero = all_zero && number == "0";
            text += (k > 0 ? ", " : "") + number;
        }
        if (!all_zero) { return text + "]"; }
    }
}

std::string drawn_value(const Draw& draw, Random& random) {
    switch (draw.kind) {
        case Draw::Kind::values:
            return draw.values[static_cast<std::size_t>(random.below(static_cast<int>(draw.values.size())))];
        case Draw::Kind::numbers: return drawn_numbers(draw, random);
        case Draw::Kind::direction:
            return shuffled(
                kDirections[static_cast<std::size_t>(random.below(static_cast<int>(kDirections.size())))],
                random);
        case Draw::Kind::euler_parameters: break;
    }
    return shuffled(
        kParameters[static_cast<std::size_t>(random.below(static_cast<int>(kParameters.size())))], random);
}

std::vector<SceneEdit> drawn_edits(const Exercise& exercise, Random& random) {
    std::vector<SceneEdit> edits;
    for (const Draw& draw : exercise.vary) {
        const std::string value = drawn_value(draw, random);
        for (const std::string& key : draw.keys) { edits.push_back({key, value}); }
    }
    return edits;
}

/// The claims of the variant's lesson.
std::string claims_of(const Exercise& exercise, const std::string& scene) {
    if (!exercise.asked.empty()) { return exercise.asked; }
    if (!exercise.expect.empty()) { return exercise.expect; }
    return is_judged_by_claims(exercise.kind) ? claims_in(scene) : std::string();
}

}  // namespace

VariantDraw drawn_variant(
    const Exercise& exercise, std::uint64_t seed, std::shared_ptr<const FormulaPlan> plan) {
    Variant variant;
    variant.exercise = &exercise;
    variant.seed = seed;
    variant.plan = std::move(plan);
    if (exercise.scene.empty()) { return {std::move(variant), {}}; }
    Random random(seed);
    EditedScene edited = with_edits(exercise.scene, drawn_edits(exercise, random));
    if (!edited.problem.empty()) { return {std::nullopt, edited.problem}; }
    variant.scene = std::move(edited.text);
    const std::string built =
        exercise.kind == ExerciseKind::build ? variant.scene + "\n" + exercise.solution : variant.scene;
    ReadResult read =
        read_lesson_with_claims(built, exercise.scene_name, claims_of(exercise, exercise.scene));
    if (!read.lesson) {
        return {std::nullopt, "a drawn scene is not a lesson: " + read.diagnostics.front().message};
    }
    variant.lesson = std::move(*read.lesson);
    return {std::move(variant), {}};
}

}  // namespace jw
