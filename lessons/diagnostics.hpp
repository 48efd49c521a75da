#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/source_span.hpp"

/// What is wrong with a lesson file: where, what, what was expected and what to do.
namespace jw {

struct Diagnostic {
    std::string file;
    SourceSpan span;
    std::string message;  ///< what is wrong; what was expected
    std::string hint;     ///< what to do, may be empty
};

/// Compiler style, with the line of `source` underlined:
///
///   four-bar.toml:29:12: error: unknown body 'couper'; expected one of ground, crank, coupler
///     bodies = ["couper", "rocker"]
///               ^~~~~~~~
///     hint: did you mean 'coupler'?
std::string to_string(const Diagnostic& diagnostic, std::string_view source);

/// "did you mean 'x'?" for the nearest of `names`, empty if none is near.
std::string did_you_mean(std::string_view text, std::span<const std::string> names);

/// "a, b, c".
std::string comma_list(std::span<const std::string> names);

}  // namespace jw
