#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

/// Mathematics in the texts of a lesson as a tree; read by read_math.hpp, written by write_math.hpp, typeset
/// by the panels, evaluated by lessons/formula. docs/mathematics.md describes the notation.
namespace jw::math {

struct Node;
/// Nodes side by side.
using Row = std::vector<Node>;

enum class SignKind {
    letter,       ///< s, Φ
    number,       ///< 2, 0.5
    operation,    ///< + − × ·
    relation,     ///< = ≡ <
    opening,      ///< (
    closing,      ///< )
    fence,        ///< | ‖: opens and closes
    punctuation,  ///< ,
    function,     ///< sin, det
    large,        ///< ∑ ∫
    ordinary,     ///< ∂ ∞ … ′
};

enum class Alphabet {
    italic,   ///< the default of letters
    bold,     ///< vectors slanted, matrices, capitals and digits upright
    upright,  ///< \mathrm
};

/// A letter, number, operator or the name of a function.
struct Sign {
    std::string utf8;
    SignKind kind = SignKind::letter;
    Alphabet alphabet = Alphabet::italic;

    bool operator==(const Sign&) const = default;
};
/// Words within a formula, set upright with their spaces.
struct Words {
    std::string utf8;

    bool operator==(const Words&) const = default;
};
/// An explicit space.
struct Space {
    double em = 0.0;

    bool operator==(const Space&) const = default;
};
struct Fraction {
    Row above;
    Row below;

    bool operator==(const Fraction&) const;
};
struct Root {
    Row inner;

    bool operator==(const Root&) const;
};
enum class AccentKind { tilde, dot, two_dots, bar, hat, arrow };
struct Accent {
    AccentKind kind = AccentKind::tilde;
    Row inner;

    bool operator==(const Accent&) const;
};
/// Nodes between delimiters that grow with them; a group in braces has empty delimiters.
struct Group {
    std::string open;  ///< "(", "[", "{", "|", "‖" or nothing
    std::string close;
    Row inner;

    bool operator==(const Group&) const;
};
enum class MatrixKind { brackets, parentheses, bars, plain, cases };
struct Matrix {
    MatrixKind kind = MatrixKind::brackets;
    std::vector<std::vector<Row>> rows;  ///< cells; all rows are equally long

    bool operator==(const Matrix&) const;
};

/// A nucleus with its scripts at the lower and upper right.
struct Node {
    std::variant<Sign, Words, Space, Fraction, Root, Accent, Group, Matrix> nucleus;
    Row below;             ///< subscript
    Row above;             ///< superscript; primes first
    std::size_t from = 0;  ///< bytes of the source that it was read from; not compared
    std::size_t to = 0;

    bool operator==(const Node& other) const {
        return nucleus == other.nucleus && below == other.below && above == other.above;
    }
};

inline bool Fraction::operator==(const Fraction&) const = default;
inline bool Root::operator==(const Root&) const = default;
inline bool Accent::operator==(const Accent&) const = default;
inline bool Group::operator==(const Group&) const = default;
inline bool Matrix::operator==(const Matrix&) const = default;

/// True if the node is this sign, in any alphabet and with any scripts.
bool is_sign(const Node& node, const char* utf8);
/// True if the node is a sign of that kind, with any scripts.
bool is_kind(const Node& node, SignKind kind);
/// True if an operation after this node has no left operand: it is the sign of a number, not a difference.
bool precedes_operand(const Node& node);

/// A position in a row of nodes; spaces are skipped.
class RowCursor {
public:
    explicit RowCursor(const Row& row) {
        for (const Node& node : row) {
            if (!std::holds_alternative<Space>(node.nucleus)) { nodes_.push_back(&node); }
        }
    }
    bool at_end() const { return at_ >= nodes_.size(); }
    const Node& peek() const { return *nodes_[at_]; }
    const Node* ahead(std::size_t count) const {
        return at_ + count < nodes_.size() ? nodes_[at_ + count] : nullptr;
    }
    const Node& next() { return *nodes_[at_++]; }
    const Node& last() const { return *nodes_[at_ - 1]; }

private:
    std::vector<const Node*> nodes_;
    std::size_t at_ = 0;
};

}  // namespace jw::math
