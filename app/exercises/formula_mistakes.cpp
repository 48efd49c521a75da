#include <algorithm>
#include <array>

#include "app/exercises/alterations.hpp"
#include "app/exercises/mistakes.hpp"

namespace jw {

namespace {

constexpr std::array kFormulaMistakes{
    FormulaMistake{
        "sign", "wrong sign", "This is the right answer with the opposite sign.", "", alterations::wrong_sign,
        "{} has the opposite sign."},
    FormulaMistake{
        "term-sign", "wrong sign of a term", "The term {} has the wrong sign.", "",
        alterations::sign_of_term},
    FormulaMistake{
        "term-dropped", "a term is missing", "The term {} is missing.", "", alterations::dropped_term},
    FormulaMistake{
        "bodies-exchanged", "i and j exchanged",
        "The bodies i and j are exchanged: d points from i to j, and s_i belongs to body i.", "slide 2",
        alterations::exchanged_bodies},
    FormulaMistake{
        "wrong-body", "a symbol of the other body",
        "{} was taken from the other body: mind the index i or j.", "slide 2", alterations::wrong_body},
    FormulaMistake{
        "local-for-global", "components of the body for global ones",
        "{} is needed in the global frame; you have used its components in the frame of the body: s = A s′.",
        "slide 2", alterations::local_for_global},
    FormulaMistake{
        "global-for-local", "global components for those of the body",
        "{} is needed in the frame of the body; you have used its global components: s′ = Aᵀ s.", "slide 2",
        alterations::global_for_local},
    FormulaMistake{
        "matrix-forgotten", "rotation matrix forgotten", "The rotation matrix {} is missing.", "slide 3",
        alterations::forgotten_matrix},
    FormulaMistake{
        "matrix-transposed", "a matrix transposed",
        "{} is transposed: A turns components of the body into global ones, Aᵀ the other way.", "slide 3",
        alterations::transposed_matrix},
    FormulaMistake{
        "transposed", "the answer transposed", "This is the transpose of the right answer.", "",
        alterations::transposed, "{} is transposed."},
    FormulaMistake{
        "frame", "components in the other frame",
        "These are the components of the right vector in the other one of the frames: of the body and "
        "global.",
        "slide 3", alterations::other_frame, "{} has the components of the other frame."},
    FormulaMistake{
        "g-for-l", "G and L mixed up", "{} is the wrong one of G and L: ω = 2 G ṗ, ω′ = 2 L ṗ.", "slide 13",
        alterations::g_for_l},
    FormulaMistake{
        "factor", "a factor is lost", "The factor {} of the formula is lost.", "", alterations::lost_factor},
    FormulaMistake{"square", "a square is lost", "{} has lost its square.", "", alterations::lost_square},
    FormulaMistake{
        "dot", "a dot is lost", "{} has lost its dot: the derivative is needed, not the vector.",
        "slides 14-17", alterations::lost_dot},
    FormulaMistake{
        "tilde", "a tilde is lost", "{} has lost its tilde: it has to be the skew matrix.", "slide 3",
        alterations::lost_tilde},
    FormulaMistake{
        "order-of-product", "factors of a vector product exchanged",
        "The factors of the vector product that begins with {} are exchanged: ã b = −b̃ a.", "slide 3",
        alterations::exchanged_factors},
    FormulaMistake{
        "axis-for-point", "the axis used for the point",
        "{} is the vector to the point B; you have used the axis s instead.", "slide 2",
        alterations::other_point},
    FormulaMistake{
        "other-jacobian", "true and modified Jacobian mixed up",
        "This is the other one of the true and the modified Jacobian: they differ by c pᵀ.", "slides 21-22",
        alterations::other_jacobian},
    FormulaMistake{
        "not-normalised", "not normalised", "The division by the length {} is missing.", "",
        alterations::not_normalised},
    FormulaMistake{
        "other-function", "the other function", "{} is the wrong function here.", "slide 5",
        alterations::other_function},
    FormulaMistake{
        "degrees-in-function", "degrees in a function", "The functions take radians, not degrees.", "",
        alterations::degrees_in_function},
    FormulaMistake{
        "inverse", "an inverse is forgotten",
        "{} is missing: this is still the right side of the equations, not what they are solved for.", "",
        alterations::forgotten_inverse},
    FormulaMistake{
        "component", "another component", "Another component was taken in place of {}.", "slide 5",
        alterations::other_component}};

}  // namespace

std::span<const FormulaMistake> formula_mistakes() { return kFormulaMistakes; }

std::vector<std::string> mistake_names() {
    std::vector<std::string> names;
    for (const FormulaMistake& mistake : kFormulaMistakes) { names.emplace_back(mistake.name); }
    for (const ValueMistake& mistake : kValueMistakes) {
        // "sign" is one of formulas, too
        if (std::ranges::find(names, mistake.name) == names.end()) { names.emplace_back(mistake.name); }
    }
    for (const CountMistake& of_count : kCountMistakes) { names.emplace_back(of_count.mistake.name); }
    return names;
}

}  // namespace jw
