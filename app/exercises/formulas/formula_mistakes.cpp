#include <algorithm>
#include <array>

#include "app/exercises/formulas/alterations.hpp"
#include "app/exercises/formulas/mistakes.hpp"
#include "lessons/text/text.hpp"

namespace jw {

namespace {

constexpr std::array kFormulaMistakes{
    FormulaMistake{
        "sign", tr_later("wrong sign"), tr_later("This is the right answer with the opposite sign."), "",
        alterations::wrong_sign, tr_later("{0} has the opposite sign.")},
    FormulaMistake{
        "term-sign", tr_later("wrong sign of a term"), tr_later("The term {0} has the wrong sign."), "",
        alterations::sign_of_term},
    FormulaMistake{
        "term-dropped", tr_later("a term is missing"), tr_later("The term {0} is missing."), "",
        alterations::dropped_term},
    FormulaMistake{
        "bodies-exchanged", tr_later("i and j exchanged"),
        tr_later("The bodies i and j are exchanged: d points from i to j, and s_i belongs to body i."),
        "slide 2", alterations::exchanged_bodies},
    FormulaMistake{
        "wrong-body", tr_later("a symbol of the other body"),
        tr_later("{0} was taken from the other body: check the index i or j."), "slide 2",
        alterations::wrong_body},
    FormulaMistake{
        "local-for-global", tr_later("body components used for global ones"),
        tr_later("{0} is needed in the global frame; you have used its components in the frame of the body: "
                 "s = A s′."),
        "slide 2", alterations::local_for_global},
    FormulaMistake{
        "global-for-local", tr_later("global components used for body ones"),
        tr_later("{0} is needed in the frame of the body; you have used its global components: s′ = Aᵀ s."),
        "slide 2", alterations::global_for_local},
    FormulaMistake{
        "matrix-forgotten", tr_later("rotation matrix forgotten"),
        tr_later("The rotation matrix {0} is missing."), "slide 3", alterations::forgotten_matrix},
    FormulaMistake{
        "matrix-transposed", tr_later("a matrix transposed"),
        tr_later("{0} is transposed: A converts body components into global ones, Aᵀ global into body ones."),
        "slide 3", alterations::transposed_matrix},
    FormulaMistake{
        "transposed", tr_later("the answer transposed"),
        tr_later("This is the transpose of the right answer."), "", alterations::transposed,
        tr_later("{0} is transposed.")},
    FormulaMistake{
        "frame", tr_later("components in the other frame"),
        tr_later("The vector is right, but its components are in the wrong frame: body and global frame are "
                 "mixed up."),
        "slide 3", alterations::other_frame, tr_later("The components of {0} are in the wrong frame.")},
    FormulaMistake{
        "g-for-l", tr_later("G and L mixed up"),
        tr_later("{0} is the wrong one of G and L: ω = 2 G ṗ, ω′ = 2 L ṗ."), "slide 13",
        alterations::g_for_l},
    FormulaMistake{
        "factor", tr_later("a factor is missing"), tr_later("The factor {0} is missing."), "",
        alterations::lost_factor},
    FormulaMistake{
        "square", tr_later("a square is missing"), tr_later("The square of {0} is missing."), "",
        alterations::lost_square},
    FormulaMistake{
        "dot", tr_later("a dot is missing"),
        tr_later("The dot of {0} is missing: the derivative is needed, not the vector."), "slides 14-17",
        alterations::lost_dot},
    FormulaMistake{
        "tilde", tr_later("a tilde is missing"),
        tr_later("The tilde of {0} is missing: it has to be the skew matrix."), "slide 3",
        alterations::lost_tilde},
    FormulaMistake{
        "order-of-product", tr_later("factors of a vector product exchanged"),
        tr_later("The factors of the vector product that begins with {0} are exchanged: ã b = −b̃ a."),
        "slide 3", alterations::exchanged_factors},
    FormulaMistake{
        "axis-for-point", tr_later("the axis used for the point"),
        tr_later("{0} is the vector to the point B; you have used the axis s instead."), "slide 2",
        alterations::other_point},
    FormulaMistake{
        "other-jacobian", tr_later("true and modified Jacobian mixed up"),
        tr_later("The true and the modified Jacobian are mixed up: they differ by c pᵀ."), "slides 21-22",
        alterations::other_jacobian},
    FormulaMistake{
        "not-normalised", tr_later("not normalised"), tr_later("The division by the length {0} is missing."),
        "", alterations::not_normalised},
    FormulaMistake{
        "other-function", tr_later("the other function"), tr_later("{0} is the wrong function here."),
        "slide 5", alterations::other_function},
    FormulaMistake{
        "degrees-in-function", tr_later("degrees in a function"),
        tr_later("The functions take radians, not degrees."), "", alterations::degrees_in_function},
    FormulaMistake{
        "inverse", tr_later("an inverse is forgotten"),
        tr_later("{0} is missing: this is the right side of the equations, not yet their solution."), "",
        alterations::forgotten_inverse},
    FormulaMistake{
        "component", tr_later("another component"), tr_later("Another component was taken in place of {0}."),
        "slide 5", alterations::other_component}};

}  // namespace

std::span<const FormulaMistake> formula_mistakes() { return kFormulaMistakes; }

std::vector<std::string> mistake_names() {
    std::vector<std::string> names;
    for (const FormulaMistake& mistake : kFormulaMistakes) { names.emplace_back(mistake.name); }
    for (const ValueMistake& mistake : kValueMistakes) {
        // "sign" is also a mistake of formulas
        if (std::ranges::find(names, mistake.name) == names.end()) { names.emplace_back(mistake.name); }
    }
    for (const CountMistake& of_count : kCountMistakes) { names.emplace_back(of_count.mistake.name); }
    return names;
}

}  // namespace jw
