#include "app/web/keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace jw::web {

namespace {

using host::Key;

constexpr std::array kNames{
    std::pair<std::string_view, Key>{"ArrowLeft", Key::left},
    std::pair<std::string_view, Key>{"ArrowRight", Key::right},
    std::pair<std::string_view, Key>{"ArrowUp", Key::up},
    std::pair<std::string_view, Key>{"ArrowDown", Key::down},
    std::pair<std::string_view, Key>{"Home", Key::home},
    std::pair<std::string_view, Key>{"End", Key::end},
    std::pair<std::string_view, Key>{"PageUp", Key::page_up},
    std::pair<std::string_view, Key>{"PageDown", Key::page_down},
    std::pair<std::string_view, Key>{" ", Key::space},
    std::pair<std::string_view, Key>{"Enter", Key::enter},
    std::pair<std::string_view, Key>{"Escape", Key::escape},
    std::pair<std::string_view, Key>{"Tab", Key::tab},
    std::pair<std::string_view, Key>{"Backspace", Key::backspace},
    std::pair<std::string_view, Key>{"Delete", Key::del},
    std::pair<std::string_view, Key>{"F1", Key::f1},
    std::pair<std::string_view, Key>{"F5", Key::f5},
    std::pair<std::string_view, Key>{"Control", Key::ctrl},
    std::pair<std::string_view, Key>{"Meta", Key::ctrl},
    std::pair<std::string_view, Key>{"Shift", Key::shift},
    std::pair<std::string_view, Key>{"a", Key::a},
    std::pair<std::string_view, Key>{"c", Key::c},
    std::pair<std::string_view, Key>{"o", Key::o},
    std::pair<std::string_view, Key>{"q", Key::q},
    std::pair<std::string_view, Key>{"r", Key::r},
    std::pair<std::string_view, Key>{"s", Key::s},
    std::pair<std::string_view, Key>{"v", Key::v},
    std::pair<std::string_view, Key>{"x", Key::x},
    std::pair<std::string_view, Key>{"y", Key::y},
    std::pair<std::string_view, Key>{"z", Key::z}};

}  // namespace

Key key_of(std::string_view name) {
    const auto* const found = std::ranges::find(kNames, name, &std::pair<std::string_view, Key>::first);
    return found == kNames.end() ? Key::none : found->second;
}

}  // namespace jw::web
