#include "app/commands/options/surface_option.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>

#include "app/commands/program/command.hpp"
#include "render/surface/headless_context.hpp"

namespace jw {

namespace {

constexpr const char* kVariable = "JOINTWISE_SURFACE";

}  // namespace

void add_surface_option(CLI::App& app, std::string& name) {
    app.add_option(
           "--surface", name,
           std::string("Library that draws pictures without a window: osmesa or egl (default: ") + kVariable +
               ", else the one that is installed, osmesa first)")
        ->type_name("NAME");
}

void choose_surface(const std::string& name) {
    const char* const variable = std::getenv(kVariable);
    const bool by_variable = name.empty() && variable != nullptr && *variable != '\0';
    const std::string wanted = by_variable ? variable : name;
    if (wanted.empty()) { return render::choose_headless_surface(render::HeadlessSurface::automatic); }
    if (wanted == "osmesa") { return render::choose_headless_surface(render::HeadlessSurface::osmesa); }
    if (wanted == "egl") { return render::choose_headless_surface(render::HeadlessSurface::egl); }
    throw CommandError(
        Exit::bad_input, std::string("jointwise: error: ") + (by_variable ? kVariable : "--surface") + " '" +
                             wanted + "'; expected osmesa or egl");
}

}  // namespace jw
