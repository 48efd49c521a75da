#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jw::architecture {

/// The name between the brackets or quotes of an #include line; nothing for any other line.
std::optional<std::string> included_by(const std::string& line);

/// Why the file at `path` must not include `name`; nothing if it may.
std::optional<std::string> objection(std::string_view path, std::string_view name);

}  // namespace jw::architecture
