#pragma once

#include <string>

#include "app/film/film_file.hpp"
#include "app/host/frames/frame_painter.hpp"

/// Options of a film and their limits: steps, size, look, format. The program and the library use them with
/// different names of options.
namespace jw::film {

// smaller frames have no room for panels; no film format allows larger ones
inline constexpr int kSmallestWidth = 960;
inline constexpr int kSmallestHeight = 540;
inline constexpr int kSmallestWidthAlone = 320;  // without panels
inline constexpr int kSmallestHeightAlone = 180;
inline constexpr int kLargestWidth = 15360;
inline constexpr int kLargestHeight = 8640;
inline constexpr double kMostFps = 240.0;

/// Names of options in messages: those of the program, unless others are given.
struct OptionNames {
    std::string before = "--";
    std::string from = "--from";
    std::string without_panels = "--no-panel";
};

/// Steps of a story, both included, from 0.
struct StepRange {
    int first = 0;
    int last = 0;
};

/// Number of intervals of a lesson's motion at `fps` pictures per second; 0 if nothing moves.
/// @throws std::invalid_argument if there are too many
int intervals_for(const Lesson& lesson, double fps, const OptionNames& names = {});

/// The steps between two names such as "3", "crank" or "t=0.5"; empty names: the first and the last step.
/// @throws std::invalid_argument that names the option, and what was expected
StepRange steps_between(
    const std::string& from, const std::string& to, const Story& story, const OptionNames& names = {});

/// Problem with the look of pictures of this size; empty if there is none.
std::string problem_of_look(
    int width, int height, const host::FrameLook& look, const OptionNames& names = {});
/// Problem with the format: it has no transparency or repetition, or ffmpeg is missing; empty if there is
/// none.
std::string problem_of_format(const FilmSettings& settings, const OptionNames& names = {});
/// True for a vector that can be the direction of the eye; one shorter than 1e-100 has lost its digits.
bool is_direction(const Vec3& v);

}  // namespace jw::film
