#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/film/film_pictures.hpp"
#include "app/host/frames/frame_draft.hpp"
#include "render/animation/animation.hpp"

/// A film in one file, made of pictures that have been drawn.
namespace jw::film {

enum class FilmFormat { gif, apng, mp4, webm, html };

/// The format for the extension of a file name; nothing for other names, which are folders.
std::optional<FilmFormat> format_of(const std::filesystem::path& file);

/// True for formats that ffmpeg makes.
constexpr bool needs_ffmpeg(FilmFormat format) {
    return format == FilmFormat::mp4 || format == FilmFormat::webm;
}
/// True if a program ffmpeg is on the path.
bool has_ffmpeg();

/// True for formats that can be transparent.
constexpr bool can_be_transparent(FilmFormat format) {
    return format == FilmFormat::apng || format == FilmFormat::webm || format == FilmFormat::html;
}

struct FilmSettings {
    std::filesystem::path file;
    FilmFormat format = FilmFormat::apng;
    double fps = 30.0;
    render::Repeat repeat = render::Repeat::once;  ///< only for .gif and .apng
    bool is_opaque = true;
};

/// File of captions beside a film: "film.vtt" beside "film.mp4".
std::filesystem::path captions_file(const std::filesystem::path& film);

/// Writes the film completely or not at all; if ffmpeg makes it, also a file of captions beside it.
/// @param pictures  their numbers in `draft` are their indices here
/// @param progress  called with the fraction that is done
/// @throws std::runtime_error if it cannot be written, or with the message of ffmpeg
void write_film(
    const FilmSettings& settings, const Story& story, const std::vector<FilmPicture>& pictures,
    const host::FrameDraft& draft, const std::function<void(double share)>& progress);

}  // namespace jw::film
