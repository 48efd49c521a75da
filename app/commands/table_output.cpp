#include "app/commands/table_output.hpp"

#include <charconv>

namespace jw {

std::string exact(double value) {
    char text[32];
    const auto result = std::to_chars(text, text + sizeof text, value);
    return {text, result.ptr};
}

std::string csv_field(const std::string& name) {
    if (name.find_first_of(",\"\n") == std::string::npos) { return name; }
    std::string quoted = "\"";
    for (const char c : name) { quoted += c == '"' ? std::string("\"\"") : std::string(1, c); }
    return quoted + '"';
}

void write_csv(
    const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows,
    std::ostream& out) {
    for (std::size_t k = 0; k < columns.size(); ++k) { out << (k > 0 ? "," : "") << csv_field(columns[k]); }
    out << '\n';
    for (const std::vector<double>& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k) { out << (k > 0 ? "," : "") << exact(row[k]); }
        out << '\n';
    }
}

}  // namespace jw
