#pragma once

#include <string>
#include <vector>

#include "app/host/ui/ui.hpp"
#include "core/numerics/linear.hpp"

struct ImFont;

/// Parts of the tab of exercises: text with formulas, matrices, fields.
namespace jw::host {

/// Wrapped text with formulas between dollar signs. A formula that is wider than the column can be scrolled.
void rich_words(const Ui& ui, const std::string& text, const ImFont* font, const render::Colour& colour);

/// A matrix in brackets whose marked entries are highlighted.
void marked_matrix(const Ui& ui, const MatrixX& value, const std::vector<std::vector<bool>>& marked);

/// Place in a field for the letters that are typed next.
enum class Caret {
    stays,
    at_end,
    over_all,  ///< they replace the text
};

/// A field for text of any length. Escape leaves the field and keeps the text.
/// @param lines  height; in a field of 1 line, Enter enters the text
/// @param enter  in a higher field: true if Enter enters the text and Ctrl+Enter breaks the line, false if
///               the other way round
/// @return true if the text was entered
bool text_field(
    const Ui& ui, const char* id, const char* hint, std::string& text, int lines = 1, bool enter = true,
    Caret caret = Caret::stays);

/// Lines of text without wrapping, in a box that scrolls in both directions.
void text_box(const Ui& ui, const char* id, const std::string& text, int most_lines);

/// Puts the next button beside the last item if it fits there; else on a new line.
void next_button(const char* label);

}  // namespace jw::host
