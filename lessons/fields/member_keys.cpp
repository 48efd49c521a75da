#include "lessons/fields/member_keys.hpp"

#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

template <class V>
struct InOptional {
    using Type = V;
};
template <class V>
struct InOptional<std::optional<V>> {
    using Type = V;
};

/// Reads a value of this type.
template <class V>
IfGiven<V> read(Fields& fields, const Key& key) {
    if constexpr (std::is_same_v<V, bool>) {
        return fields.flag(key.name);
    } else if constexpr (std::is_same_v<V, int>) {
        return fields.integer(key.name);
    } else if constexpr (std::is_same_v<V, double>) {
        return key.kind == KeyKind::positive       ? fields.positive(key.name)
               : key.kind == KeyKind::not_negative ? fields.not_negative(key.name)
                                                   : fields.number(key.name);
    } else {
        if (key.kind == KeyKind::vector) { return fields.vector(key.name); }
        auto direction = fields.direction(key.name);
        if (direction) { direction->value = unit_of(direction->value); }
        return direction;
    }
}

std::string text_of(const Key& /*key*/, bool value) { return value ? "true" : "false"; }
std::string text_of(const Key& /*key*/, int value) { return std::to_string(value); }
std::string text_of(const Key& /*key*/, double value) { return writing::number_text(value); }
std::string text_of(const Key& key, const Vec3& value) {
    return writing::vector_text(key.kind == KeyKind::direction ? writing::typed_direction(value) : value);
}
template <class V>
std::string text_of(const Key& key, const std::optional<V>& value) {
    return text_of(key, *value);
}

}  // namespace

void read_member(Fields& fields, const Key& key, const MemberRef& into) {
    const auto take = [&]<class M>(M* member) {
        if (const auto given = read<typename InOptional<M>::Type>(fields, key)) { *member = given->value; }
    };
    std::visit(take, into);
    if (key.required) { fields.require(key.name); }
}

std::optional<std::string> text_of_member(const Key& key, const MemberRef& value, const MemberRef& usual) {
    const auto text = [&](const auto* member) -> std::optional<std::string> {
        const auto* of_usual = std::get<std::remove_const_t<std::remove_pointer_t<decltype(member)>>*>(usual);
        if (!key.required && *member == *of_usual) { return std::nullopt; }
        return text_of(key, *member);
    };
    return std::visit(text, value);
}

}  // namespace jw
