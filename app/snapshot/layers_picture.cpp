#include "app/snapshot/layers_picture.hpp"

#include <array>
#include <cstdio>

#include "app/session/picture/pointable.hpp"
#include "lessons/lesson/things.hpp"

namespace jw::snapshot {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

/// FNV-1a: the same on every machine. @source Fowler, Noll, Vo; draft-eastlake-fnv
std::uint32_t hash_of(const std::string& text) {
    std::uint32_t hash = 2166136261U;
    for (const char c : text) { hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U; }
    return hash;
}

/// A colour that is neither white nor near it.
Rgb colour_from(std::uint32_t hash) {
    const auto part = [&](unsigned shift) {
        return static_cast<std::uint8_t>(40U + ((hash >> shift) & 0x7FU));
    };
    return {part(0), part(8), part(16)};
}

/// Colours of the things of a picture, all different.
class Colours {
public:
    Rgb of(const std::string& name) {
        for (std::uint32_t hash = hash_of(name);; ++hash) {
            const Rgb colour = colour_from(hash);
            const auto [known, is_new] = things_.emplace(colour_of(colour.data()), name);
            if (is_new || known->second == name) { return colour; }
        }
    }
    std::map<std::string, std::string> take() { return std::move(things_); }

private:
    std::map<std::string, std::string> things_;
};

}  // namespace

std::string name_of_part(int id, const Mechanism& mechanism) {
    const Pointable link = pointable_of(id);
    switch (link.kind) {
        case Pointable::Kind::body: return name_of(Thing::body(link.index), mechanism);
        case Pointable::Kind::joint: return name_of(Thing::joint(link.index), mechanism);
        case Pointable::Kind::vector: return name_of(Thing::vector(link.index, link.part), mechanism);
        case Pointable::Kind::none:
        case Pointable::Kind::row:
        case Pointable::Kind::column:
        case Pointable::Kind::symbol:
        case Pointable::Kind::equation: break;
    }
    return "ground and paths";
}

std::string colour_of(const std::uint8_t* rgb) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
    return text.data();
}

LayersPicture picture_of(const render::PictureLayers& layers, const Mechanism& mechanism) {
    LayersPicture picture;
    picture.ids = {layers.width, layers.height, std::vector<std::uint8_t>(3 * layers.ids.size(), 255)};
    picture.depth = {layers.width, layers.height, std::vector<std::uint8_t>(3 * layers.ids.size(), 0)};
    Colours colours;
    std::map<int, Rgb> known;
    for (std::size_t k = 0; k < layers.ids.size(); ++k) {
        picture.depth.rgb[3 * k] = static_cast<std::uint8_t>(layers.depth[k] >> 8U);
        picture.depth.rgb[3 * k + 1] = static_cast<std::uint8_t>(layers.depth[k] & 0xFFU);
        const int id = layers.ids[k];
        if (id == 0) { continue; }
        auto found = known.find(id);
        if (found == known.end()) {
            found = known.emplace(id, colours.of(name_of_part(id, mechanism))).first;
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            picture.ids.rgb[3 * k + channel] = found->second[channel];
        }
    }
    picture.things = colours.take();
    return picture;
}

}  // namespace jw::snapshot
