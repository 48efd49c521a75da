#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace jw::host {

/// @throws std::runtime_error "'PATH' WHY"
[[noreturn]] inline void refuse(const std::filesystem::path& path, const std::string& why) {
    throw std::runtime_error("'" + path.string() + "' " + why);
}

}  // namespace jw::host
