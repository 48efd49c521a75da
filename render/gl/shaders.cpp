#include "render/gl/shaders.hpp"

namespace jw::render::shaders {
namespace {

/// Share of the key light that reaches a point; 1 outside the map. The hardware compares and blends four
/// texels per tap; fixed taps on a spiral make the border soft without noise.
constexpr const char* kShadow = R"(
uniform sampler2DShadow shadow_map;
uniform float shadow_spread;  // radius of the soft border, in map coordinates

const int tap_count = 6;
const vec2 taps[tap_count] = vec2[](
    vec2(0.223, 0.061), vec2(-0.435, 0.398), vec2(-0.010, -0.582),
    vec2(0.399, 0.667), vec2(-0.919, -0.090), vec2(0.742, -0.453));

float light_reaching(vec3 at) {
    float sum = 0.0;
    for (int n = 0; n < tap_count; ++n) {
        sum += texture(shadow_map, vec3(at.xy + taps[n] * shadow_spread, at.z));
    }
    return sum / float(tap_count);
}
)";

constexpr const char* kNoShadow = R"(
float light_reaching(vec3 at) { return 1.0; }
)";

const char* shadow_lookup(Shadows shadows) { return shadows == Shadows::soft ? kShadow : kNoShadow; }

/// Light is added in linear units; pictures are stored in sRGB.
constexpr const char* kTransfer = R"(
vec3 linear_from_srgb(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
vec3 srgb_from_linear(vec3 c) { return max(1.055 * pow(max(c, vec3(0.0)), vec3(0.41666)) - 0.055, vec3(0.0)); }
)";

/// Share of the ground that is still visible far out.
constexpr const char* kFade = R"(
in vec2 plane;

float fade() { return 1.0 - smoothstep(0.30, 1.0, length(plane)); }
)";

/// The id as three digits to the base 256, exact in 8 bits per channel.
constexpr const char* kIdColour = R"(
flat in float picked_id;
uniform float rank;
out vec4 pixel;

vec4 id_colour() {
    vec3 digits = vec3(mod(picked_id, 256.0), mod(floor(picked_id / 256.0), 256.0), floor(picked_id / 65536.0));
    return vec4(digits / 255.0, rank);
}
)";

}  // namespace

const std::string_view kBodyVertex = R"(
layout(location = 0) in vec4 core;  // w: 1 where x and y scale with the inner radius
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 pose_x;
layout(location = 3) in vec4 pose_y;
layout(location = 4) in vec4 pose_z;
layout(location = 5) in vec4 size;
layout(location = 6) in vec4 widths;  // rounding [m], edge [pixels], id
layout(location = 7) in vec4 colour;
layout(location = 8) in vec4 edge_colour;

uniform mat4 clip_from_world;
uniform mat4 shadow_from_world;
uniform vec2 clip_per_pixel;
uniform float edge_scale;    // 0: the body itself; else pixels of this frame per pixel of `widths`
uniform float shadow_offset; // [m] along the normal, against a surface that shadows itself

out vec3 position;
out vec3 surface_normal;
out vec3 shadow_position;
out vec4 body_colour;
out vec4 outline_colour;
flat out float picked_id;

void main() {
    vec3 scale = mix(size.xyz, vec3(size.w, size.w, size.z), core.w);
    vec4 local = vec4(core.xyz * scale + normal * widths.x, 1.0);
    position = vec3(dot(pose_x, local), dot(pose_y, local), dot(pose_z, local));
    surface_normal = vec3(dot(pose_x.xyz, normal), dot(pose_y.xyz, normal), dot(pose_z.xyz, normal));
    shadow_position = (shadow_from_world * vec4(position + surface_normal * shadow_offset, 1.0)).xyz;
    body_colour = colour;
    outline_colour = edge_colour;
    picked_id = widths.z;

    gl_Position = clip_from_world * vec4(position, 1.0);
    // the outline is the back of the body, blown up by a constant width on the picture
    vec2 outwards = (mat3(clip_from_world) * surface_normal).xy / clip_per_pixel;
    vec2 pixels = outwards / max(length(outwards), 1e-6) * (widths.y * edge_scale);
    gl_Position.xy += pixels * clip_per_pixel * gl_Position.w;
}
)";

std::string body_fragment(Shadows shadows) {
    return std::string(kTransfer) + shadow_lookup(shadows) + R"(
in vec3 position;
in vec3 surface_normal;
in vec3 shadow_position;
in vec4 body_colour;

uniform vec3 eye;
uniform vec3 parallel_view;   // towards the eye when rays are parallel, else 0
uniform vec3 towards_key;
uniform vec3 towards_fill;
uniform vec3 up;
uniform float shadow_strength;
uniform float flatness;       // 1: its own colour whatever the light
uniform float alpha_scale;

out vec4 pixel;

void main() {
    vec3 n = normalize(surface_normal);
    vec3 to_eye = dot(parallel_view, parallel_view) > 0.0 ? parallel_view : normalize(eye - position);
    float facing = clamp(dot(n, to_eye), 0.0, 1.0);

    float lit = max(dot(n, towards_key), 0.0);
    lit *= 1.0 - shadow_strength * (1.0 - light_reaching(shadow_position));
    float fill = max(dot(n, towards_fill), 0.0);
    float sky = 0.5 + 0.5 * dot(n, up);
    vec3 ambient = mix(vec3(0.30, 0.285, 0.27), vec3(0.50, 0.52, 0.55), sky);
    vec3 light = ambient + lit * vec3(0.62, 0.60, 0.56) + fill * vec3(0.10, 0.11, 0.13);
    light = mix(light, vec3(1.0), flatness);

    vec3 albedo = linear_from_srgb(body_colour.rgb);
    vec3 halfway = normalize(towards_key + to_eye);
    float gloss = pow(max(dot(n, halfway), 0.0), 42.0) * 0.16 * lit;
    float rim = pow(1.0 - facing, 4.0);
    vec3 colour = albedo * light * (1.0 - 0.35 * rim) + gloss + albedo * rim * sky * 0.10;
    pixel = vec4(srgb_from_linear(colour), body_colour.a * alpha_scale);
}
)";
}

const std::string_view kEdgeFragment = R"(
in vec4 outline_colour;
out vec4 pixel;

void main() { pixel = outline_colour; }
)";

const std::string_view kDepthFragment = R"(
void main() {}
)";

const std::string_view kGroundVertex = R"(
uniform mat4 clip_from_world;
uniform mat4 shadow_from_world;
uniform vec3 centre;  // of the part that is drawn, and its half sides
uniform vec3 half_u;
uniform vec3 half_v;
uniform mat4 plane_from_world;

out vec2 plane;  // coordinates in the plane, in units of its radius
out vec3 shadow_position;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
    vec4 position = vec4(centre + corner.x * half_u + corner.y * half_v, 1.0);
    plane = (plane_from_world * position).xy;
    shadow_position = (shadow_from_world * position).xyz;
    gl_Position = clip_from_world * position;
}
)";

std::string ground_fragment() {
    return std::string(kFade) + R"(
uniform float lines_per_radius;
uniform vec4 plane_colour;
uniform vec4 line_colour;
uniform float line_width;  // pixels

out vec4 pixel;

// how much of this pixel a line of the grid covers; lines fainter than their distance on the picture vanish
float grid(vec2 at, float width) {
    vec2 per_pixel = fwidth(at);
    vec2 from_line = abs(fract(at - 0.5) - 0.5) / max(per_pixel, vec2(1e-6));
    vec2 covered = clamp(0.5 * width + 0.5 - from_line, 0.0, 1.0) * (1.0 - smoothstep(0.12, 0.4, per_pixel));
    return max(covered.x, covered.y);
}

void main() {
    vec2 at = plane * lines_per_radius;
    float fine = 1.0 - smoothstep(0.1, 0.6, length(plane));
    float line = max(0.75 * grid(at, line_width), 0.35 * grid(at * 5.0, line_width) * fine);
    pixel = vec4(mix(plane_colour.rgb, line_colour.rgb, line), fade());
}
)";
}

std::string ground_shadow_fragment() {
    return std::string(kFade) + kShadow + R"(
in vec3 shadow_position;

uniform vec4 shadow_colour;

out vec4 pixel;

void main() {
    float shadow = 1.0 - light_reaching(shadow_position);
    pixel = vec4(shadow_colour.rgb, shadow_colour.a * shadow * fade());
}
)";
}

const std::string_view kBackdropVertex = R"(
out float height;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID & 2) * 2 - 1);
    height = 0.5 + 0.5 * corner.y;
    gl_Position = vec4(corner, 1.0, 1.0);
}
)";

const std::string_view kSkyFragment = R"(
in float height;
uniform vec4 top;
uniform vec4 bottom;
out vec4 pixel;

void main() { pixel = mix(bottom, top, smoothstep(0.15, 1.0, height)); }
)";

const std::string_view kCopyFragment = R"(
uniform sampler2D picture;
out vec4 pixel;

void main() { pixel = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }
)";

const std::string_view kSampleMeanFragment = R"(
uniform sampler2DMS picture;
uniform int samples;
out vec4 pixel;

void main() {
    pixel = vec4(0.0);
    for (int n = 0; n < samples; ++n) { pixel += texelFetch(picture, ivec2(gl_FragCoord.xy), n); }
    pixel /= float(samples);
}
)";

const std::string_view kLineVertex = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float width;
layout(location = 3) in vec4 colour;
layout(location = 4) in float id;

uniform mat4 clip_from_world;
uniform vec2 clip_per_pixel;
uniform float width_scale;
uniform float near_w;

out vec2 offset;          // from the axis of the segment, in pixels
flat out float half_length;
flat out float half_width;
flat out vec4 line_colour;
flat out float picked_id;

void main() {
    vec4 a = clip_from_world * vec4(from, 1.0);
    vec4 b = clip_from_world * vec4(to, 1.0);
    // what lies behind the eye is cut off before it is divided by w
    if (a.w < near_w && b.w > near_w) { a = mix(a, b, (near_w - a.w) / (b.w - a.w)); }
    if (b.w < near_w && a.w > near_w) { b = mix(b, a, (near_w - b.w) / (a.w - b.w)); }
    vec2 pixel_a = a.xy / a.w / clip_per_pixel;
    vec2 pixel_b = b.xy / b.w / clip_per_pixel;
    vec2 along = pixel_b - pixel_a;
    half_length = 0.5 * length(along);
    along = half_length > 1e-4 ? along / (2.0 * half_length) : vec2(1.0, 0.0);
    half_width = 0.5 * width * width_scale;

    vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
    float reach = half_width + 0.7;  // room for the soft border
    offset = corner * vec2(half_length + reach, reach);
    vec4 end = corner.x < 0.0 ? a : b;
    vec2 pixels = corner.x * reach * along + corner.y * reach * vec2(-along.y, along.x);
    gl_Position = end + vec4(pixels * clip_per_pixel * end.w, 0.0, 0.0);
    line_colour = colour;
    picked_id = id;
}
)";

const std::string_view kLineFragment = R"(
in vec2 offset;
flat in float half_length;
flat in float half_width;
flat in vec4 line_colour;

uniform float alpha_scale;
out vec4 pixel;

void main() {
    float beyond = max(abs(offset.x) - half_length, 0.0);
    float covered = clamp(half_width + 0.5 - length(vec2(beyond, offset.y)), 0.0, 1.0);
    // transparent round ends would show as dots where segments meet
    if (covered <= 0.0 || (line_colour.a * alpha_scale < 1.0 && beyond > 0.5)) { discard; }
    pixel = vec4(line_colour.rgb, line_colour.a * covered * alpha_scale);
}
)";

std::string body_id_fragment() {
    return std::string(kIdColour) + R"(
void main() { pixel = id_colour(); }
)";
}

std::string line_id_fragment() {
    return std::string(kIdColour) + R"(
in vec2 offset;
flat in float half_length;
flat in float half_width;

void main() {
    float beyond = max(abs(offset.x) - half_length, 0.0);
    if (length(vec2(beyond, offset.y)) > half_width) { discard; }
    pixel = id_colour();
}
)";
}

}  // namespace jw::render::shaders
