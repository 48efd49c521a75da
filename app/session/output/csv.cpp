#include "app/session/output/csv.hpp"

#include <charconv>
#include <cmath>

#include "app/session/view/series.hpp"

namespace jw {

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) { return text; }
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') { quoted += '"'; }
        quoted += c;
    }
    return quoted + '"';
}

std::string csv_number(double value) {
    if (std::isnan(value)) { return {}; }
    char digits[32];
    const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), value);
    return {std::begin(digits), end};
}

std::string csv_of(const std::vector<std::string>& columns, const std::vector<std::vector<double>>& rows) {
    std::string text;
    const auto add_line = [&](const auto& cells, const auto& cell) {
        for (std::size_t k = 0; k < cells.size(); ++k) { text += (k > 0 ? "," : "") + cell(cells[k]); }
        text += '\n';
    };
    add_line(columns, csv_cell);
    for (const std::vector<double>& row : rows) { add_line(row, csv_number); }
    return text;
}

std::string csv_of(const SeriesSet& set) {
    std::string text = csv_cell(set.axis);
    for (const Series& s : set.series) {
        text += ',' + csv_cell(s.unit == "-" ? s.name : s.name + " [" + s.unit + "]");
    }
    text += '\n';
    for (std::size_t k = 0; k < set.at.size(); ++k) {
        text += csv_number(set.at[k]);
        for (const Series& s : set.series) { text += ',' + csv_number(s.values[k]); }
        text += '\n';
    }
    return text;
}

}  // namespace jw
