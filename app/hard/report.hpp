#pragma once

#include <string>

#include "app/hard/hard_case.hpp"

/// Hard cases in words and numbers.
namespace jw::hard {

/// For a terminal.
std::string text_of(const Case& hard_case, const Result& result);

/// A section of docs/hard-cases.md. Numbers with two digits: what is rounding differs between machines.
std::string markdown_of(const Case& hard_case, const Result& result);

/// What docs/hard-cases.md begins with.
std::string markdown_head();

}  // namespace jw::hard
