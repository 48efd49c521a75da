#include "render/fonts/font_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "render/fonts/fonts.hpp"

namespace jw::render {
namespace {

constexpr std::array kFolders{
    "/usr/share/fonts/truetype/dejavu",
    "/usr/share/texmf/fonts/opentype/public/lm-math",
    "/usr/share/fonts/opentype/lmodern",
    "/usr/share/fonts/truetype/droid",
};

std::vector<std::filesystem::path> font_folders() {
    std::vector<std::filesystem::path> folders;
    if (const char* const own = std::getenv("JOINTWISE_FONTS"); own != nullptr) {
        std::istringstream list(own);
        for (std::string folder; std::getline(list, folder, ':');) {
            if (!folder.empty()) { folders.emplace_back(folder); }
        }
    }
    folders.insert(folders.end(), kFolders.begin(), kFolders.end());
    return folders;
}

/// Path of a font; empty if it is in none of the folders.
std::filesystem::path find_font(const FontFile& file, const std::vector<std::filesystem::path>& folders) {
    for (const auto& folder : folders) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(folder / file.name, ignored)) { return folder / file.name; }
    }
    return {};
}

std::string not_found(const FontFile& file) {
    return "font '" + std::string(file.name) + "' not found; install the Debian package " + file.package +
           " or name its folder in JOINTWISE_FONTS";
}

bool is_of_debian(const std::filesystem::path& path) {
    return std::ranges::find(kFolders, path.parent_path().string()) != kFolders.end();
}

/// Remedy for a font that exists but cannot be used.
std::string remedy_for(const std::filesystem::path& path, const FontFile& file) {
    if (is_of_debian(path)) { return "apt-get install --reinstall " + std::string(file.package); }
    return "replace the file, or take its folder out of JOINTWISE_FONTS";
}

void examine(FontSource& source, const FontFile& file) {
    try {
        const FontFace readable(source.path);
    } catch (const std::runtime_error& error) {
        source.state = FontSource::State::damaged;
        source.problem = error.what();
        source.remedy = remedy_for(source.path, file);
    }
}

}  // namespace

FontFace open_font(const FontFile& file) {
    const std::filesystem::path path = find_font(file, font_folders());
    if (path.empty()) { throw std::runtime_error(not_found(file)); }
    try {
        return FontFace(path);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(error.what() + std::string("; ") + remedy_for(path, file));
    }
}

std::filesystem::path path_of_font(const FontFile& file) { return find_font(file, font_folders()); }

std::string package_of_missing_chinese() {
    return path_of_font(kChinese).empty() ? kChinese.package : std::string();
}

std::vector<FontSource> find_fonts() { return find_fonts(font_folders()); }

std::vector<FontSource> find_fonts(const std::vector<std::filesystem::path>& folders) {
    std::vector<FontSource> sources;
    std::vector<FontFile> files(kFontFiles.begin(), kFontFiles.end());
    files.push_back(kChinese);
    for (const FontFile& file : files) {
        FontSource source;
        source.optional = std::string_view(file.name) == kChinese.name;
        source.name = file.name;
        source.package = file.package;
        source.path = find_font(file, folders);
        if (source.path.empty()) {
            source.state = FontSource::State::missing;
            source.problem = not_found(file);
        } else {
            examine(source, file);
        }
        sources.push_back(source);
    }
    return sources;
}

}  // namespace jw::render
