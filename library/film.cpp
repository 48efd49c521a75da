#include "jointwise/film.hpp"

#include <mutex>

#include "app/film/draw_pictures.hpp"
#include "app/film/film_steps.hpp"
#include "library/inside_lesson.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

const jw::film::OptionNames kNames{"", "from_", "panels=False"};

void refuse(const std::string& problem) {
    if (!problem.empty()) { throw std::invalid_argument("jointwise: " + problem); }
}

jw::host::FrameLook look_of(const FilmOptions& options) {
    namespace render = jw::render;
    return {
        options.dark ? render::Tone::dark : render::Tone::light, options.text, options.panels,
        !options.transparent};
}

jw::Vec3 direction_of(const std::array<double, 3>& camera) { return {camera[0], camera[1], camera[2]}; }

void check_size(const FilmOptions& options) {
    namespace film = jw::film;
    const int width = options.panels ? film::kSmallestWidth : film::kSmallestWidthAlone;
    const int height = options.panels ? film::kSmallestHeight : film::kSmallestHeightAlone;
    const auto text = [](int w, int h) { return std::to_string(w) + "x" + std::to_string(h); };
    const auto fits = [&](int w, int h) {
        return w >= width && h >= height && w <= film::kLargestWidth && h <= film::kLargestHeight;
    };
    if (fits(options.width, options.height) || fits(options.height, options.width)) { return; }
    refuse(
        "size '" + text(options.width, options.height) + "'; expected WIDTHxHEIGHT in pixels from " +
        text(width, height) + " to " + text(film::kLargestWidth, film::kLargestHeight) + ", or turned");
}

const FilmOptions& checked(const FilmOptions& options) {
    check_size(options);
    if (!(options.fps >= 0.1 && options.fps <= jw::film::kMostFps)) {
        refuse("fps is out of range; expected 0.1 to 240");
    }
    if (!(options.text >= 0.75 && options.text <= 3.0)) {
        refuse("text is out of range; expected 0.75 to 3");
    }
    refuse(jw::film::problem_of_look(options.width, options.height, look_of(options), kNames));
    if (options.camera && !jw::film::is_direction(direction_of(*options.camera))) {
        refuse("camera has no direction; expected X,Y,Z, the direction in which the eye is");
    }
    return options;
}

jw::Lesson seen_from(jw::Lesson lesson, const FilmOptions& options) {
    if (options.camera) { lesson.camera.from = direction_of(*options.camera); }
    return lesson;
}

jw::StoryOptions moments_of(const jw::Lesson& lesson, double fps) {
    jw::StoryOptions how;
    how.intervals = jw::film::intervals_for(lesson, fps, kNames);
    return how;
}

/// Mutex of the context of ImGui for the panels, which all threads share.
std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

struct Film::Inside {
    Inside(const jw::Lesson& given, const FilmOptions& options)
        : lesson(seen_from(given, options)), story(lesson, moments_of(lesson, options.fps)) {
        const jw::film::StepRange steps = jw::film::steps_between(options.from, options.to, story, kNames);
        pictures = jw::film::pictures_of_film(story, steps.first, steps.last, {options.fps, options.tween});
    }

    jw::Lesson lesson;
    jw::Story story;
    std::vector<jw::film::FilmPicture> pictures;
};

Film::Film(const Lesson& lesson, const FilmOptions& options) : options_(checked(options)) {
    try {
        inside_ = std::make_shared<Inside>(lesson.inside().lesson, options);
    } catch (const std::invalid_argument& error) { refuse(error.what()); }
}

double Film::seconds() const { return jw::film::seconds_of(inside_->pictures); }
int Film::pictures() const { return static_cast<int>(inside_->pictures.size()); }

void Film::save(const std::filesystem::path& file, const std::function<bool()>& go_on) const {
    namespace film = jw::film;
    const std::optional<film::FilmFormat> format = film::format_of(file);
    if (!format) {
        refuse("'" + file.string() + "' is not a film; expected .gif, .apng, .mp4, .webm or .html");
    }
    const film::FilmSettings settings{
        file, *format, options_.fps,
        options_.loop ? jw::render::Repeat::without_end : jw::render::Repeat::once, !options_.transparent};
    refuse(film::problem_of_format(settings, kNames));
    const auto ask = [&] {
        if (go_on && !go_on()) { throw NotReached("jointwise: the film is not finished: given up"); }
    };
    std::vector<film::NumberedPicture> numbered;
    for (const film::FilmPicture& picture : inside_->pictures) {
        numbered.push_back({static_cast<int>(numbered.size()), picture});
    }
    const std::scoped_lock lock(one_at_a_time());
    jw::host::FrameDraft draft(file.string() + ".unfinished");
    draft.begin({{"format", "jointwise run"}, {"library", true}});
    film::draw_missing(
        {&inside_->story, options_.width, options_.height, look_of(options_)}, numbered, draft,
        [&](std::size_t) { ask(); });
    film::write_film(settings, inside_->story, inside_->pictures, draft, [&](double) { ask(); });
    draft.clear();
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
