#include "app/film/film_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "app/film/captions.hpp"
#include "app/film/film_page.hpp"
#include "app/film/movie.hpp"
#include "render/animation/gif.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png_reader.hpp"

namespace jw::film {

namespace {

namespace fs = std::filesystem;
using Progress = std::function<void(double share)>;

// enough to find every colour that is shown for long
constexpr std::size_t kSampledPictures = 24;

render::Image picture_in(const host::FrameDraft& draft, std::size_t number) {
    const fs::path path = draft.folder() / host::frame_name(static_cast<int>(number));
    std::ifstream in(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    return render::decode_png(bytes, path.string(), render::Alpha::kept);
}

/// Colours of a film, from evenly spaced pictures.
std::vector<render::Rgb> colours_of(std::size_t pictures, const host::FrameDraft& draft) {
    render::ColourCensus census;
    const std::size_t samples = std::min(pictures, kSampledPictures);
    for (std::size_t k = 0; k < samples; ++k) { census.add(picture_in(draft, k * pictures / samples)); }
    return census.choose(render::kMostColoursOfGif);
}

void write_animation(
    const FilmSettings& settings, const std::vector<FilmPicture>& pictures, const host::FrameDraft& draft,
    const Progress& progress) {
    const std::unique_ptr<render::Animation> animation =
        settings.format == FilmFormat::gif
            ? render::make_gif(colours_of(pictures.size(), draft), settings.repeat)
            : render::make_apng(settings.repeat);
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        animation->add(picture_in(draft, k), pictures[k].seconds);
        progress(static_cast<double>(k + 1) / static_cast<double>(pictures.size()));
    }
    render::write_file_atomically(settings.file, animation->finish());
}

void write_movie(
    const FilmSettings& settings, const Story& story, const std::vector<FilmPicture>& pictures,
    const host::FrameDraft& draft) {
    std::vector<MoviePicture> shown;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        shown.push_back({host::frame_name(static_cast<int>(k)), pictures[k].seconds});
    }
    const std::string captions = webvtt(captions_of(story, pictures));
    const fs::path film = make_movie(
        draft.folder(), shown,
        {settings.format == FilmFormat::mp4 ? MovieFormat::mp4 : MovieFormat::webm, settings.fps,
         settings.is_opaque, captions, ffmetadata(story.lesson().title, chapters_of(story, pictures))});
    std::error_code error;
    fs::rename(film, settings.file, error);
    if (error) {
        throw std::runtime_error("cannot write '" + settings.file.string() + "': " + error.message());
    }
    render::write_file_atomically(captions_file(settings.file), captions);
}

}  // namespace

std::optional<FilmFormat> format_of(const fs::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".gif") { return FilmFormat::gif; }
    if (ending == ".apng") { return FilmFormat::apng; }
    if (ending == ".mp4") { return FilmFormat::mp4; }
    if (ending == ".webm") { return FilmFormat::webm; }
    if (ending == ".html") { return FilmFormat::html; }
    return std::nullopt;
}

fs::path captions_file(const fs::path& film) { return fs::path(film).replace_extension(".vtt"); }

void write_film(
    const FilmSettings& settings, const Story& story, const std::vector<FilmPicture>& pictures,
    const host::FrameDraft& draft, const Progress& progress) {
    if (needs_ffmpeg(settings.format)) {
        write_movie(settings, story, pictures, draft);
    } else if (settings.format == FilmFormat::html) {
        const auto picture = [&](std::size_t k) { return picture_in(draft, k); };
        render::write_file_atomically(settings.file, film_page(story, pictures, picture));
    } else {
        write_animation(settings, pictures, draft, progress);
    }
}

}  // namespace jw::film
