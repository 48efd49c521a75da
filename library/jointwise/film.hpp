#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "jointwise/lesson.hpp"

/// Lessons as films, as `jointwise render` makes them (docs/films.md).
namespace jointwise {
inline namespace JOINTWISE_ABI {

struct FilmOptions {
    std::string from = {};  ///< first step: "3" counted from 1, a joint or driver, "t=0.5"; empty: the first
    std::string to = {};    ///< last step, included; empty: the last
    double fps = 30.0;      ///< pictures per second of what moves, 0.1 to 240
    bool loop = false;      ///< a .gif or .apng repeats
    bool tween = true;      ///< shows bodies on their way if an iteration or a joint moves them
    bool dark = false;
    double text = 1.0;                                 ///< size of text, relative to the usual size
    std::optional<std::array<double, 3>> camera = {};  ///< direction to the eye
    bool panels = true;                                ///< false: only the mechanism and its names
    bool transparent = false;                          ///< no background; only without panels
    int width = 1280;                                  ///< pixels
    int height = 720;
};

/// A lesson told as a film. The constructor finds the steps; `save` draws the pictures.
class Film {
public:
    /// A film of a lesson that fails at a step ends there, and shows the failure.
    /// @throws std::invalid_argument for invalid options
    Film(const Lesson& lesson, const FilmOptions& options);

    double seconds() const;  ///< [s]
    int pictures() const;
    const FilmOptions& options() const { return options_; }

    /// Writes the film completely or not at all. The extension selects the format: .gif, .apng, .html, or
    /// with ffmpeg .mp4, .webm (and a file of captions beside them).
    /// @param go_on  called after each picture; false ends with NotReached, and no file is left
    /// @throws std::invalid_argument for a format that does not support the options, std::runtime_error if
    /// the film cannot be drawn or written
    void save(const std::filesystem::path& file, const std::function<bool()>& go_on = {}) const;

private:
    struct Inside;  // only for the library
    std::shared_ptr<const Inside> inside_;
    FilmOptions options_;
};

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
