#include "render/offscreen.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "render/gl_objects.hpp"

#include <GL/osmesa.h>

namespace jw::render {

/// Owns the context; OSMesa wants a colour buffer of its own, which nothing is drawn into.
struct Offscreen::Context {
    OSMesaContext handle = nullptr;
    std::array<std::uint8_t, 16 * 16 * 4> unused{};
    GlFunctions gl;

    Context() {
        constexpr std::array attributes{
            OSMESA_FORMAT,
            OSMESA_RGBA,
            OSMESA_DEPTH_BITS,
            0,
            OSMESA_PROFILE,
            OSMESA_CORE_PROFILE,
            OSMESA_CONTEXT_MAJOR_VERSION,
            3,
            OSMESA_CONTEXT_MINOR_VERSION,
            3,
            0,
            0};
        handle = OSMesaCreateContextAttribs(attributes.data(), nullptr);
        if (handle == nullptr) {
            throw std::runtime_error(
                "no OpenGL 3.3 without a window: OSMesa gives no core profile context (Debian package "
                "libosmesa6)");
        }
        make_current();
        gl = load_gl_functions(
            [](const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); });
    }
    ~Context() { OSMesaDestroyContext(handle); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    void make_current() {
        if (OSMesaMakeCurrent(handle, unused.data(), GL_UNSIGNED_BYTE, 16, 16) == GL_FALSE) {
            throw std::runtime_error("OSMesa cannot make its context current");
        }
    }
};

namespace {

void throw_on_gl_error(const GlFunctions& gl, const char* during) {
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) {
        constexpr const char* digits = "0123456789abcdef";
        const std::string code{digits[(error >> 8U) & 15U], digits[(error >> 4U) & 15U], digits[error & 15U]};
        throw std::runtime_error(
            std::string(during) + " failed with OpenGL error 0x" + code +
            (error == GL_OUT_OF_MEMORY ? " (out of memory)" : ""));
    }
}

int integer(const GlFunctions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

/// A framebuffer with colour and, when wanted, depth.
struct Target {
    GlFramebuffer framebuffer;
    GlRenderbuffer colour;
    GlRenderbuffer depth;

    Target(const GlFunctions& gl, int width, int height, int samples, bool with_depth)
        : framebuffer(make_framebuffer(gl)), colour(make_renderbuffer(gl)) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        attach(gl, colour, GL_RGBA8, GL_COLOR_ATTACHMENT0, width, height, samples);
        if (with_depth) {
            depth = make_renderbuffer(gl);
            attach(gl, depth, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height, samples);
        }
        throw_on_gl_error(gl, "making the framebuffer");
        if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            throw std::runtime_error(
                "the graphics driver cannot draw into " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels with " + std::to_string(samples) + " samples");
        }
    }

    static void attach(
        const GlFunctions& gl, const GlRenderbuffer& buffer, GLenum format, GLenum attachment, int width,
        int height, int samples) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.name());
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
    }
};

/// Mean of the `ratio` x `ratio` device pixels that stand for one pixel of the picture.
void average_block(const std::uint8_t* rgba, std::size_t columns, std::size_t ratio, std::uint8_t* rgb) {
    const std::size_t count = ratio * ratio;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::size_t sum = count / 2;
        for (std::size_t n = 0; n < count; ++n) {
            sum += rgba[4 * (n / ratio * columns + n % ratio) + channel];
        }
        rgb[channel] = static_cast<std::uint8_t>(sum / count);
    }
}

/// Rows of GL start at the bottom and carry alpha.
Image picture_of(const std::vector<std::uint8_t>& rgba, const FrameSize& size) {
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    const auto ratio = static_cast<std::size_t>(size.pixel_ratio);
    Image image{size.width, size.height, std::vector<std::uint8_t>(3 * width * height)};
    for (std::size_t row = 0; row < height; ++row) {
        const std::uint8_t* from = &rgba[4 * (height - 1 - row) * ratio * width * ratio];
        std::uint8_t* to = &image.rgb[3 * row * width];
        for (std::size_t column = 0; column < width; ++column, from += 4 * ratio, to += 3) {
            if (ratio == 1) {
                std::copy_n(from, 3, to);
            } else {
                average_block(from, width * ratio, ratio, to);
            }
        }
    }
    return image;
}

/// 4 where there is multisampling, else 1: softpipe says 1 and fails on more.
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

}  // namespace

struct Offscreen::Targets {
    int samples;
    FrameSize size;
    Target solid;
    Target flat;
    std::vector<std::uint8_t> rgba;

    Targets(const GlFunctions& gl, int width, int height, int wanted_samples)
        : samples(supported_samples(gl, wanted_samples)),
          size(checked_size(gl, width, height, wanted_samples > 1 && samples == 1)),
          solid(gl, device_width(), device_height(), samples > 1 ? samples : 0, true),
          flat(gl, device_width(), device_height(), 0, false),
          rgba(4 * static_cast<std::size_t>(device_width()) * static_cast<std::size_t>(device_height())) {}

    int device_width() const { return size.width * size.pixel_ratio; }
    int device_height() const { return size.height * size.pixel_ratio; }
};

Offscreen::Offscreen(int width, int height, int samples)
    : context_(std::make_unique<Context>()),
      targets_(std::make_unique<Targets>(context_->gl, width, height, samples)) {}

Offscreen::~Offscreen() {
    // the targets are deleted in their own context, whichever was current
    OSMesaMakeCurrent(context_->handle, context_->unused.data(), GL_UNSIGNED_BYTE, 16, 16);
}

const GlFunctions& Offscreen::gl() const { return context_->gl; }

FrameSize Offscreen::size() const { return targets_->size; }

int Offscreen::samples() const { return targets_->samples; }

std::string Offscreen::renderer() const {
    const auto text = [this](GLenum name) {
        const auto* const found = reinterpret_cast<const char*>(gl().GetString(name));
        return std::string(found == nullptr ? "unknown" : found);
    };
    return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

void Offscreen::begin_3d() {
    context_->make_current();
    gl().BindFramebuffer(GL_FRAMEBUFFER, targets_->solid.framebuffer.name());
    gl().Viewport(0, 0, targets_->device_width(), targets_->device_height());
    gl().Disable(GL_SCISSOR_TEST);
    gl().DepthMask(GL_TRUE);
    gl().ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl().ClearColor(palette::kPaper.r, palette::kPaper.g, palette::kPaper.b, 1.0F);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Offscreen::begin_2d() {
    const int width = targets_->device_width();
    const int height = targets_->device_height();
    gl().Disable(GL_SCISSOR_TEST);
    gl().BindFramebuffer(GL_READ_FRAMEBUFFER, targets_->solid.framebuffer.name());
    gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, targets_->flat.framebuffer.name());
    gl().BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl().BindFramebuffer(GL_FRAMEBUFFER, targets_->flat.framebuffer.name());
    gl().Viewport(0, 0, width, height);
}

Image Offscreen::read() {
    gl().BindFramebuffer(GL_FRAMEBUFFER, targets_->flat.framebuffer.name());
    gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl().ReadPixels(
        0, 0, targets_->device_width(), targets_->device_height(), GL_RGBA, GL_UNSIGNED_BYTE,
        targets_->rgba.data());
    throw_on_gl_error(gl(), "drawing the picture");
    return picture_of(targets_->rgba, targets_->size);
}

}  // namespace jw::render
