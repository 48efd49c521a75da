#include "app/session/picture/pointable.hpp"

#include <algorithm>
#include <iterator>

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
        const RowOrigin origin = system.origin(row);
        const bool of_joint = origin.kind == RowOrigin::Kind::constraint;
        if (part.joint >= 0) {
            if (!of_joint) { continue; }
            const Constraint& c = system.constraints()[static_cast<std::size_t>(origin.index)];
            if (c.joint != part.joint || (part.role && c.role != *part.role)) { continue; }
        }
        rows.push_back(row);
    }
    return rows;
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

Emphasis::Emphasis(const System& system, int angular, const Pointable& pointed_at) {
    light(system, angular, pointed_at);
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
    const auto k = static_cast<std::size_t>(origin.index);
    if (origin.kind == RowOrigin::Kind::normalisation) { return add(Pointable::body(origin.index)); }
    if (origin.kind == RowOrigin::Kind::driver) {
        const int driver = system.drivers()[k].driver;
        const int joint = system.mechanism().drivers[static_cast<std::size_t>(driver)].joint;
        if (joint >= 0) { add(Pointable::joint(joint)); }
        return;
    }
    const Constraint& c = system.constraints()[k];
    add(Pointable::joint(c.joint));
    add_vectors(system, c.joint, c.role);
}

void Emphasis::add_vectors(const System& system, int joint, Role role) {
    const Joint& j = system.mechanism().joints[static_cast<std::size_t>(joint)];
    for (const int part : {Pointable::kVectorI, Pointable::kVectorJ, Pointable::kVectorD}) {
        if (is_made_of(j, role, part)) { add(Pointable::vector(joint, part)); }
    }
}

void Emphasis::add_coming_equation(const System& system, int joint, int number) {
    const Joint& j = system.mechanism().joints[static_cast<std::size_t>(joint)];
    const std::vector<LabelledEquation> equations = equations_of(*j.type, j.parallel_form);
    add(Pointable::joint(joint));
    if (static_cast<std::size_t>(number) < equations.size()) {
        add_vectors(system, joint, equations[static_cast<std::size_t>(number)].equation.role);
    }
}

void Emphasis::add_rows_of_joint(const System& system, int joint) {
    for (int row = 0; row < system.rows(); ++row) {
        const RowOrigin origin = system.origin(row);
        const auto k = static_cast<std::size_t>(origin.index);
        if (origin.kind == RowOrigin::Kind::constraint && system.constraints()[k].joint == joint) {
            add(Pointable::row(row));
        }
    }
}

void Emphasis::add_rows_with_vector(const System& system, int joint, int part) {
    for (int row = 0; row < system.rows(); ++row) {
        const RowOrigin origin = system.origin(row);
        if (origin.kind != RowOrigin::Kind::constraint) { continue; }
        const Constraint& c = system.constraints()[static_cast<std::size_t>(origin.index)];
        if (c.joint != joint) { continue; }
        const Joint& j = system.mechanism().joints[static_cast<std::size_t>(joint)];
        if (is_made_of(j, c.role, part)) { add(Pointable::row(row)); }
    }
}

void Emphasis::add_columns_of_body(const System& system, int angular, int body) {
    const int first = system.body_column(body, angular);
    for (int k = 0; first >= 0 && k < 3 + angular; ++k) { add(Pointable::column(first + k)); }
}

}  // namespace jw
