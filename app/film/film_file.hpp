#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/film/film_pictures.hpp"
#include "app/host/frames/frame_draft.hpp"
#include "render/animation/animation.hpp"

/// A film in one file, put together of pictures that have been drawn.
namespace jw::film {

enum class FilmFormat { gif, apng, mp4, webm, html };

/// The format that the ending of a name asks for; nothing for other endings, which are folders.
std::optional<FilmFormat> format_of(const std::filesystem::path& file);

/// True for formats that ffmpeg makes.
constexpr bool needs_ffmpeg(FilmFormat format) {
    return format == FilmFormat::mp4 || format == FilmFormat::webm;
}
/// True for formats in which something can shine through.
constexpr bool can_be_transparent(FilmFormat format) {
    return format == FilmFormat::apng || format == FilmFormat::webm || format == FilmFormat::html;
}

struct FilmSettings {
    std::filesystem::path file;
    FilmFormat format = FilmFormat::apng;
    double fps = 30.0;
    render::Repeat repeat = render::Repeat::once;  ///< of .gif and .apng
    bool is_opaque = true;
};

/// File of captions beside a film: "film.vtt" beside "film.mp4".
std::filesystem::path captions_file(const std::filesystem::path& film);

/// Writes the film, whole or not at all; beside one that ffmpeg makes its captions.
/// @param pictures  their numbers in `draft` are their places here
/// @param progress  told the share that is done
/// @throws std::runtime_error if it cannot be written, or with the words of ffmpeg
void write_film(
    const FilmSettings& settings, const Story& story, const std::vector<FilmPicture>& pictures,
    const host::FrameDraft& draft, const std::function<void(double share)>& progress);

}  // namespace jw::film
