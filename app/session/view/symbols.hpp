#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/story/story.hpp"
#include "app/session/view/view_equations.hpp"
#include "lessons/formula/text_symbols.hpp"

/// What the symbols of a step's texts and formulas stand for, with their values at the step.
namespace jw {

/// The part that a symbol belongs to; it is highlighted when the symbol is pointed at.
struct SymbolPart {
    enum class Kind {
        vector,  ///< of `joint`, in body i, in body j or between them
        rows,    ///< of `joint`, of its primitive `role` or of all; joint -1: of the whole system
        body,
        none,  ///< nothing that is drawn: time
    };
    Kind kind = Kind::body;
    int joint = -1;
    int body = -1;
    int vector = 0;  ///< 0 of body i, 1 of body j, 2 d
    std::optional<Role> role;

    bool operator==(const SymbolPart&) const = default;
};

/// A symbol of one joint, one body or the whole system.
struct SymbolMeaning {
    std::string owner;   ///< "hinge", "hinge · p1", "crank"; empty: the whole system
    std::string source;  ///< the symbol there, with its index: "\boldsymbol{s}_i"
    MatrixX value;       ///< SI
    std::string frame;   ///< frame of the components; empty if there is none
    SymbolPart part;
};

struct SymbolView {
    std::string scope;   ///< empty: of the texts; else the joint and the primitive of a formula, see scope_of
    std::string source;  ///< see formula::TextSymbol
    std::string what;    ///< "axis vector of the joint"
    std::string unit;    ///< may be empty
    std::string defined;                  ///< "slide 12"
    std::vector<SymbolMeaning> meanings;  ///< at least one; more if the owner is not given
    int more = 0;                         ///< number of meanings left out, of many bodies or joints
};

/// What the symbols of a step may refer to.
struct SymbolSubject {
    std::vector<int> joints;  ///< of the step; empty: none
    int body = -1;            ///< of a driver without joint; -1: none
};

/// Scope of the formula of a group of equations.
std::string scope_of(const EquationGroup& group);

/// All symbols of texts and of the formulas of equations that stand for something, each once.
std::vector<SymbolView> symbols_of(
    const Step& step, CoordinateChoice coordinates, const SymbolSubject& subject,
    const std::vector<std::string>& texts, const std::vector<EquationGroup>& equations);

/// Index in the list; -1 if the symbol is not there.
int index_of_symbol(const std::vector<SymbolView>& symbols, std::string_view scope, std::string_view source);

}  // namespace jw
