#pragma once

#include <optional>
#include <string>

#include "lessons/fields/fields.hpp"

/// Reads the bytes of a file into a TOML table.
namespace jw::reading {

/// The table in `source`; reports why if there is none. A byte order mark is removed from `source`, and bytes
/// that are not UTF-8 are replaced, so that it can be shown.
std::optional<toml::table> parse_toml(std::string& source, Problems& problems);

}  // namespace jw::reading
