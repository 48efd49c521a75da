#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Tables as text: for a terminal, and in Markdown.
namespace jw {

struct TextColumn {
    bool right = true;  ///< its cells are aligned on the right; else on the left
    int least = 0;      ///< least width in displayed characters; the widest cell may need more
    int gap = 2;        ///< spaces before it
};

using TextRows = std::vector<std::vector<std::string>>;

/// `count` columns, two spaces apart, after `indent` spaces. The first and the last have words, and are
/// aligned on the left.
std::vector<TextColumn> columns_of_numbers(std::size_t count, int indent);

/// A line for every row, without blanks at its end. A row may have fewer cells than there are columns.
/// @throws std::invalid_argument for a row with more
std::string text_table(const TextRows& rows, const std::vector<TextColumn>& columns);

/// `value` as printf writes it; "-" where it is undefined.
std::string number_cell(const char* format, double value);

/// `text` as a cell of a table in Markdown, where an unescaped bar would begin the next cell.
std::string markdown_cell(const std::string& text);

}  // namespace jw
