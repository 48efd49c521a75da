#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/diagnostics/codes.hpp"
#include "lessons/diagnostics/text_place.hpp"

/// Diagnostics of a lesson file: where something is wrong, what is wrong, what was expected and what to do.
namespace jw {

/// Largest number of diagnostics that are collected for one file.
inline constexpr std::size_t kMostProblems = 1000;

enum class Severity { error, warning };

struct Diagnostic {
    std::string file;
    SourceSpan span;
    Code code = Code::file_unreadable;  ///< of the cause
    std::string message;                ///< what is wrong; what was expected
    std::string hint;                   ///< what to do, may be empty
    Severity severity = Severity::error;
};

/// Diagnostic in compiler style, with the place underlined in its line of `source`; a very long line is cut
/// around the place. The code stands at the end, so that editors still recognise "FILE:LINE:COLUMN: error: ".
///
///   four-bar.toml:29:12: error: unknown body 'couper'; expected one of ground, crank, coupler [JW301]
///     bodies = ["couper", "rocker"]
///               ^~~~~~~~
///     hint: did you mean 'coupler'?
std::string to_string(const Diagnostic& diagnostic, std::string_view source);

/// "did you mean 'x'?" for the nearest of `names`, empty if none is near.
std::string did_you_mean(std::string_view text, std::span<const std::string> names);

/// "a, b, c": at most 20 names; if there are more, also their number.
std::string comma_list(std::span<const std::string> names);

/// 'text' in quotes, safe to show: long text is cut, control characters are replaced.
std::string in_quotes(std::string_view text);

/// Up to `digits` significant digits: 0.3, 1e+12, -5.
std::string short_number(double value, int digits = 6);

}  // namespace jw
