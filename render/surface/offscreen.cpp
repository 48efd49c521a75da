#include "render/surface/offscreen.hpp"

#include "render/surface/headless_context.hpp"
#include "render/surface/mesa_settings.hpp"

namespace jw::render {

namespace {

/// @param width, height  of the picture that is drawn, to check the memory that it needs
std::unique_ptr<HeadlessContext> context_for(int width, int height) {
    check_address_space(width, height);
    return make_headless_context(chosen_headless_surface());
}

}  // namespace

Offscreen::Offscreen(int width, int height, int samples)
    : context_(context_for(width, height)),
      wanted_samples_(samples),
      targets_(std::make_unique<RenderTargets>(context_->gl(), width, height, samples)) {}

Offscreen::~Offscreen() {
    // the targets must be deleted in their own context, whichever is current
    try {
        context_->make_current();
    } catch (const std::exception&) {
        // the objects of a lost context are lost with it
    }
}

const GlFunctions& Offscreen::gl() const { return context_->gl(); }

FrameSize Offscreen::size() const { return targets_->size(); }

std::string Offscreen::renderer() const {
    make_current();
    return renderer_name(gl());
}

void Offscreen::resize(int width, int height) {
    check_address_space(width, height);
    make_current();
    targets_ = std::make_unique<RenderTargets>(gl(), width, height, wanted_samples_);
}

void Offscreen::make_current() const { context_->make_current(); }

void Offscreen::begin_3d(const Colour& paper) {
    make_current();
    targets_->begin_3d(paper);
}

void Offscreen::begin_2d() {
    make_current();
    targets_->begin_2d();
}

Image Offscreen::read(bool is_opaque) {
    make_current();
    return targets_->read(is_opaque);
}

}  // namespace jw::render
