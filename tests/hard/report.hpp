#pragma once

#include <string>

#include "tests/hard/hard_case.hpp"

/// Hard cases in words and numbers.
namespace jw::hard {

/// Text of a case and its result for a terminal.
std::string text_of(const Case& hard_case, const Result& result);

/// A section of docs/hard-cases.md. Numbers have two digits; those that are only rounding differ by machine.
std::string markdown_of(const Case& hard_case, const Result& result);

/// Introduction of docs/hard-cases.md.
std::string markdown_head();

}  // namespace jw::hard
