#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "render/files/png_reader.hpp"

namespace jw::test {

/// @throws std::runtime_error naming `path` and the reason.
inline render::Image read_png(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    return render::decode_png(bytes, path.string());
}

}  // namespace jw::test
