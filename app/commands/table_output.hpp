#pragma once

#include <ostream>
#include <string>
#include <vector>

/// Tables of numbers as CSV (RFC 4180) with line feeds.
namespace jw {

/// The shortest text that reads back as the same number.
std::string exact(double value);
/// A name as a field.
std::string csv_field(const std::string& name);
void write_csv(
    const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows, std::ostream& out);

}  // namespace jw
