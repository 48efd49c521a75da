#pragma once

#include <cstdint>
#include <type_traits>

#include "render/gl/gl_functions.hpp"

/// ImGui passes on the names of textures as `ImTextureID`: a pointer in ImGui 1.86, an integer in later
/// versions.
namespace jw::render {

template <class TextureId>
TextureId texture_id_cast(GLuint name) {
    if constexpr (std::is_pointer_v<TextureId>) {
        return reinterpret_cast<TextureId>(static_cast<std::uintptr_t>(name));
    } else {
        return static_cast<TextureId>(name);
    }
}

template <class TextureId>
GLuint texture_name(TextureId id) {
    if constexpr (std::is_pointer_v<TextureId>) {
        return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id));
    } else {
        return static_cast<GLuint>(id);
    }
}

}  // namespace jw::render
