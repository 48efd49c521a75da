#include "app/session/view/symbol_facts.hpp"

#include <array>
#include <string_view>

#include "app/session/wording/messages.hpp"

namespace jw {

namespace {

constexpr std::array kFacts{
    SymbolFact{"r", "", tr_later("origin of the body"), "m", "slide 12"},
    SymbolFact{"r", nullptr, tr_later("attachment point of the joint"), "m", "slide 6"},
    SymbolFact{"p", "", tr_later("Euler parameters of the body"), "", "slide 12"},
    SymbolFact{"e", "", tr_later("Euler parameters of the body"), "", "slide 12"},
    SymbolFact{"A", "", tr_later("rotation matrix of the body"), "", "slide 12"},
    SymbolFact{"G", "", tr_later("matrix of the Euler parameters"), "", "slide 13"},
    SymbolFact{"L", "", tr_later("matrix of the Euler parameters"), "", "slide 13"},
    SymbolFact{"ω", "", tr_later("angular velocity of the body"), "rad/s", "slide 13"},
    SymbolFact{"s", "", tr_later("axis vector of the joint"), "", "slide 2"},
    SymbolFact{"s", nullptr, tr_later("from the origin of the body to the attachment point"), "m", "slide 6"},
    SymbolFact{"h", "", tr_later("side vector of the joint"), "", "slide 10"},
    SymbolFact{"u", "", tr_later("zero of the angle of the joint"), "", "slide 11"},
    SymbolFact{"d", "", tr_later("vector between the attachment points"), "m", "slide 2"},
    SymbolFact{"α", "", tr_later("advance of the screw per radian"), "m/rad", "slide 11"},
    SymbolFact{"θ", "", tr_later("angle of the joint"), "rad", "slide 11"},
    SymbolFact{"m", "", tr_later("mass of the body"), "kg", "slide 24"},
    SymbolFact{"J", "", tr_later("inertia of the body"), "kg m²", "slide 24"},
    SymbolFact{"f", "", tr_later("force on the body"), "N", "slide 24"},
    SymbolFact{"n", "", tr_later("torque on the body"), "N m", "slide 24"},
    SymbolFact{"Φ", nullptr, tr_later("left sides of the constraint equations"), "", "slide 2"},
    SymbolFact{"γ", nullptr, tr_later("right sides of the acceleration equations"), "", "slide 19"},
    SymbolFact{"q", "", tr_later("coordinates of the moving bodies"), "", "slide 18"},
    SymbolFact{"t", "", tr_later("time"), "s", ""},
    SymbolFact{"λ", "", tr_later("Lagrange multipliers"), "", "slide 24"},
    SymbolFact{"M", "", tr_later("mass matrix"), "", "slide 24"},
    SymbolFact{"Q", "", tr_later("applied forces"), "", "slide 24"},
};

}  // namespace

const SymbolFact* fact_of(const formula::Symbol& symbol) {
    for (const SymbolFact& fact : kFacts) {
        if (symbol.letter == fact.letter && (fact.marks == nullptr || symbol.marks == fact.marks)) {
            return &fact;
        }
    }
    return nullptr;
}

std::string unit_of_rate(const std::string& unit, int dots) {
    if (dots == 0) { return unit; }
    if (unit.ends_with("/s")) { return unit + (dots == 1 ? "²" : "³"); }
    const std::string per = dots == 1 ? "s" : "s²";
    return (unit.empty() ? "1" : unit) + "/" + per;
}

}  // namespace jw
