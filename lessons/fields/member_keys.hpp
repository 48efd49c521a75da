#pragma once

#include <array>
#include <optional>
#include <string>

#include "lessons/fields/fields.hpp"
#include "lessons/format/key.hpp"

/// Reading and writing of keys that are bound to members.
namespace jw {

/// Reads a key, and reports it if it is required and missing. The member keeps its value where the key is
/// absent or wrong.
void read_member(Fields& fields, const Key& key, const MemberRef& into);

/// TOML of a member; nothing if it is the usual value and the key is not required.
std::optional<std::string> text_of_member(const Key& key, const MemberRef& value, const MemberRef& usual);

/// Reads bound keys.
/// @return whether all given keys are right and no required key is missing
template <class T, std::size_t N>
bool read_members(Fields& fields, const std::array<MemberKey<T>, N>& keys, T& value) {
    const int errors = fields.problems().errors_count();
    for (const MemberKey<T>& bound : keys) { read_member(fields, bound.key, bound.of(value)); }
    return fields.problems().errors_count() == errors;
}

/// Writes bound keys that are required or differ from those of a T{}.
/// @param out  has key(name, value, comment)
template <class T, std::size_t N, class Out>
void write_members(const std::array<MemberKey<T>, N>& keys, T value, Out& out) {
    T usual{};
    for (const MemberKey<T>& bound : keys) {
        if (const auto text = text_of_member(bound.key, bound.of(value), bound.of(usual))) {
            out.key(std::string(bound.key.name), *text, std::string(bound.key.unit));
        }
    }
}

}  // namespace jw
