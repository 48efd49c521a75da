#include "app/session/wording/text_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "app/session/wording/text_width.hpp"

namespace jw {

namespace {

std::vector<int> widths_of(const TextRows& rows, const std::vector<TextColumn>& columns) {
    std::vector<int> widths;
    for (const TextColumn& column : columns) { widths.push_back(column.least); }
    for (const auto& row : rows) {
        if (row.size() > columns.size()) {
            throw std::invalid_argument(
                "a row of " + std::to_string(row.size()) + " cells in a table of " +
                std::to_string(columns.size()) + " columns");
        }
        for (std::size_t k = 0; k < row.size(); ++k) {
            widths[k] = std::max(widths[k], displayed_width(row[k]));
        }
    }
    return widths;
}

}  // namespace

std::vector<TextColumn> columns_of_numbers(std::size_t count, int indent) {
    std::vector<TextColumn> columns(count);
    columns.front() = {false, 0, indent};
    columns.back().right = false;
    return columns;
}

std::string text_table(const TextRows& rows, const std::vector<TextColumn>& columns) {
    const std::vector<int> widths = widths_of(rows, columns);
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k) {
            line += std::string(static_cast<std::size_t>(columns[k].gap), ' ') +
                    padded(row[k], widths[k], columns[k].right);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

std::string number_cell(const char* format, double value) {
    if (std::isnan(value)) { return "-"; }
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string markdown_cell(const std::string& text) {
    std::string cell;
    for (const char c : text) {
        if (c == '|') { cell += '\\'; }
        cell += c;
    }
    return cell;
}

}  // namespace jw
