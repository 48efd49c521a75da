#pragma once

#include <type_traits>
#include <variant>

/// Visits variants with one function per alternative: the compiler reports every place that lacks a new
/// alternative.
namespace jw {

/// Overload set of lambdas for std::visit.
template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
// clang before version 17 does not deduce this
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

/// True if T is an alternative of the variant V.
template <class T, class V>
inline constexpr bool kIsAlternative = false;
template <class T, class... Ts>
inline constexpr bool kIsAlternative<T, std::variant<Ts...>> = (std::is_same_v<T, Ts> || ...);

}  // namespace jw
