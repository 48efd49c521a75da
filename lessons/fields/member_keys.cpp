#include "lessons/fields/member_keys.hpp"

#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

std::optional<bool> read(Fields& fields, const Key& key, const bool& /*type*/) {
    const auto given = fields.flag(key.name);
    return given ? std::optional(given->value) : std::nullopt;
}

std::optional<int> read(Fields& fields, const Key& key, const int& /*type*/) {
    const auto given = fields.integer(key.name);
    return given ? std::optional(given->value) : std::nullopt;
}

std::optional<double> read(Fields& fields, const Key& key, const double& /*type*/) {
    const auto given = key.kind == KeyKind::positive       ? fields.positive(key.name)
                       : key.kind == KeyKind::not_negative ? fields.not_negative(key.name)
                                                           : fields.number(key.name);
    return given ? std::optional(given->value) : std::nullopt;
}

std::optional<Vec3> read(Fields& fields, const Key& key, const Vec3& /*type*/) {
    const bool is_direction = key.kind == KeyKind::direction;
    const auto given = is_direction ? fields.direction(key.name) : fields.vector(key.name);
    if (!given) { return std::nullopt; }
    return is_direction ? unit_of(given->value) : given->value;
}

template <class V>
std::optional<V> read(Fields& fields, const Key& key, const std::optional<V>& /*type*/) {
    return read(fields, key, V());
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
    const auto take = [&](auto* member) {
        if (auto given = read(fields, key, *member)) { *member = *given; }
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
