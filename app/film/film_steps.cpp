#include "app/film/film_steps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/session/story/timeline.hpp"

namespace jw::film {

namespace {

constexpr double kMostPictures = 100000.0;  // of the motion: more than an hour at 25 per second is a mistake
constexpr float kLargestLetters = 9.0F;     // of a frame of 11520x6480; two thirds of the largest texture
constexpr double kLargestText = 1.5;        // as in the window

int step_named(const std::string& option, const std::string& name, const Story& story) {
    if (const std::optional<int> step = step_at(story, name)) { return *step; }
    throw std::invalid_argument(
        option + " '" + name + "'; expected a step from 1 to " + std::to_string(story.steps().size()) +
        ", the name of a joint or driver, or t=SECONDS");
}

}  // namespace

int intervals_for(const Lesson& lesson, double fps, const OptionNames& names) {
    const std::optional<MotionPlan> motion = shown_motion(lesson);
    if (!motion) { return 0; }
    if (motion->duration * fps > kMostPictures) {
        throw std::invalid_argument(
            "'duration_s' of the motion times " + names.before +
            "fps is more than 100000 pictures; shorten the one or lower the other");
    }
    return std::max(1, static_cast<int>(std::lround(motion->duration * fps)));
}

StepRange steps_between(
    const std::string& from, const std::string& to, const Story& story, const OptionNames& names) {
    StepRange range{0, static_cast<int>(story.steps().size()) - 1};
    if (!from.empty()) { range.first = step_named(names.from, from, story); }
    if (!to.empty()) { range.last = step_named(names.before + "to", to, story); }
    if (range.first <= range.last) { return range; }
    throw std::invalid_argument(
        names.before + "to '" + to + "' is step " + std::to_string(range.last + 1) + ", before step " +
        std::to_string(range.first + 1) + " of " + names.from);
}

std::string problem_of_look(int width, int height, const host::FrameLook& look, const OptionNames& names) {
    if (!std::isfinite(look.text) || look.scale(width, height) > kLargestLetters) {
        return names.before + "text is too large for this " + names.before +
               "size: the letters do not fit into one texture";
    }
    if (look.text > kLargestText && look.has_panels) {
        return names.before + "text above 1.5 leaves the panels no room; expected 0.75 to 1.5, or " +
               names.without_panels;
    }
    if (!look.is_opaque && look.has_panels) {
        return names.before + "transparent needs " + names.without_panels + ": panels are opaque";
    }
    return {};
}

std::string problem_of_format(const FilmSettings& settings, const OptionNames& names) {
    if (!settings.is_opaque && !can_be_transparent(settings.format)) {
        return names.before +
               "transparent needs .webm, .apng, .html or a folder; this format has no transparency";
    }
    const bool has_loop = settings.format == FilmFormat::gif || settings.format == FilmFormat::apng;
    if (settings.repeat == render::Repeat::without_end && !has_loop) {
        return names.before + "loop is only for .gif and .apng; players can repeat other films";
    }
    if (!needs_ffmpeg(settings.format) || has_ffmpeg()) { return {}; }
    return names.before + "out '" + settings.file.string() +
           "' is made by ffmpeg, which is not there; install it (Debian: apt install ffmpeg), or give .gif, "
           ".apng, .html or a folder";
}

bool is_direction(const Vec3& v) { return v.norm() > 1e-100 && std::isfinite(v.squaredNorm()); }

}  // namespace jw::film
