#pragma once

#include <string>
#include <string_view>

/// GLSL 3.30 of the scene renderer. Each is a whole shader.
namespace jw::render::shaders {

enum class Shadows { none, soft };

extern const std::string_view kBodyVertex;
std::string body_fragment(Shadows shadows);
extern const std::string_view kEdgeFragment;   ///< with kBodyVertex: flat colour of outlines
extern const std::string_view kDepthFragment;  ///< with kBodyVertex: only depth
extern const std::string_view kGroundVertex;
std::string ground_fragment();                      ///< fully lit
std::string ground_shadow_fragment();               ///< with kGroundVertex: only the shadow, for blending
extern const std::string_view kBackdropVertex;      ///< fills the viewport at the farthest depth
extern const std::string_view kSkyFragment;         ///< with kBackdropVertex
extern const std::string_view kCopyFragment;        ///< with kBackdropVertex: a texture, pixel by pixel
extern const std::string_view kSampleMeanFragment;  ///< with kBackdropVertex: means of samples
extern const std::string_view kLineVertex;
extern const std::string_view kLineFragment;
std::string body_id_fragment();  ///< with kBodyVertex: the id as colour
std::string line_id_fragment();  ///< with kLineVertex

}  // namespace jw::render::shaders
