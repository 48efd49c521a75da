#include "app/session/picture/pointed_thing.hpp"

#include <algorithm>

#include "app/session/answers/right_answer.hpp"
#include "lessons/lesson/things.hpp"

namespace jw {

namespace {

std::optional<Thing> thing_of_symbol(
    const Step& step, const View& view, const Pointable& place, Thing::Kind wanted) {
    const auto k = static_cast<std::size_t>(place.index);
    if (k >= view.symbols.size()) { return std::nullopt; }
    for (const Pointable& link : links_of(view.symbols[k], *step.system)) {
        if (const auto thing = thing_at(step, view, link, wanted)) { return thing; }
    }
    return std::nullopt;
}

/// The thing that a place itself stands for.
std::optional<Thing> thing_of_place(const Step& step, const View& view, const Pointable& place) {
    const Mechanism& mechanism = step.system->mechanism();
    const auto k = static_cast<std::size_t>(place.index);
    switch (place.kind) {
        case Pointable::Kind::body: return Thing::body(place.index);
        case Pointable::Kind::joint: return Thing::joint(place.index);
        case Pointable::Kind::vector: return Thing::vector(place.index, place.part);
        case Pointable::Kind::row: return thing_of_row(*step.system, place.index);
        case Pointable::Kind::column:
            if (k >= view.matrix.columns.size()) { return std::nullopt; }
            return thing_named(mechanism, Thing::Kind::body, view.matrix.columns[k].owner);
        case Pointable::Kind::equation: {
            const Joint& joint = mechanism.joints[k];
            const std::vector<LabelledEquation> all = equations_of(*joint.type, joint.parallel_form);
            const auto number = static_cast<std::size_t>(place.part);
            if (number >= all.size()) { return std::nullopt; }
            return Thing::row(place.index, all[number].equation);
        }
        case Pointable::Kind::symbol:
        case Pointable::Kind::none: break;
    }
    return std::nullopt;
}

/// Place of a joint's row, as an equation of the joint.
Pointable place_of_equation(const Mechanism& mechanism, const Thing& row) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(row.index)];
    const std::vector<LabelledEquation> all = equations_of(*joint.type, joint.parallel_form);
    const auto found = std::ranges::find(all, row.equation, &LabelledEquation::equation);
    return found == all.end() ? Pointable{}
                              : Pointable::equation(row.index, static_cast<int>(found - all.begin()));
}

}  // namespace

Pointable place_of(const Step& step, const Thing& thing) {
    switch (thing.kind) {
        case Thing::Kind::body: return Pointable::body(thing.index);
        case Thing::Kind::joint: return Pointable::joint(thing.index);
        case Thing::Kind::vector: return Pointable::vector(thing.index, thing.part);
        case Thing::Kind::row: break;
    }
    for (int row = 0; row < step.system->rows(); ++row) {
        if (thing_of_row(*step.system, row) == thing) { return Pointable::row(row); }
    }
    return thing.driven ? Pointable{} : place_of_equation(step.system->mechanism(), thing);
}

void light_answer(const Step& step, CoordinateChoice coordinates, const View& view, Emphasis& lit) {
    if (!view.question) { return; }
    for (const Thing& thing : view.question->right) {
        lit.light(*step.system, angular_of(coordinates), place_of(step, thing));
    }
}

std::optional<Thing> thing_at(
    const Step& step, const View& view, const Pointable& place, Thing::Kind wanted) {
    if (place.kind == Pointable::Kind::symbol) { return thing_of_symbol(step, view, place, wanted); }
    const auto thing = thing_of_place(step, view, place);
    if (thing && thing->kind == Thing::Kind::vector && wanted == Thing::Kind::joint) {
        return Thing::joint(thing->index);
    }
    return thing && thing->kind == wanted ? thing : std::nullopt;
}

}  // namespace jw
