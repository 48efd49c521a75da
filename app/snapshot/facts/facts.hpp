#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"

/// Facts: named texts and numbers that a step shows, the first layer of a snapshot. They need no pixels, so a
/// change is named instead of seen.
namespace jw::snapshot {

/// How much it matters when a fact changes; reports begin with the first.
enum class Weight {
    failure,
    rank,      ///< rank, freedoms, redundant rows
    count,     ///< numbers of equations, iterations, things drawn
    pose,      ///< of bodies, and their shapes
    text,      ///< titles, sentences, formulas
    quantity,  ///< measured numbers, forces, energies
    detail,    ///< residuals, single values, entries of the matrix, places of vectors and names
};

struct Fact {
    Weight weight = Weight::detail;
    std::string name;             ///< "crank · r · x"
    std::string text;             ///< of a fact that is not a number; numbers in it are compared as numbers
    std::optional<double> value;  ///< of a number
    std::string unit;             ///< as shown, may be empty
    /// How much a number may change. The scale of a quantity is the largest value that any number of its unit
    /// has in the lesson; see `set_tolerances`. Counts must be equal: 0.
    double tolerance = 0.0;

    bool operator==(const Fact&) const = default;
};

/// Names of the facts of "step 3 of 24", which every picture shows.
inline constexpr const char* kStepFact = "step";
inline constexpr const char* kStepsFact = "steps";

/// Facts about everything that a view tells.
std::vector<Fact> facts_of(const View& view);
/// Facts about everything drawn in 3D: bodies with their shapes, vectors, frames, lines, names.
std::vector<Fact> facts_of(const Picture& picture, const Mechanism& mechanism);

/// Facts about the lesson itself: its title; masses, gravity, forces, torques and springs if it has dynamics.
std::vector<Fact> facts_of(const Lesson& lesson);

/// Unit of the coefficient of t^power in a function of time with this unit: "N", "N/s", "N/s^2".
std::string unit_of_coefficient(const std::string& unit, std::size_t power);

/// Facts about the camera. Another camera changes every pixel, but is mostly the result of something else,
/// such as a longer body: these facts stand after all others.
std::vector<Fact> facts_of(const render::Camera& camera);

/// A number with as many decimals as its tolerance justifies: "0.25", "-1.732051".
std::string short_decimal(const Fact& fact);

/// Natural sizes of a lesson, with which its numbers are compared.
struct NaturalScale {
    double length = 1.0;    ///< size of the mechanism [m]
    double duration = 1.0;  ///< of the motion [s]; 1 where nothing moves
};

/// Gives every number of a lesson's snapshots its tolerance and rounds it to a tenth of that, so that a file
/// of facts does not change by rounding. A number may be off by one millionth of the largest number of its
/// unit in the lesson: panels show at most six digits, and differences in rounding between libraries of
/// different machines are much smaller. If all numbers of a unit are small, their scale is a thousandth of
/// the natural value, which follows from length and duration.
void set_tolerances(std::vector<std::vector<Fact>*> facts, const NaturalScale& natural);

}  // namespace jw::snapshot
