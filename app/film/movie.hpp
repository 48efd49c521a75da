#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Films in the formats of video players, made by ffmpeg.
namespace jw::film {

enum class MovieFormat {
    mp4,   ///< H.264
    webm,  ///< VP9; may be transparent
};

/// True if a program ffmpeg is on the path.
bool has_ffmpeg();

/// A picture in a file and how long it is shown.
struct MoviePicture {
    std::string file;  ///< its name in the folder of the list
    double seconds = 0.0;
};

struct MovieSettings {
    MovieFormat format = MovieFormat::mp4;
    double fps = 30.0;  ///< of the film; a picture that is shown longer is repeated
    bool is_opaque = true;
    std::string captions;  ///< WebVTT
    std::string metadata;  ///< of ffmpeg: title and chapters
};

/// Makes a film of PNG pictures. The input of ffmpeg and its messages are written into `folder`.
/// @param folder  of the pictures
/// @return the film, a file in `folder`
/// @throws std::runtime_error with the last message of ffmpeg if it fails, or if there is no ffmpeg
std::filesystem::path make_movie(
    const std::filesystem::path& folder, const std::vector<MoviePicture>& pictures,
    const MovieSettings& settings);

}  // namespace jw::film
