#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/exercises/alter.hpp"

/// Mistakes that students make, each as a function of the right formula.
namespace jw {

/// A mistake is an entry of kFormulaMistakes: what it makes of the right formula.
struct FormulaMistake {
    const char* name;   ///< in exercise files and reports: "local-for-global"
    const char* title;  ///< "a vector in the frame of the body"
    const char* says;   ///< feedback; {} is the thing in the formula
    const char* slide;  ///< where it is explained, may be empty
    std::vector<Altered> (*alter)(const math::Row& right);
};
std::span<const FormulaMistake> formula_mistakes();

/// A mistake in a value, whatever its formula.
struct ValueMistake {
    const char* name;
    const char* title;
    const char* says;
    const char* slide;
};
/// Names of all mistakes, of formulas and of values.
std::vector<std::string> mistake_names();

}  // namespace jw
