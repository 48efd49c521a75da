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

/// What a symbol is a part of: this is lit when it is pointed at.
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
    std::string frame;   ///< whose components these are; empty where it has none
    SymbolPart part;
};

struct SymbolView {
    std::string scope;   ///< empty: of the texts; else the joint and the primitive of a formula, see scope_of
    std::string source;  ///< see formula::TextSymbol
    std::string what;    ///< "axis vector of the joint"
    std::string unit;    ///< may be empty
    std::string defined;                  ///< "slide 12"
    std::vector<SymbolMeaning> meanings;  ///< at least one; more where it is not said whose it is
    int more = 0;                         ///< meanings that are left out, of many bodies or joints
};

/// What the symbols of a step may be about.
struct SymbolSubject {
    std::vector<int> joints;  ///< of the step; empty: none
    int body = -1;            ///< of a driver without joint; -1: none
};

/// A symbol of a text at the step; nothing if it stands for nothing there.
///
/// Whose it is: a body that its index names; else the joint of the step, once for each of its primitives
/// where they differ; else the moving body of that joint; else the whole system. Without a joint all moving
/// bodies and all joints present can be meant.
std::optional<SymbolView> symbol_view_of(
    const Step& step, CoordinateChoice coordinates, const SymbolSubject& subject,
    const formula::TextSymbol& symbol);

/// The same within the formula of a primitive of a joint, where Φ is its own.
std::optional<SymbolView> symbol_view_of(
    const Step& step, int joint, Role role, const formula::TextSymbol& symbol);

/// Scope of the formula of a group of equations.
std::string scope_of(const EquationGroup& group);

/// All symbols of texts and of the formulas of equations that stand for something, each once.
std::vector<SymbolView> symbols_of(
    const Step& step, CoordinateChoice coordinates, const SymbolSubject& subject,
    const std::vector<std::string>& texts, const std::vector<EquationGroup>& equations);

/// Place in the list; -1 if it is not there.
int index_of_symbol(const std::vector<SymbolView>& symbols, std::string_view scope, std::string_view source);

}  // namespace jw
