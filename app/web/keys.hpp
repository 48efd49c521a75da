#pragma once

#include <string_view>

#include "app/host/ui/input.hpp"

namespace jw::web {

/// Key of a keyboard event of a page. @param name  its `key`, such as "ArrowLeft", "a" or "F5"
host::Key key_of(std::string_view name);

}  // namespace jw::web
