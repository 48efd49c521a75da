#pragma once

#include <string>
#include <vector>

#include "app/exercises/variant.hpp"
#include "core/numerics/linear.hpp"
#include "core/quantity/evaluate.hpp"

/// What is asked in a variant: the right answer and the answers of known mistakes, all computed.
namespace jw {

/// A mistake with the answer that it leads to.
struct KnownMistake {
    std::string name;  ///< "local-for-global"
    /// "body components used for global ones"; several if other mistakes give the same answer
    std::vector<Message> titles;
    Message says;       ///< feedback, one or two sentences
    std::string slide;  ///< in English, may be empty
    MatrixX answer;
    std::string shown;  ///< of a formula: the mistaken formula in LaTeX
};
/// Title of a mistake in the language of the reader: "wrong sign or a term is missing".
std::string title_of(const KnownMistake& mistake);

/// A symbol whose value is given.
struct GivenSymbol {
    std::string latex;
    MatrixX value;
};

struct Asked {
    MatrixX right;
    double tolerance = 0.0;  ///< of each entry
    double turn = 0.0;       ///< answers that differ by this turn are equal; 0: no such turn
    std::string unit;
    bool sign_of_p = false;  ///< the last four entries may have the opposite sign
    std::vector<GivenSymbol> given;
    std::vector<KnownMistake> mistakes;  ///< some of them may give the same answer
    std::string latex;                   ///< of the right formula, empty if there is none
    double condition = 1.0;              ///< largest / smallest singular value that is not zero, at the pose
    std::string problem;                 ///< why there is no right answer; empty if there is one
};

/// Answer to an exercise that asks for a number, vector, matrix, pose, or choice of a formula or component.
Asked asked_in(const Variant& variant);

/// Answers of two mistakes at once in the terms of a formula. There are many of them: they do not count as
/// known mistakes, and may give equal answers.
std::vector<KnownMistake> mistakes_in_two_terms(const Variant& variant);

/// Whether the answers of known mistakes are computed, of which there are many.
enum class KnownMistakes { answered, left_out };

/// Right answer and answers of known mistakes of a formula, at any instant of the scene's mechanism.
Asked asked_at(const Variant& variant, const Instant& instant, KnownMistakes mistakes);

/// " m": the unit behind a number; empty if it has none.
std::string unit_behind(const Asked& asked);

/// Largest difference of an entry from `right`, with turns and the sign of p taken into account; infinity if
/// the shapes differ.
double difference_from(const MatrixX& right, const MatrixX& other, const Asked& asked);

}  // namespace jw
