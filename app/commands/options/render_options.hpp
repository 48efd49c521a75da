#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/command.hpp"
#include "app/film/film_file.hpp"
#include "app/film/processes.hpp"
#include "app/host/frames/frame_painter.hpp"

namespace CLI {
class App;
}

/// Options of `jointwise render`.
namespace jw {

struct RenderOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::string out;
    std::string size = "1280x720";
    double fps = 30.0;
    std::optional<std::string> frames;
    std::string from;
    std::string to;
    bool motion_only = false;
    bool no_tween = false;
    bool loop = false;
    bool dark = false;
    double text = 1.0;
    std::string camera;
    bool no_panel = false;
    bool transparent = false;
    int jobs = 0;  ///< 0: as many as there are cores, if there is enough to draw
    std::string shard;
    bool resume = false;

    /// Format of the film that --out names; nothing for a folder.
    std::optional<film::FilmFormat> format() const { return film::format_of(out); }
    host::FrameLook look() const;
    /// Settings of the film; only if there is a format.
    film::FilmSettings settings() const;
};

void add_render_options(CLI::App& command, RenderOptions& options);

/// The options after the check, as values.
struct CheckedRender {
    PixelSize size;
    std::optional<Vec3> camera;  ///< direction to the eye
    film::Part shard;            ///< one of one without --shard
};

/// @throws CommandError for values and combinations that make no sense, with what to do
CheckedRender checked(const RenderOptions& options);

}  // namespace jw
