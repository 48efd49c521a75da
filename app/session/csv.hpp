#pragma once

#include <string>

/// Cells of comma-separated tables after RFC 4180.
namespace jw {

/// Quoted where needed.
std::string csv_cell(const std::string& text);

/// Shortest form that reads back as the same double; empty for NaN.
std::string csv_number(double value);

}  // namespace jw
