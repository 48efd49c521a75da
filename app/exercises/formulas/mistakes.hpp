#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "app/exercises/formulas/alterations.hpp"
#include "lessons/lesson/claims.hpp"
#include "lessons/text/text.hpp"

/// Mistakes that students make, each as a function of the right formula.
namespace jw {

/// A mistake is an entry of kFormulaMistakes; `alter` makes the mistaken formulas from the right one.
struct FormulaMistake {
    const char* name;   ///< in exercise files and reports: "local-for-global"
    const char* title;  ///< message: "body components used for global ones"
    const char* says;   ///< message, the feedback; {0} is the changed part of the formula
    const char* slide;  ///< where it is explained, may be empty
    std::vector<Altered> (*alter)(const math::Row& right);
    /// feedback if a whole definition is mistaken; {0} is the symbol that it defines; null: `says` fits
    const char* of_definition = nullptr;
};
std::span<const FormulaMistake> formula_mistakes();

/// Two terms of a formula that are missing or have the wrong sign: tried if no single mistake fits.
inline constexpr const char* kTwoTermsName = "two-terms";

/// A mistake in a value, whatever the formula: an entry of kValueMistakes.
struct ValueMistake {
    const char* name;
    const char* title;  ///< message
    const char* says;   ///< message; {0} is the unit that is asked for
    const char* slide;  ///< may be empty
};

inline constexpr ValueMistake kOppositeSign{
    "sign", tr_later("wrong sign"), tr_later("This is the right answer with the opposite sign."), ""};
inline constexpr ValueMistake kMixedUnits{
    "degrees", tr_later("degrees and radians mixed up"),
    tr_later("This answer mixes up degrees and radians; it must be in {0}."), ""};
inline constexpr ValueMistake kFullTurn{
    "two-pi", tr_later("off by a turn"), tr_later("This is off by a full turn: this angle counts turns."),
    "slide 11"};
inline constexpr ValueMistake kOtherBranch{
    "branch", tr_later("the other branch"),
    tr_later("The answer belongs to the other branch, in which the same joints are assembled differently."),
    "slide 23"};
inline constexpr ValueMistake kWrongTwo{
    "wrong-two", tr_later("the wrong two of three"),
    tr_later("The rule leaves out the equation of the largest global component of s_i, not this one. The two "
             "equations kept here become dependent sooner."),
    "slide 5"};
inline constexpr std::array kValueMistakes{kOppositeSign, kMixedUnits, kFullTurn, kOtherBranch, kWrongTwo};

/// Another count at the same pose in place of the one that is asked for.
struct CountMistake {
    Count count;
    ValueMistake mistake;
};
inline constexpr std::array kCountMistakes{
    CountMistake{
        Count::rows,
        {"rows", tr_later("equations counted"),
         tr_later("This is the number of equations; not all of them need be independent."), "slide 5"}},
    CountMistake{
        Count::rank,
        {"rank", tr_later("the rank"), tr_later("This is the rank: the number of independent equations."),
         "slide 5"}},
    CountMistake{
        Count::dof,
        {"dof", tr_later("the freedoms"), tr_later("This is the number of freedoms: columns minus rank."),
         ""}},
    CountMistake{
        Count::redundant,
        {"redundant", tr_later("the redundant equations"),
         tr_later("This is the number of equations that are not independent."), "slide 5"}},
    CountMistake{
        Count::columns,
        {"columns", tr_later("the columns"),
         tr_later("This is the number of columns: six for each moving body."), ""}},
    CountMistake{
        Count::mobility_by_counting,
        {"counting", tr_later("Grübler's count"),
         tr_later("This is Grübler's count: it counts every equation of the joints as independent."), ""}}};

/// Names of all mistakes that an exercise can look for: in formulas, values and counts.
std::vector<std::string> mistake_names();

}  // namespace jw
