#include "app/host/frames/environment.hpp"

#include <array>
#include <cstdio>
#include <utility>

#include "render/fonts/font_face.hpp"
#include "render/fonts/font_search.hpp"
#include "render/passes/scene_renderer.hpp"

namespace jw::host {

namespace {

constexpr const char* kLookName = "look of pictures";
/// The version is told, but does not make pictures others: whoever changes the look raises its number.
constexpr const char* kVersionName = "jointwise";

/// Value of a name that is missing; the first look of pictures had no number, so it counts as "1".
std::string missing(const std::string& name) { return name == kLookName ? "1" : "nothing"; }

/// 64-bit FNV-1a hash, to tell two versions of a font apart. @source draft-eastlake-fnv
std::string hash_of(const std::vector<std::uint8_t>& bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const std::uint8_t byte : bytes) { hash = (hash ^ byte) * 1099511628211ULL; }
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

/// Name of the renderer without the register width: 128 and 256 bits give the same pixels.
std::string without_register_width(std::string renderer) {
    const std::size_t bits = renderer.find(" bits");
    const std::size_t comma = renderer.rfind(", ", bits);
    if (bits != std::string::npos && comma != std::string::npos) {
        renderer.erase(comma, bits + std::string(" bits").size() - comma);
    }
    return renderer;
}

}  // namespace

Environment font_environment() {
    Environment fonts;
    for (const render::FontFile& font : render::kFontFiles) {
        const std::filesystem::path path = render::path_of_font(font);
        fonts[font.name] = path.empty() ? "missing" : hash_of(render::read_font_file(path));
    }
    return fonts;
}

Environment environment(const std::string& renderer, Environment fonts) {
    Environment found = std::move(fonts);
    found[kVersionName] = JW_VERSION;
    found[kLookName] = std::to_string(render::kLook);
    found["FreeType"] = render::freetype_version();
    found["renderer"] = without_register_width(renderer);
    return found;
}

std::string environment_change(const Environment& before, const Environment& now) {
    Environment all = before;
    all.insert(now.begin(), now.end());
    const auto value = [](const Environment& in, const std::string& name) {
        const auto found = in.find(name);
        return found == in.end() ? missing(name) : found->second;
    };
    std::string text;
    for (const auto& [name, what] : all) {
        const std::string then = value(before, name);
        const std::string here = value(now, name);
        if (then == here || name == kVersionName) { continue; }
        text += (text.empty() ? "" : "; ") + name + ": " + then + " before, " + here + " now";
    }
    return text;
}

}  // namespace jw::host
