#pragma once

#include <optional>
#include <variant>

#include "core/numerics/linear.hpp"
#include "lessons/format/key.hpp"

/// Keys whose values are members of a struct: one line describes, reads and writes each of them.
namespace jw {

/// A member of any type that a key can have.
using MemberRef = std::variant<bool*, int*, double*, Vec3*, std::optional<double>*, std::optional<Vec3>*>;

/// A key of a table and the member of a T that it fills. An absent key means the value of the member in T{}.
template <class T>
struct MemberKey {
    Key key;
    std::variant<
        bool T::*, int T::*, double T::*, Vec3 T::*, std::optional<double> T::*, std::optional<Vec3> T::*>
        member;

    MemberRef of(T& value) const {
        return std::visit([&](auto pointer) { return MemberRef(&(value.*pointer)); }, member);
    }
};

/// The keys without their members, for the table that they are in.
template <class T, std::size_t N>
constexpr std::array<Key, N> keys_in(const std::array<MemberKey<T>, N>& keyed) {
    std::array<Key, N> keys{};
    std::ranges::transform(keyed, keys.begin(), &MemberKey<T>::key);
    return keys;
}

}  // namespace jw
