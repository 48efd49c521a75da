#pragma once

#include <map>
#include <string>

#include "core/model/mechanism.hpp"
#include "render/files/image.hpp"
#include "render/scene/picture_layers.hpp"

namespace jw::snapshot {

/// The second layer of a snapshot as pictures that can be stored and viewed.
struct LayersPicture {
    render::Image ids;                          ///< each thing in its own colour; nothing is white
    std::map<std::string, std::string> things;  ///< "#3fa2c4": its name
    /// Depth in the red (high) and green byte of a pixel, see `render::PictureLayers`; blue is 0.
    render::Image depth;
};

/// The layers as pictures. The colour of a thing depends only on its name, not on the other things.
LayersPicture picture_of(const render::PictureLayers& layers, const Mechanism& mechanism);

/// Name of the thing that a part of the scene belongs to, by the part's id: "crank", "hinge", "hinge s_i";
/// "ground and paths" for 0.
std::string name_of_part(int id, const Mechanism& mechanism);

/// "#3fa2c4" of a pixel.
std::string colour_of(const std::uint8_t* rgb);

}  // namespace jw::snapshot
