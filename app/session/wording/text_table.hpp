#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Tables as text: for a terminal, and in Markdown.
namespace jw {

struct TextColumn {
    bool right = true;  ///< its cells end at the same place; else they begin there
    int least = 0;      ///< width in characters as seen; the widest cell may need more
    int gap = 2;        ///< spaces before it
};

using TextRows = std::vector<std::vector<std::string>>;

/// `count` columns of which the first and the last have words and begin at the left, two spaces apart, behind
/// `indent` spaces.
std::vector<TextColumn> columns_of_numbers(std::size_t count, int indent);

/// A line for every row, without blanks at its end. A row may have fewer cells than there are columns.
/// @throws std::invalid_argument for a row with more
std::string text_table(const TextRows& rows, const std::vector<TextColumn>& columns);

/// `value` as printf writes it; "-" where it is undefined.
std::string number_cell(const char* format, double value);

/// `text` as a cell of a table in Markdown, where a bar would begin the next one.
std::string markdown_cell(const std::string& text);

}  // namespace jw
