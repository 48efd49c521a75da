#pragma once

#include <span>
#include <string_view>

#include "lessons/math/math.hpp"

/// The commands of the notation; docs/mathematics.md lists them, and a test compares both lists.
namespace jw::math {

/// A command that stands for one sign.
struct Symbol {
    std::string_view command;  ///< "\\alpha"
    std::string_view utf8;     ///< "α"
    SignKind kind = SignKind::letter;
};
std::span<const Symbol> symbols();

/// Symbol of a command, or of a character that may be typed directly; nullptr if there is none.
const Symbol* symbol_of_command(std::string_view command);
const Symbol* symbol_of_character(std::string_view utf8);

/// A command that puts something over its argument.
struct AccentCommand {
    std::string_view command;  ///< "\\tilde"
    AccentKind kind = AccentKind::tilde;
    std::string_view combining;  ///< character that stands over the one before it
    std::string_view over;       ///< the same as a separate sign, for MathML
};
std::span<const AccentCommand> accents();
const AccentCommand& accent_of(AccentKind kind);

/// \begin{name} ... \end{name}
struct Environment {
    std::string_view name;  ///< "bmatrix"
    MatrixKind kind = MatrixKind::brackets;
    std::string_view open;  ///< delimiters
    std::string_view close;
};
std::span<const Environment> environments();
const Environment& environment_of(MatrixKind kind);

/// \quad and the like.
struct SpaceCommand {
    std::string_view command;
    double em = 0.0;
};
std::span<const SpaceCommand> spaces();

/// Commands with one argument that choose letters: \mathbf, \boldsymbol, \mathrm.
struct AlphabetCommand {
    std::string_view command;
    Alphabet alphabet = Alphabet::bold;
};
std::span<const AlphabetCommand> alphabets();

/// Delimiters that \left and \right take, as typed and as drawn; "." draws nothing.
struct Delimiter {
    std::string_view typed;
    std::string_view drawn;
};
std::span<const Delimiter> delimiters();

}  // namespace jw::math
