#include "app/film/movie.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "app/film/child_process.hpp"
#include "render/files/atomic_file.hpp"

namespace jw::film {

namespace {

namespace fs = std::filesystem;

// names that FrameDraft recognises as files of the program
constexpr const char* kList = "film.ffconcat";
constexpr const char* kCaptions = "film.vtt";
constexpr const char* kMetadata = "film.ffmetadata";
constexpr const char* kLog = "film.log";

/// A number with 15 digits, and with a decimal point in every locale.
std::string digits(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(15);
    text << value;
    return text.str();
}

/// Pictures with their times, as ffmpeg's demuxer "concat" reads them.
std::string list_of(const std::vector<MoviePicture>& pictures) {
    std::string text = "ffconcat version 1.0\n";
    for (const MoviePicture& picture : pictures) {
        text += "file " + picture.file + "\nduration " + digits(picture.seconds) + "\n";
    }
    // the duration of a picture counts only if another one follows
    return text + "file " + pictures.back().file + "\n";
}

/// Arguments for the compression: text stays sharp, flat areas stay flat.
std::vector<std::string> codec_of(const MovieSettings& settings) {
    if (settings.format == MovieFormat::mp4) {
        return {"-c:v",     "libx264", "-preset", "veryfast", "-tune",     "animation",  "-crf", "16",
                "-pix_fmt", "yuv420p", "-c:s",    "mov_text", "-movflags", "+faststart", "-f",   "mp4"};
    }
    return {"-c:v",      "libvpx-vp9",
            "-crf",      "22",
            "-b:v",      "0",
            "-deadline", "good",
            "-cpu-used", "4",
            "-row-mt",   "1",
            "-pix_fmt",  settings.is_opaque ? "yuv420p" : "yuva420p",
            "-c:s",      "webvtt",
            "-f",        "webm"};
}

std::vector<std::string> arguments_of(
    const fs::path& folder, const fs::path& film, const MovieSettings& settings) {
    const auto file = [&](const char* name) { return "file:" + (folder / name).string(); };
    // the resolution of colours is halved in width and height, so both are made even. Players expect BT.709
    // for large pictures. Pictures are repeated last, because that costs nothing
    const std::string filter =
        "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=" +
        std::string(settings.is_opaque ? "yuv420p" : "yuva420p") + ",fps=" + digits(settings.fps);
    std::vector<std::string> words{
        "ffmpeg",
        "-hide_banner",
        "-nostdin",
        "-loglevel",
        "error",
        "-y",
        "-f",
        "concat",
        "-i",
        file(kList),
        "-f",
        "webvtt",
        "-i",
        file(kCaptions),
        "-f",
        "ffmetadata",
        "-i",
        file(kMetadata),
        "-map",
        "0:v",
        "-map",
        "1:s",
        "-map_metadata",
        "2",
        "-map_chapters",
        "2",
        "-vf",
        filter,
        "-colorspace",
        "bt709",
        "-color_primaries",
        "bt709",
        "-color_trc",
        "bt709",
        "-color_range",
        "tv"};
    const std::vector<std::string> codec = codec_of(settings);
    words.insert(words.end(), codec.begin(), codec.end());
    words.push_back("file:" + film.string());
    return words;
}

}  // namespace

bool has_ffmpeg() {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path file = fs::path(folder.empty() ? "." : folder) / "ffmpeg";
        std::error_code error;
        if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) { return true; }
    }
    return false;
}

fs::path make_movie(
    const fs::path& folder, const std::vector<MoviePicture>& pictures, const MovieSettings& settings) {
    if (!has_ffmpeg()) { throw std::runtime_error("there is no ffmpeg on the path"); }
    render::write_file_atomically(folder / kList, list_of(pictures));
    render::write_file_atomically(folder / kCaptions, settings.captions);
    render::write_file_atomically(folder / kMetadata, settings.metadata);
    const fs::path film = folder / (settings.format == MovieFormat::mp4 ? "film.mp4" : "film.webm");
    const pid_t process = start({arguments_of(folder, film, settings), {}, folder / kLog});
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {}
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) { return film; }
    const std::string said = last_line_of(folder / kLog);
    throw std::runtime_error(
        "ffmpeg could not make the film: " + (said.empty() ? "it gave no reason" : said));
}

}  // namespace jw::film
