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
    bool loop = false;      ///< a .gif or .apng begins again at its end
    bool tween = true;      ///< bodies are seen on their way where an iteration or a joint moves them
    bool dark = false;
    double text = 1.0;                                 ///< size of text, 1 is usual
    std::optional<std::array<double, 3>> camera = {};  ///< direction in which the eye is
    bool panels = true;                                ///< false: the mechanism and its names alone
    bool transparent = false;                          ///< nothing behind it; without panels
    int width = 1280;                                  ///< pixels
    int height = 720;
};

/// A lesson told as a film: steps are found when it is made, pictures are drawn when it is written.
class Film {
public:
    /// A lesson that fails at a step ends there, and shows that.
    /// @throws std::invalid_argument for options that make no sense
    Film(const Lesson& lesson, const FilmOptions& options);

    double seconds() const;  ///< [s]
    int pictures() const;
    const FilmOptions& options() const { return options_; }

    /// Writes it, whole or not at all; the ending of the name says the format: .gif, .apng, .html, and with
    /// ffmpeg .mp4 and .webm, which have their captions beside them.
    /// @param go_on  asked after each picture; false gives up, as NotReached, and leaves nothing
    /// @throws std::invalid_argument for a format that cannot do what is asked, std::runtime_error if it
    /// cannot be drawn or written
    void save(const std::filesystem::path& file, const std::function<bool()>& go_on = {}) const;

private:
    struct Inside;  // of the library alone
    std::shared_ptr<const Inside> inside_;
    FilmOptions options_;
};

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
