#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/jets/coordinates.hpp"
#include "core/model/joint_types.hpp"

namespace jw::formula {

/// The joint, body or system that a formula is about.
struct Subject {
    int joint = -1;            ///< its bodies are i and j; -1: none
    int body = -1;             ///< symbols without index belong to it; -1: none
    std::optional<Role> role;  ///< Φ is that of this primitive of the joint; nothing: of all its primitives
    CoordinateChoice coordinates =
        CoordinateChoice::omega_local;  ///< of the whole system, where neither joint nor body is given

    bool operator==(const Subject&) const = default;
};

/// An equation as a slide writes it.
struct Formula {
    std::string source;              ///< in the notation of docs/mathematics.md
    std::vector<std::string> where;  ///< definitions "symbol = expression", each may use earlier ones
    Subject subject;

    bool operator==(const Formula&) const = default;
};

}  // namespace jw::formula
