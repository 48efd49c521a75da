#pragma once

#include <string>

/// GLSL 3.30 of the scene renderer. Each function gives a whole shader.
namespace jw::render::shaders {

enum class Shadows { none, soft };

std::string body_vertex();
std::string body_fragment(Shadows shadows);
std::string edge_fragment();   ///< with body_vertex: flat colour of outlines
std::string depth_fragment();  ///< with body_vertex: only depth
std::string ground_vertex();
std::string ground_fragment();         ///< fully lit
std::string ground_shadow_fragment();  ///< with ground_vertex: only the shadow, for blending
std::string backdrop_vertex();         ///< fills the viewport at the farthest depth
std::string sky_fragment();            ///< with backdrop_vertex
std::string copy_fragment();           ///< with backdrop_vertex: a texture, pixel by pixel
std::string sample_mean_fragment();    ///< with backdrop_vertex: means of a multisampled texture
std::string line_vertex();
std::string line_fragment();
std::string body_id_fragment();  ///< with body_vertex: the id as colour
std::string line_id_fragment();  ///< with line_vertex

}  // namespace jw::render::shaders
