#pragma once

#include <string>
#include <vector>

#include "app/host/ui/ui.hpp"
#include "core/numerics/linear.hpp"

struct ImFont;

/// Pieces of the tab of exercises: words with formulas, matrices, fields.
namespace jw::host {

/// Words with formulas between dollar signs, wrapped; a formula that is too wide alone can be scrolled.
void rich_words(const Ui& ui, const std::string& text, const ImFont* font, const render::Colour& colour);

/// A matrix in brackets whose marked entries stand out.
void marked_matrix(const Ui& ui, const MatrixX& value, const std::vector<std::vector<bool>>& marked);

/// Place in a field for the letters that are typed next.
enum class Caret {
    stays,
    at_end,
    over_all,  ///< they replace the text
};

/// A field for text of any length; what was typed stays when Escape leaves it.
/// @param lines  1: Enter enters; more: so high. @param enter  Enter enters there as well, Ctrl+Enter breaks
/// a
///               line; else the other way round
/// @return true if the text was entered
bool text_field(
    const Ui& ui, const char* id, const char* hint, std::string& text, int lines = 1, bool enter = true,
    Caret caret = Caret::stays);

/// Lines of text as they stand, in a box that scrolls both ways.
void text_box(const Ui& ui, const char* id, const std::string& text, int most_lines);

/// Puts the next button beside the last item if it fits there; else it begins a line.
void next_button(const char* label);

}  // namespace jw::host
