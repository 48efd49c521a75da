#include "app/film/film_file.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "app/film/captions.hpp"
#include "app/film/film_page_parts.hpp"
#include "app/film/processes.hpp"
#include "app/session/encoding/base64.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/text_width.hpp"
#include "render/animation/animation.hpp"
#include "render/animation/gif.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"
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
std::string input_of(const std::vector<FilmPicture>& pictures) {
    std::string text = "ffconcat version 1.0\n";
    std::string file;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        file = "file " + host::frame_name(static_cast<int>(k)) + "\n";
        text += file + "duration " + digits(pictures[k].seconds) + "\n";
    }
    // the duration of a picture counts only if another one follows
    return text + file;
}

/// Format of pixels.
std::string pixels_of(const FilmSettings& settings) { return settings.is_opaque ? "yuv420p" : "yuva420p"; }

/// Arguments for the compression: text stays sharp, flat areas stay flat.
std::string codec_of(const FilmSettings& settings) {
    if (settings.format == FilmFormat::mp4) {
        return "-c:v libx264 -preset veryfast -tune animation -crf 16 -pix_fmt yuv420p -c:s mov_text "
               "-movflags +faststart -f mp4";
    }
    return "-c:v libvpx-vp9 -crf 22 -b:v 0 -deadline good -cpu-used 4 -row-mt 1 -pix_fmt " +
           pixels_of(settings) + " -c:s webvtt -f webm";
}

std::vector<std::string> arguments_of(
    const fs::path& folder, const fs::path& film, const FilmSettings& settings) {
    std::vector<std::string> words;
    // arguments without blanks
    const auto add = [&](const std::string& text) {
        std::istringstream in(text);
        for (std::string word; in >> word;) { words.push_back(word); }
    };
    const auto add_input = [&](const std::string& format, const char* name) {
        add("-f " + format + " -i");
        words.push_back("file:" + (folder / name).string());
    };
    add("ffmpeg -hide_banner -nostdin -loglevel error -y");
    add_input("concat", kList);
    add_input("webvtt", kCaptions);
    add_input("ffmetadata", kMetadata);
    // the resolution of colours is halved in width and height, so both are made even. Players expect BT.709
    // for large pictures. Pictures are repeated last, because that costs nothing
    add("-map 0:v -map 1:s -map_metadata 2 -map_chapters 2 -vf "
        "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=" +
        pixels_of(settings) + ",fps=" + digits(settings.fps));
    add("-colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv");
    add(codec_of(settings));
    words.push_back("file:" + film.string());
    return words;
}

/// Makes a film of the pictures in `folder`. The input of ffmpeg and its messages are written there, too.
/// @return the film, a file in `folder`
/// @throws std::runtime_error with the last message of ffmpeg if it fails, or if there is no ffmpeg
fs::path make_movie(
    const fs::path& folder, const std::vector<FilmPicture>& pictures, const FilmSettings& settings,
    const std::string& captions, const std::string& metadata) {
    if (!has_ffmpeg()) { throw std::runtime_error("there is no ffmpeg on the path"); }
    render::write_file_atomically(folder / kList, input_of(pictures));
    render::write_file_atomically(folder / kCaptions, captions);
    render::write_file_atomically(folder / kMetadata, metadata);
    const fs::path film = folder / (settings.format == FilmFormat::mp4 ? "film.mp4" : "film.webm");
    const pid_t process = start({arguments_of(folder, film, settings), {}, folder / kLog});
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {}
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) { return film; }
    const std::string said = last_line_of(folder / kLog);
    throw std::runtime_error(
        "ffmpeg could not make the film: " + (said.empty() ? "it gave no reason" : said));
}

void write_movie(
    const FilmSettings& settings, const Story& story, const std::vector<FilmPicture>& pictures,
    const host::FrameDraft& draft) {
    const std::string captions = webvtt(captions_of(story, pictures));
    const std::string metadata = ffmetadata(story.lesson().title, chapters_of(story, pictures));
    const fs::path film = make_movie(draft.folder(), pictures, settings, captions, metadata);
    std::error_code error;
    fs::rename(film, settings.file, error);
    if (error) {
        throw std::runtime_error("cannot write '" + settings.file.string() + "': " + error.message());
    }
    render::write_file_atomically(captions_file(settings.file), captions);
}

// a jump into the motion draws at most this many parts, which takes a fraction of a second
constexpr std::size_t kMostBetween = 24;

/// Pictures as parts: a whole one at intervals, and between them only the area that has changed.
class Parts {
public:
    void add(const FilmPicture& picture, render::Image image) {
        const bool is_whole = !before_ || since_whole_ + 1 >= kMostBetween;
        const auto area = is_whole
                              ? render::PixelArea{0, 0, image.width, image.height}
                              : render::changed_area(*before_, image).value_or(render::PixelArea{0, 0, 1, 1});
        const render::Image part = is_whole || !image.alpha.empty()
                                       ? render::cut_out(image, area)
                                       : render::changes_within(area, *before_, image);
        since_whole_ = is_whole ? 0 : since_whole_ + 1;
        parts_.push_back(
            {{"step", picture.step},
             {"seconds", picture.seconds},
             {"whole", is_whole},
             {"x", area.x},
             {"y", area.y},
             {"png", base64(render::encode_png(part))}});
        before_ = std::move(image);
    }
    Json& json() { return parts_; }

private:
    Json parts_ = Json::array();
    std::optional<render::Image> before_;
    std::size_t since_whole_ = 0;
};

Json lines_of(const std::string& text) {
    Json lines = Json::array();
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) { lines.push_back(line); }
    return lines;
}

/// Text of each step that is shown, by its number.
Json captions_by_step(const Story& story, const std::vector<FilmPicture>& pictures) {
    Json captions = Json::object();
    for (const FilmPicture& picture : pictures) {
        Json& lines = captions[std::to_string(picture.step)];
        if (lines.is_null()) {
            lines = lines_of(caption_of(view_of(story, picture.step, ViewParts::without_matrix)));
        }
    }
    return captions;
}

Json chapters_json(const std::vector<Chapter>& chapters) {
    return list_of(chapters, [](const Chapter& chapter) -> Json {
        return {{"title", chapter.title}, {"from", chapter.from}};
    });
}

/// A film as one page of HTML that needs nothing else, not even a server: pictures, timeline, chapters,
/// captions for screen readers, keys, and the text of all steps.
/// @param picture  returns the picture for an index into `pictures`; called in their order
std::string film_page(
    const Story& story, const std::vector<FilmPicture>& pictures,
    const std::function<render::Image(std::size_t)>& picture) {
    Parts parts;
    int width = 0;
    int height = 0;
    bool is_opaque = true;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        render::Image image = picture(k);
        width = image.width;
        height = image.height;
        is_opaque = image.alpha.empty();
        parts.add(pictures[k], std::move(image));
    }
    const Json film{
        {"width", width},
        {"height", height},
        {"opaque", is_opaque},
        {"chapters", chapters_json(chapters_of(story, pictures))},
        {"captions", captions_by_step(story, pictures)},
        {"pictures", std::move(parts.json())}};
    const std::string title = xml_text(caption_title(story));
    std::string page = "<!doctype html>\n<html lang=\"" + std::string(language()) +
                       "\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       title + "</title>\n<style>\n";
    page += kPageStyle;
    page += "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n";
    page +=
        "<noscript><p>This page needs JavaScript to play the film.</p></noscript>\n</main>\n"
        "<script type=\"application/json\" id=\"film\">";
    // escaped so that it cannot end the script
    page += replaced(json_document(film, -1), "<", "\\u003c");
    page += "</script>\n<script>\n";
    page += kPageScript;
    page += "</script>\n</body>\n</html>\n";
    return page;
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
