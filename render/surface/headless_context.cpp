#include "render/surface/headless_context.hpp"

#include <atomic>
#include <stdexcept>

#include <dlfcn.h>

namespace jw::render {

namespace {

std::atomic<HeadlessSurface> chosen{HeadlessSurface::automatic};

}  // namespace

void choose_headless_surface(HeadlessSurface surface) { chosen = surface; }

HeadlessSurface chosen_headless_surface() { return chosen; }

std::unique_ptr<HeadlessContext> make_headless_context(HeadlessSurface surface) {
    if (surface == HeadlessSurface::egl) { return make_egl_context(); }
    if (surface == HeadlessSurface::osmesa) { return make_osmesa_context(); }
    std::string first;
    try {
        return make_osmesa_context();
    } catch (const std::runtime_error& error) { first = error.what(); }
    try {
        return make_egl_context();
    } catch (const std::runtime_error&) {
        // if both are missing, the user should install OSMesa, which draws all pictures of the project
        throw std::runtime_error(first);
    }
}

LoadedLibrary::LoadedLibrary(std::initializer_list<const char*> names, std::string error)
    : error_(std::move(error)) {
    std::string why;
    for (const char* const name : names) {
        if (handle_ == nullptr) { handle_ = ::dlopen(name, RTLD_NOW | RTLD_LOCAL); }
        if (const char* const words = ::dlerror(); why.empty() && words != nullptr) { why = words; }
    }
    if (handle_ == nullptr) { throw std::runtime_error(error_ + "it cannot be loaded: " + why); }
}

void* LoadedLibrary::address_of(const char* name) const {
    void* const address = ::dlsym(handle_, name);
    if (address == nullptr) { throw std::runtime_error(error_ + "the one that is there is too old"); }
    return address;
}

}  // namespace jw::render
