#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jw::architecture {

/// Name between the brackets or quotes of an #include line; empty for any other line.
std::optional<std::string> included_by(const std::string& line);

/// Reason why the file at `path` must not include `name`; empty if it may.
std::optional<std::string> objection(std::string_view path, std::string_view name);

}  // namespace jw::architecture
