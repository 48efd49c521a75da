#pragma once

#include <cstddef>
#include <utility>
#include <variant>

namespace jw {

/// std::visit for hot paths: each alternative is compiled in place, whatever their number. The library's own
/// std::visit calls through a table of pointers if there are more than eleven: 8 % more instructions for an
/// evaluation of the equations of motion in coordinates of bodies.
template <std::size_t K = 0, class F, class... Ts>
constexpr decltype(auto) visit_inlined(F&& f, const std::variant<Ts...>& variant) {
    if constexpr (K + 1 == sizeof...(Ts)) {
        return std::forward<F>(f)(*std::get_if<K>(&variant));
    } else {
        if (variant.index() == K) { return std::forward<F>(f)(*std::get_if<K>(&variant)); }
        return visit_inlined<K + 1>(std::forward<F>(f), variant);
    }
}

}  // namespace jw
