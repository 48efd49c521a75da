#pragma once

#include <string>
#include <vector>

/// Cells of comma-separated tables after RFC 4180.
namespace jw {

/// Text of a cell, quoted where needed.
std::string csv_cell(const std::string& text);

/// Shortest form that reads back as the same double; empty for NaN.
std::string csv_number(double value);

/// Table with a header and one line per row; each line ends with a line feed.
std::string csv_of(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows);

}  // namespace jw
