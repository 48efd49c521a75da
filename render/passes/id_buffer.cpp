#include "render/passes/id_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "render/gl/shaders.hpp"

namespace jw::render {
namespace {

// alpha of a target: thin parts are preferred, because they are hard to hit
constexpr float kBodyRank = 0.5F;
constexpr float kThinRank = 1.0F;
constexpr std::uint8_t kThinAlpha = 255;

// in pixels, larger than any radius: thin parts come first, then the body under the pointer, then near bodies
constexpr double kBodyHere = 1e6;
constexpr double kBodyAway = 1e7;

template <class Part>
void check_ids(const std::vector<Part>& parts) {
    for (const Part& part : parts) {
        if (part.id < 0 || part.id > kMostIds) {
            throw std::invalid_argument(
                "id " + std::to_string(part.id) + " is not in 0 to " + std::to_string(kMostIds));
        }
    }
}

/// The scene without everything that the pointer goes through.
Scene pickable(const Scene& scene) {
    check_ids(scene.shapes);
    check_ids(scene.arrows);
    check_ids(scene.triads);
    check_ids(scene.polylines);
    const auto has_id = [](const auto& part) { return part.id != 0; };
    const auto shown = [](const Shape& shape) {
        return shape.id != 0 || (shape.colour.a >= 1.0F && !shape.see_through);
    };
    Scene kept;
    std::ranges::copy_if(scene.shapes, std::back_inserter(kept.shapes), shown);
    std::ranges::copy_if(scene.arrows, std::back_inserter(kept.arrows), has_id);
    std::ranges::copy_if(scene.triads, std::back_inserter(kept.triads), has_id);
    std::ranges::copy_if(scene.polylines, std::back_inserter(kept.polylines), has_id);
    return kept;
}

/// Distance from the eye along the view [m] for a depth in GL's window, 0 to 1.
double distance_at(double window_depth, const Matrix4d& projection) {
    const double z = 2.0 * window_depth - 1.0;
    const bool parallel = projection(3, 3) != 0.0;
    return parallel ? (projection(2, 3) - z) / projection(2, 2) : projection(2, 3) / (z + projection(2, 2));
}

int id_of(const std::uint8_t* rgba) { return rgba[0] + 256 * rgba[1] + 65536 * rgba[2]; }

}  // namespace

IdBuffer::IdBuffer(const GlFunctions& gl, const SceneMeshes& meshes)
    : gl_(gl),
      meshes_(meshes),
      solid_(gl, "ids of bodies", shaders::kBodyVertex, shaders::body_id_fragment()),
      line_(gl, "ids of lines", shaders::kLineVertex, shaders::line_id_fragment()),
      framebuffer_(GlFramebuffer::make(gl)) {}

bool IdBuffer::update(
    const Scene& scene, const Camera& camera, const Rect& viewport, const FrameSize& frame,
    std::uint64_t version, SceneView::Details details) {
    const Seen now{version, camera, viewport, frame, details};
    if (rect_.width > 0 && seen_ == now) { return false; }
    // one id per pixel of the picture, for any pixel ratio of the device
    const FrameSize pixels{frame.width, frame.height, 1};
    const DeviceRect rect = device_rect(viewport, pixels);
    if (rect.width < 1 || rect.height < 1) {
        rect_ = {};
        return false;
    }
    const SceneView view(pickable(scene), camera, viewport, pixels, Tone::light, details);
    const BoundFramebuffer bound(gl_, framebuffer_);
    make_framebuffer_for(rect);
    draw(view);
    seen_ = now;
    return true;
}

void IdBuffer::make_framebuffer_for(const DeviceRect& rect) {
    const bool fits = rect.width == rect_.width && rect.height == rect_.height;
    rect_ = rect;
    if (fits) { return; }
    colour_ = attached_renderbuffer(gl_, GL_RGBA8, GL_COLOR_ATTACHMENT0, 0, rect.width, rect.height);
    depth_ =
        attached_renderbuffer(gl_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, 0, rect.width, rect.height);
}

void IdBuffer::draw(const SceneView& view) const {
    gl_.Viewport(0, 0, rect_.width, rect_.height);
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    // ghosts come before what is visible through bodies, because that is visible through ghosts as well
    draw_solids(view, view.lists.bodies, kBodyRank);
    draw_solids(view, view.lists.ghosts, kBodyRank);
    draw_solids(view, view.lists.annotations, kThinRank);

    begin_hidden();
    draw_lines(view, view.lists.see_through_lines);
    draw_solid_parts(view, view.lists.see_through, kThinRank, false);
    end_hidden();
    draw_solids(view, view.lists.see_through, kThinRank);
    draw_lines(view, view.lists.lines);
    draw_lines(view, view.lists.see_through_lines);

    begin_hidden();
    draw_solids(view, view.lists.emphasised, kThinRank);
    end_hidden();
    draw_solids(view, view.lists.emphasised, kThinRank);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
}

/// From now on, draws only what lies behind something.
void IdBuffer::begin_hidden() const {
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_FALSE);
}

void IdBuffer::end_hidden() const {
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_TRUE);
}

void IdBuffer::draw_solids(const SceneView& view, const InstanceLists& lists, float rank) const {
    draw_solid_parts(view, lists, rank, false);
    draw_solid_parts(view, lists, rank, true);
}

void IdBuffer::draw_solid_parts(
    const SceneView& view, const InstanceLists& lists, float rank, bool edges) const {
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(edges ? GL_FRONT : GL_BACK);
    solid_.use();
    view.set_solid_uniforms(solid_, edges ? view.pixel_scale : 0.0F);
    solid_.set("rank", rank);
    meshes_.solids.draw(lists);
}

void IdBuffer::draw_lines(const SceneView& view, const std::vector<LineSegment>& lines) const {
    gl_.Disable(GL_CULL_FACE);
    line_.use();
    view.set_line_uniforms(line_);
    line_.set("rank", kThinRank);
    meshes_.lines.draw(lines);
}

int IdBuffer::nearest_id(double x, double y, double radius) const {
    const int column = static_cast<int>(std::floor(x)) - rect_.x;
    const int row = seen_.frame.height - 1 - static_cast<int>(std::floor(y)) - rect_.y;
    if (column < 0 || column >= rect_.width || row < 0 || row >= rect_.height) { return 0; }
    const auto reach = static_cast<int>(std::ceil(radius));
    const int left = std::max(column - reach, 0);
    const int bottom = std::max(row - reach, 0);
    const int columns = std::min(column + reach, rect_.width - 1) - left + 1;
    const int rows = std::min(row + reach, rect_.height - 1) - bottom + 1;
    std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const BoundFramebuffer bound(gl_, framebuffer_);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(left, bottom, columns, rows, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());

    int nearest = 0;
    double least = 2.0 * kBodyAway;
    for (int n = 0; n < columns * rows; ++n) {
        const std::uint8_t* const pixel = &rgba[4 * static_cast<std::size_t>(n)];
        const double away = std::hypot(left + n % columns - column, bottom + n / columns - row);
        const double handicap = pixel[3] == kThinAlpha ? 0.0 : away > 0.0 ? kBodyAway : kBodyHere;
        if (id_of(pixel) == 0 || away > radius || away + handicap >= least) { continue; }
        nearest = id_of(pixel);
        least = away + handicap;
    }
    return nearest;
}

PictureLayers IdBuffer::read_layers() const {
    PictureLayers layers;
    layers.width = seen_.frame.width;
    layers.height = seen_.frame.height;
    const auto pixels = static_cast<std::size_t>(layers.width) * static_cast<std::size_t>(layers.height);
    layers.ids.assign(pixels, 0);
    layers.depth.assign(pixels, 0);
    const auto seen = static_cast<std::size_t>(rect_.width) * static_cast<std::size_t>(rect_.height);
    std::vector<std::uint8_t> rgba(4 * seen);
    std::vector<float> depth(seen);
    const BoundFramebuffer bound(gl_, framebuffer_);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, rect_.width, rect_.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    gl_.ReadPixels(0, 0, rect_.width, rect_.height, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());

    const Matrix4d projection = projection_matrix(seen_.camera, seen_.viewport.width / seen_.viewport.height);
    const double unit = seen_.camera.distance() / PictureLayers::kDepthOfTarget;
    for (std::size_t n = 0; n < seen; ++n) {
        if (depth[n] >= 1.0F) { continue; }
        const auto column = rect_.x + static_cast<int>(n) % rect_.width;
        const auto row = layers.height - 1 - (rect_.y + static_cast<int>(n) / rect_.width);
        const auto k = static_cast<std::size_t>(row) * static_cast<std::size_t>(layers.width) +
                       static_cast<std::size_t>(column);
        layers.ids[k] = id_of(&rgba[4 * n]);
        const double steps = std::round(distance_at(static_cast<double>(depth[n]), projection) / unit);
        layers.depth[k] = static_cast<std::uint16_t>(std::clamp(steps, 1.0, 65535.0));
    }
    return layers;
}

}  // namespace jw::render
