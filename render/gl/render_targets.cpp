#include "render/gl/render_targets.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "render/gl/gl_functions.hpp"
#include "render/gl/shaders.hpp"

namespace jw::render {

namespace {

int integer(const GlFunctions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

/// Mean of the `ratio` x `ratio` device pixels that stand for one pixel of the picture.
std::array<std::uint8_t, 4> mean_of_block(const std::uint8_t* rgba, std::size_t columns, std::size_t ratio) {
    const std::size_t count = ratio * ratio;
    std::array<std::uint8_t, 4> mean{};
    for (std::size_t channel = 0; channel < mean.size(); ++channel) {
        std::size_t sum = count / 2;
        for (std::size_t n = 0; n < count; ++n) {
            sum += rgba[4 * (n / ratio * columns + n % ratio) + channel];
        }
        mean[channel] = static_cast<std::uint8_t>(sum / count);
    }
    return mean;
}

/// Passes each pixel of the picture, in order, to `put(number, rgba)`. Rows of GL start at the bottom.
template <class Put>
void for_each_pixel(const std::vector<std::uint8_t>& rgba, const FrameSize& size, const Put& put) {
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    const auto ratio = static_cast<std::size_t>(size.pixel_ratio);
    for (std::size_t row = 0; row < height; ++row) {
        const std::uint8_t* from = &rgba[4 * (height - 1 - row) * ratio * width * ratio];
        for (std::size_t column = 0; column < width; ++column, from += 4 * ratio) {
            const std::size_t number = row * width + column;
            if (ratio == 1) {
                put(number, from);
            } else {
                put(number, mean_of_block(from, width * ratio, ratio).data());
            }
        }
    }
}

/// Undoes blending, which has multiplied each colour by its opacity.
void divide_by_opacity(const std::uint8_t* rgba, std::uint8_t* rgb) {
    const unsigned alpha = rgba[3];
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const unsigned whole = alpha == 0 ? 0 : (255U * rgba[channel] + alpha / 2) / alpha;
        rgb[channel] = static_cast<std::uint8_t>(std::min(255U, whole));
    }
}

Image picture_of(const std::vector<std::uint8_t>& rgba, const FrameSize& size, bool is_opaque) {
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    Image image{size.width, size.height, std::vector<std::uint8_t>(3 * pixels)};
    if (is_opaque) {
        for_each_pixel(rgba, size, [to = image.rgb.data()](std::size_t n, const std::uint8_t* pixel) {
            // one by one, because a call of memmove takes longer for three bytes
            to[3 * n] = pixel[0];
            to[3 * n + 1] = pixel[1];
            to[3 * n + 2] = pixel[2];
        });
        return image;
    }
    image.alpha.resize(pixels);
    for_each_pixel(rgba, size, [&](std::size_t n, const std::uint8_t* pixel) {
        divide_by_opacity(pixel, &image.rgb[3 * n]);
        image.alpha[n] = pixel[3];
    });
    return image;
}

/// Number of samples: the wanted one if there is multisampling, otherwise 1. The driver softpipe reports 1
/// and fails on more.
int supported_samples(const GlFunctions& gl, int wanted) {
    const int most = integer(gl, GL_MAX_SAMPLES);
    return most < 2 ? 1 : std::clamp(wanted, 1, most);
}

FrameSize checked_size(const GlFunctions& gl, int width, int height, bool doubled) {
    const FrameSize size{width, height, doubled ? 2 : 1};
    const int largest = integer(gl, GL_MAX_RENDERBUFFER_SIZE) / size.pixel_ratio;
    if (width < 1 || height < 1 || width > largest || height > largest) {
        throw std::runtime_error(
            "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
            " pixels cannot be drawn; each side must be 1 to " + std::to_string(largest));
    }
    return size;
}

std::optional<SampleMean> made_mean(const GlFunctions& gl, const FrameSize& size, int samples) {
    std::optional<SampleMean> mean;
    if (SampleMean::is_possible(gl, samples)) {
        mean.emplace(gl, size.width * size.pixel_ratio, size.height * size.pixel_ratio, samples);
    }
    return mean;
}

}  // namespace

RenderTargets::RenderTargets(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl),
      samples_(supported_samples(gl, samples)),
      size_(checked_size(gl, width, height, samples > 1 && samples_ == 1)),
      part_{0, 0, width, height},
      mean_(made_mean(gl, size_, samples_)),
      bodies_(make_target(samples_ > 1 ? samples_ : 0, Depth::with)),
      scene_(make_target(0, Depth::without)),
      flat_(make_target(0, Depth::without)) {}

void RenderTargets::show_part(int x, int y, int frame_width, int frame_height) {
    std::array<GLint, 2> most{};
    gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, most.data());
    if (frame_width * size_.pixel_ratio > most[0] || frame_height * size_.pixel_ratio > most[1]) {
        throw std::runtime_error(
            "a picture of " + std::to_string(frame_width) + " x " + std::to_string(frame_height) +
            " pixels cannot be drawn; the graphics driver draws up to " +
            std::to_string(most[0] / size_.pixel_ratio) + " x " +
            std::to_string(most[1] / size_.pixel_ratio));
    }
    size_.width = frame_width;
    size_.height = frame_height;
    part_.x = x;
    part_.y = y;
}

RenderTargets::Target RenderTargets::make_target(int samples, Depth depth) const {
    take_gl_errors(gl_);  // errors of earlier calls are not caused by this one
    Target target{GlFramebuffer::make(gl_), {}, {}};
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    const auto attached = [&](GLenum format, GLenum attachment) {
        return attached_renderbuffer(gl_, format, attachment, samples, device_width(), device_height());
    };
    if (samples > 0 && mean_) {
        gl_.FramebufferTexture2D(
            GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, mean_->texture().name(), 0);
    } else {
        target.colour = attached(GL_RGBA8, GL_COLOR_ATTACHMENT0);
    }
    if (depth == Depth::with) { target.depth = attached(GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT); }
    throw_on_gl_error(gl_, "making the framebuffer");
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error(
            "the graphics driver cannot draw into " + std::to_string(device_width()) + " x " +
            std::to_string(device_height()) + " pixels with " + std::to_string(samples) + " samples");
    }
    return target;
}

void RenderTargets::begin_3d(const Colour& paper) {
    paper_ = paper;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, scene_.framebuffer.name());
    gl_.Viewport(0, 0, device_width(), device_height());
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.ClearColor(paper.r, paper.g, paper.b, paper.a);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void RenderTargets::begin_bodies() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, bodies_.framebuffer.name()); }

void RenderTargets::end_bodies(const DeviceRect& part) const {
    if (mean_) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, scene_.framebuffer.name());
        return mean_->draw(part);
    }
    gl_.Disable(GL_SCISSOR_TEST);
    const Target* resolved = &bodies_;
    if (gl_.profile == GlProfile::es_30) {
        // Browsers (ANGLE of Chromium 156) lose the pixels around a part into which samples are averaged, so
        // the samples are averaged into an empty framebuffer first.
        gl_.BindFramebuffer(GL_FRAMEBUFFER, flat_.framebuffer.name());
        copy_part(gl_, bodies_.framebuffer, part);
        resolved = &flat_;
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, scene_.framebuffer.name());
    copy_part(gl_, resolved->framebuffer, part);
}

void RenderTargets::begin_2d() const {
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, flat_.framebuffer.name());
    copy_part(gl_, scene_.framebuffer, {0, 0, device_width(), device_height()});
    gl_.Viewport(0, 0, device_width(), device_height());
}

Image RenderTargets::read(bool is_opaque) {
    rgba_.resize(4 * static_cast<std::size_t>(device_width()) * static_cast<std::size_t>(device_height()));
    gl_.BindFramebuffer(GL_FRAMEBUFFER, flat_.framebuffer.name());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, device_width(), device_height(), GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
    throw_on_gl_error(gl_, "drawing the picture");
    return picture_of(rgba_, {part_.width, part_.height, size_.pixel_ratio}, is_opaque);
}

void RenderTargets::blit_to_window() const {
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, flat_.framebuffer.name());
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    // at double size, linear sampling falls between four device pixels and gives their mean, as in `read`
    gl_.BlitFramebuffer(
        0, 0, device_width(), device_height(), 0, 0, part_.width, part_.height, GL_COLOR_BUFFER_BIT,
        size_.pixel_ratio == 1 ? GL_NEAREST : GL_LINEAR);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

bool SampleMean::is_possible(const GlFunctions& gl, int samples) {
    return samples > 1 && gl.profile == GlProfile::core_33;
}

SampleMean::SampleMean(const GlFunctions& gl, int width, int height, int samples)
    : gl_(gl),
      width_(width),
      height_(height),
      samples_(samples),
      program_(gl, "mean of samples", shaders::kBackdropVertex, shaders::kSampleMeanFragment),
      no_attributes_(GlVertexArray::make(gl)),
      texture_(GlTexture::make(gl)) {
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture_.name());
    gl_.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_RGBA8, width, height, GL_TRUE);
}

void SampleMean::draw(const DeviceRect& part) const {
    if (part.empty()) { return; }
    gl_.Viewport(0, 0, width_, height_);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(part.x, part.y, part.width, part.height);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture_.name());
    program_.use();
    program_.set("picture", 0);
    program_.set("samples", samples_);
    gl_.BindVertexArray(no_attributes_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindVertexArray(0);
    gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace jw::render
