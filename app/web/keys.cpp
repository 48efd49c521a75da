#include "app/web/page.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace jw::web {

namespace {

using host::Key;
using NamedKey = std::pair<std::string_view, Key>;

constexpr auto kNames = std::to_array<NamedKey>(
    {{"ArrowLeft", Key::left},
     {"ArrowRight", Key::right},
     {"ArrowUp", Key::up},
     {"ArrowDown", Key::down},
     {"Home", Key::home},
     {"End", Key::end},
     {"PageUp", Key::page_up},
     {"PageDown", Key::page_down},
     {" ", Key::space},
     {"Enter", Key::enter},
     {"Escape", Key::escape},
     {"Tab", Key::tab},
     {"Backspace", Key::backspace},
     {"Delete", Key::del},
     {"F1", Key::f1},
     {"F5", Key::f5},
     {"Control", Key::ctrl},
     {"Meta", Key::ctrl},
     {"Shift", Key::shift}});

}  // namespace

Key key_of(std::string_view name) {
    const auto* const found = std::ranges::find(kNames, name, &NamedKey::first);
    if (found != kNames.end()) { return found->second; }
    return name.size() == 1 ? host::key_of_letter(name.front()) : Key::none;
}

}  // namespace jw::web
