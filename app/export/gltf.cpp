#include "app/export/gltf.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "app/session/output/json.hpp"
#include "core/elementary/elementary.hpp"

namespace jw::gltf {

namespace {

static_assert(std::endian::native == std::endian::little, "buffers of glTF are little-endian");

// constants of the specification
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

/// The binary part, and the accessors into it.
class Buffer {
public:
    /// @return index of the accessor
    template <class T>
    int add(const std::vector<T>& values, int component, const char* type, int target) {
        const std::size_t length = values.size() * sizeof(T);
        Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}};
        if (target != 0) { view["target"] = target; }
        views_.push_back(view);
        const std::size_t at = bytes_.size();
        bytes_.resize(at + length);
        if (length > 0) { std::memcpy(bytes_.data() + at, values.data(), length); }
        accessors_.push_back(
            {{"bufferView", views_.size() - 1},
             {"componentType", component},
             {"count", values.size()},
             {"type", type}});
        return static_cast<int>(accessors_.size()) - 1;
    }
    Json& accessor(int index) { return accessors_[at(index)]; }

    Json views_ = Json::array();
    Json accessors_ = Json::array();
    std::vector<std::uint8_t> bytes_;
};

/// Adds the smallest and largest value of each component, which glTF requires for positions and times.
template <std::size_t N>
void add_bounds(const std::vector<std::array<float, N>>& values, Json& accessor) {
    std::array<float, N> least = values.front();
    std::array<float, N> most = values.front();
    for (const std::array<float, N>& value : values) {
        for (std::size_t k = 0; k < N; ++k) {
            least[k] = std::min(least[k], value[k]);
            most[k] = std::max(most[k], value[k]);
        }
    }
    accessor["min"] = least;
    accessor["max"] = most;
}

/// Linear value of an sRGB component: materials need linear colours. @source IEC 61966-2-1
float linear(float srgb) {
    return srgb <= 0.04045F ? srgb / 12.92F
                            : static_cast<float>(elementary::pow((srgb + 0.055F) / 1.055F, 2.4));
}

Json material_of(const std::array<float, 4>& colour) {
    return {
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {linear(colour[0]), linear(colour[1]), linear(colour[2]), colour[3]}},
          {"metallicFactor", 0.0},
          {"roughnessFactor", 0.55}}}};
}

/// List of materials without duplicates.
class Materials {
public:
    int index_of(const std::array<float, 4>& colour) {
        const auto found = std::ranges::find(colours_, colour);
        if (found != colours_.end()) { return static_cast<int>(found - colours_.begin()); }
        colours_.push_back(colour);
        json_.push_back(material_of(colour));
        return static_cast<int>(colours_.size()) - 1;
    }
    const Json& json() const { return json_; }

private:
    std::vector<std::array<float, 4>> colours_;
    Json json_ = Json::array();
};

Json mesh_of(const Mesh& mesh, Buffer& buffer, Materials& materials) {
    const int positions = buffer.add(mesh.positions, kFloat, "VEC3", kArrayBuffer);
    add_bounds(mesh.positions, buffer.accessor(positions));
    const int normals = buffer.add(mesh.normals, kFloat, "VEC3", kArrayBuffer);
    const int indices = buffer.add(mesh.indices, kUnsignedInt, "SCALAR", kElementBuffer);
    return {
        {"primitives", Json::array(
                           {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                             {"indices", indices},
                             {"material", materials.index_of(mesh.colour)}}})}};
}

Json node_of(const Node& node) {
    Json json{{"name", node.name}, {"translation", node.pose.translation}, {"rotation", node.pose.rotation}};
    if (!node.children.empty()) { json["children"] = node.children; }
    if (node.mesh >= 0) { json["mesh"] = node.mesh; }
    return json;
}

/// Rotations with consistent signs: q and −q are the same rotation, but they interpolate differently.
std::vector<std::array<float, 4>> rotations_of(const std::vector<Pose>& motion) {
    std::vector<std::array<float, 4>> rotations;
    for (const Pose& pose : motion) {
        std::array<float, 4> q = pose.rotation;
        if (!rotations.empty()) {
            float cosine = 0.0F;
            for (std::size_t k = 0; k < 4; ++k) { cosine += q[k] * rotations.back()[k]; }
            if (cosine < 0.0F) {
                for (float& part : q) { part = -part; }
            }
        }
        rotations.push_back(q);
    }
    return rotations;
}

Json animation_of(const Scene& scene, Buffer& buffer) {
    std::vector<std::array<float, 1>> seconds;
    for (const float t : scene.times) { seconds.push_back({t}); }
    const int times = buffer.add(seconds, kFloat, "SCALAR", 0);
    add_bounds(seconds, buffer.accessor(times));
    Json samplers = Json::array();
    Json channels = Json::array();
    const auto add = [&](std::size_t node, const char* path, int values) {
        channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
        samplers.push_back({{"input", times}, {"output", values}, {"interpolation", "LINEAR"}});
    };
    for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
        const std::vector<Pose>& motion = scene.nodes[k].motion;
        if (motion.empty()) { continue; }
        std::vector<std::array<float, 3>> translations;
        for (const Pose& pose : motion) { translations.push_back(pose.translation); }
        add(k, "translation", buffer.add(translations, kFloat, "VEC3", 0));
        add(k, "rotation", buffer.add(rotations_of(motion), kFloat, "VEC4", 0));
    }
    return {{"name", "motion"}, {"samplers", std::move(samplers)}, {"channels", std::move(channels)}};
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
    }
}

void append_chunk(
    std::vector<std::uint8_t>& bytes, std::uint32_t type, std::vector<std::uint8_t> content,
    std::uint8_t padding) {
    while (content.size() % 4 != 0) { content.push_back(padding); }
    append(bytes, static_cast<std::uint32_t>(content.size()));
    append(bytes, type);
    bytes.insert(bytes.end(), content.begin(), content.end());
}

}  // namespace

std::vector<std::uint8_t> encode(const Scene& scene) {
    Buffer buffer;
    Materials materials;
    Json meshes = Json::array();
    for (const Mesh& mesh : scene.meshes) { meshes.push_back(mesh_of(mesh, buffer, materials)); }
    Json nodes = Json::array();
    for (const Node& node : scene.nodes) { nodes.push_back(node_of(node)); }
    Json document{
        {"asset", {{"version", "2.0"}, {"generator", "jointwise"}}},
        {"scene", 0},
        {"scenes", Json::array({{{"name", scene.name}, {"nodes", {0}}}})},
        {"nodes", std::move(nodes)}};
    if (!scene.times.empty()) { document["animations"] = Json::array({animation_of(scene, buffer)}); }
    // glTF does not allow empty lists
    if (!meshes.empty()) {
        document["meshes"] = std::move(meshes);
        document["materials"] = materials.json();
    }
    if (!buffer.bytes_.empty()) {
        document["accessors"] = buffer.accessors_;
        document["bufferViews"] = buffer.views_;
        document["buffers"] = Json::array({{{"byteLength", buffer.bytes_.size()}}});
    }
    const std::string text = json_document(document, -1);
    std::vector<std::uint8_t> chunks;
    append_chunk(chunks, kJsonChunk, {text.begin(), text.end()}, ' ');
    if (!buffer.bytes_.empty()) { append_chunk(chunks, kBinaryChunk, buffer.bytes_, 0); }
    std::vector<std::uint8_t> file;
    append(file, kMagic);
    append(file, 2);
    append(file, static_cast<std::uint32_t>(12 + chunks.size()));
    file.insert(file.end(), chunks.begin(), chunks.end());
    return file;
}

}  // namespace jw::gltf
