#include "app/session/picture/pointable.hpp"

#include <algorithm>
#include <iterator>

#include "app/session/answers/right_answer.hpp"
#include "app/session/view/view.hpp"
#include "app/session/wording/labels.hpp"
#include "lessons/lesson/things.hpp"

namespace jw {

namespace {

// lowest digit of a picture id, in base kRadix: the kind of a link that is drawn in 3D
constexpr int kRadix = 8;
constexpr int kBody = 1;
constexpr int kJoint = 2;
constexpr int kVector = 3;  // and the next two numbers, one per part

std::vector<int> rows_of(const System& system, const SymbolPart& part) {
    std::vector<int> rows;
    for (int row = 0; row < system.rows(); ++row) {
        const Constraint* const c = constraint_of(system, row);
        const bool is_meant = c != nullptr && c->joint == part.joint && (!part.role || c->role == *part.role);
        if (part.joint < 0 || is_meant) { rows.push_back(row); }
    }
    return rows;
}

std::optional<Thing> thing_of_symbol(
    const Step& step, const View& view, const Pointable& place, Thing::Kind wanted) {
    const auto k = at(place.index);
    if (k >= view.symbols.size()) { return std::nullopt; }
    for (const Pointable& link : links_of(view.symbols[k], *step.system)) {
        if (const auto thing = thing_at(step, view, link, wanted)) { return thing; }
    }
    return std::nullopt;
}

/// The thing that a place itself stands for.
std::optional<Thing> thing_of_place(const Step& step, const View& view, const Pointable& place) {
    const Mechanism& mechanism = step.system->mechanism();
    const auto k = at(place.index);
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
            const auto number = at(place.part);
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
    const Joint& joint = mechanism.joints[at(row.index)];
    const std::vector<LabelledEquation> all = equations_of(*joint.type, joint.parallel_form);
    const auto found = std::ranges::find(all, row.equation, &LabelledEquation::equation);
    return found == all.end() ? Pointable{}
                              : Pointable::equation(row.index, static_cast<int>(found - all.begin()));
}

}  // namespace

int picture_id(const Pointable& link) {
    switch (link.kind) {
        case Pointable::Kind::body: return (link.index + 1) * kRadix + kBody;
        case Pointable::Kind::joint: return (link.index + 1) * kRadix + kJoint;
        case Pointable::Kind::vector: return (link.index + 1) * kRadix + kVector + link.part;
        case Pointable::Kind::none:
        case Pointable::Kind::symbol:
        case Pointable::Kind::equation:
        case Pointable::Kind::row:
        case Pointable::Kind::column: break;
    }
    return 0;
}

Pointable pointable_of(int id) {
    const int kind = id % kRadix;
    const int index = id / kRadix - 1;
    if (id <= 0 || index < 0) { return {}; }
    if (kind == kBody) { return Pointable::body(index); }
    if (kind == kJoint) { return Pointable::joint(index); }
    if (kind >= kVector && kind <= kVector + Pointable::kVectorD) {
        return Pointable::vector(index, kind - kVector);
    }
    return {};
}

int angular_of(CoordinateChoice choice) {
    return with_choice(choice, [](auto c) { return decltype(c)::kAngular; });
}

std::vector<Pointable> links_of(const SymbolView& symbol, const System& system) {
    std::vector<Pointable> links;
    for (const SymbolMeaning& meaning : symbol.meanings) {
        const SymbolPart& part = meaning.part;
        switch (part.kind) {
            case SymbolPart::Kind::vector: links.push_back(Pointable::vector(part.joint, part.vector)); break;
            case SymbolPart::Kind::body: links.push_back(Pointable::body(part.body)); break;
            case SymbolPart::Kind::rows: {
                const std::vector<int> rows = rows_of(system, part);
                std::ranges::transform(rows, std::back_inserter(links), &Pointable::row);
                break;
            }
            case SymbolPart::Kind::none: break;
        }
    }
    return links;
}

void Emphasis::light(const System& system, int angular, const Pointable& pointed_at) {
    if (!pointed_at) { return; }
    add(pointed_at);
    switch (pointed_at.kind) {
        case Pointable::Kind::row: add_row_and_its_vectors(system, pointed_at.index); break;
        case Pointable::Kind::joint: add_rows_of_joint(system, pointed_at.index); break;
        case Pointable::Kind::vector: add_rows_with_vector(system, pointed_at.index, pointed_at.part); break;
        case Pointable::Kind::body: add_columns_of_body(system, angular, pointed_at.index); break;
        case Pointable::Kind::column:
            for (const int body : system.moving_bodies()) {
                const int first = system.body_column(body, angular);
                if (pointed_at.index >= first && pointed_at.index < first + 3 + angular) {
                    add(Pointable::body(body));
                }
            }
            break;
        case Pointable::Kind::equation: add_coming_equation(system, pointed_at.index, pointed_at.part); break;
        case Pointable::Kind::symbol:
        case Pointable::Kind::none: break;
    }
}

bool Emphasis::contains(const Pointable& link) const {
    return std::ranges::find(links_, link) != links_.end();
}

void Emphasis::add(const Pointable& link) {
    if (!contains(link)) { links_.push_back(link); }
}

void Emphasis::add_row_and_its_vectors(const System& system, int row) {
    if (row < 0 || row >= system.rows(true)) { return; }
    const RowOrigin origin = system.origin(row);
    const auto k = at(origin.index);
    if (origin.kind == RowOrigin::Kind::normalisation) { return add(Pointable::body(origin.index)); }
    if (origin.kind == RowOrigin::Kind::driver) {
        const int driver = system.drivers()[k].driver;
        const int joint = system.mechanism().drivers[at(driver)].joint;
        if (joint >= 0) { add(Pointable::joint(joint)); }
        return;
    }
    const Constraint& c = system.constraints()[k];
    add(Pointable::joint(c.joint));
    add_vectors(system, c.joint, c.role);
}

void Emphasis::add_vectors(const System& system, int joint, Role role) {
    const Joint& j = system.mechanism().joints[at(joint)];
    for (const int part : {Pointable::kVectorI, Pointable::kVectorJ, Pointable::kVectorD}) {
        if (is_made_of(j, role, part)) { add(Pointable::vector(joint, part)); }
    }
}

void Emphasis::add_coming_equation(const System& system, int joint, int number) {
    const Joint& j = system.mechanism().joints[at(joint)];
    const std::vector<LabelledEquation> equations = equations_of(*j.type, j.parallel_form);
    add(Pointable::joint(joint));
    if (static_cast<std::size_t>(number) < equations.size()) {
        add_vectors(system, joint, equations[at(number)].equation.role);
    }
}

void Emphasis::add_rows_of_joint(const System& system, int joint) {
    for (int row = 0; row < system.rows(); ++row) {
        const Constraint* const c = constraint_of(system, row);
        if (c != nullptr && c->joint == joint) { add(Pointable::row(row)); }
    }
}

void Emphasis::add_rows_with_vector(const System& system, int joint, int part) {
    for (int row = 0; row < system.rows(); ++row) {
        const Constraint* const c = constraint_of(system, row);
        if (c == nullptr || c->joint != joint) { continue; }
        if (is_made_of(system.mechanism().joints[at(joint)], c->role, part)) { add(Pointable::row(row)); }
    }
}

void Emphasis::add_columns_of_body(const System& system, int angular, int body) {
    const int first = system.body_column(body, angular);
    for (int k = 0; first >= 0 && k < 3 + angular; ++k) { add(Pointable::column(first + k)); }
}

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
