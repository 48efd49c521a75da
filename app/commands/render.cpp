#include <charconv>
#include <future>
#include <optional>
#include <thread>

#include "app/commands/options/render_options.hpp"
#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/film/draw_pictures.hpp"
#include "app/film/film_steps.hpp"
#include "app/host/frames/environment.hpp"
#include "app/host/frames/frame_files.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/session/output/pace.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "render/surface/mesa_settings.hpp"
#include "render/surface/offscreen.hpp"

namespace jw {

namespace {

/// Frames A to B, both included, counted from 0.
struct FrameRange {
    int first = 0;
    int last = 0;
};

CommandError bad_range(const std::string& text, int frames) {
    return bad_input(
        "--frames '" + text + "'; expected A:B, A:, :B or A with numbers from 0 to " +
        std::to_string(frames - 1) + ", the frames of this lesson");
}

std::optional<int> number_of(const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) { return std::nullopt; }
    return number;
}

/// "3:7", "3:", ":7" or "3" within `frames` frames.
/// @throws CommandError for anything else
FrameRange frame_range(const std::string& text, int frames) {
    const std::size_t colon = text.find(':');
    const std::string from = text.substr(0, colon);
    const std::string to = colon == std::string::npos ? from : text.substr(colon + 1);
    if (from.empty() && to.empty()) { throw bad_range(text, frames); }
    const std::optional<int> first = from.empty() ? 0 : number_of(from);
    const std::optional<int> last = to.empty() ? frames - 1 : number_of(to);
    if (!first || !last || *first < 0 || *last < *first || *last >= frames) { throw bad_range(text, frames); }
    return {*first, *last};
}

namespace fs = std::filesystem;

// starting a process takes as long as drawing this many pictures
constexpr std::size_t kPicturesWorthAJob = 8;

/// One run: what is drawn, and where it is written.
class RenderRun {
public:
    RenderRun(
        const RenderOptions& options, const CheckedRender& checked, const ChangedLesson& changed,
        const Story& story, const FrameRange& range, const Streams& streams)
        : options_(options),
          checked_(checked),
          changed_(changed),
          story_(story),
          range_(range),
          streams_(streams),
          drawn_{&story, checked.size.width, checked.size.height, options.look()},
          drawn_with_(drawn_with()) {
        if (options.format()) {
            film_ = film::pictures_of_film(story, range.first, range.last, {options.fps, !options.no_tween});
            for (std::size_t k = 0; k < film_.size(); ++k) {
                pictures_.push_back({static_cast<int>(k), film_[k]});
            }
        } else {
            for (int k = range.first; k <= range.last; ++k) { pictures_.push_back({k, {k, 1.0, 0.0}}); }
        }
    }

    void carry_out() {
        if (const std::optional<std::string> part = film::part_of_environment()) {
            draw_part(*part);
        } else if (options_.format()) {
            make_film();
        } else {
            fill_folder();
        }
    }

private:
    /// In a process that another one has started: draws its part of the pictures, and nothing else.
    void draw_part(const std::string& text) {
        film::end_with_parent();
        film::Part part;
        if (!film::read_part(text, part)) {
            throw bad_input(
                std::string(film::kPartVariable) + " is '" + text +
                "', which only this program itself sets; unset it");
        }
        host::FrameDraft draft(draft_folder());
        draft.join(run(), host::FrameDraft::Joined::part);
        film::draw_missing(drawn_, film::part_of(shard(), part.part, part.parts), draft, [](std::size_t) {});
    }

    void make_film() {
        host::FrameDraft draft(draft_folder());
        if (!draw(draft)) { return; }
        ProgressBar bar(streams_, "writing");
        film::write_film(options_.settings(), story_, film_, draft, [&](double share) { bar.show(share); });
        draft.clear();
        streams_.err << seconds_text() << " s of film, " << pictures_.size()
                     << (pictures_.size() == 1 ? " picture, in " : " pictures, in ") << options_.out << '\n';
    }

    void fill_folder() {
        host::FrameFiles files(options_.out, range_.first, range_.last, options_.file);
        if (!draw(files.draft())) { return; }
        for (const film::NumberedPicture& numbered : pictures_) {
            const View view = view_of(story_, numbered.number, ViewParts::without_matrix);
            files.add_drawn(numbered.number, view, seconds_to_look(view, 1.0 / options_.fps));
        }
        files.finish(manifest());
        streams_.err << pictures_.size() << (pictures_.size() == 1 ? " picture" : " pictures")
                     << " and manifest.json in " << options_.out << '\n';
    }

    /// Draws what is missing. @return false for a shard, whose pictures wait for the other shards
    bool draw(host::FrameDraft& draft) {
        const std::string advice = panels::advice_for(panels::characters_of(story_.lesson()));
        if (!advice.empty()) { streams_.err << advice << '\n'; }
        const bool is_shard = !options_.shard.empty();
        if (is_shard) {
            draft.join(run(), host::FrameDraft::Joined::shard);
        } else if (options_.resume) {
            draft.go_on(run());
        } else {
            draft.begin(run());
        }
        // the next --resume finds the pictures that an interrupted run has drawn
        if (options_.resume) { draft.leave(); }
        draw_shard(draft);
        if (!is_shard) { return true; }
        streams_.err << shard().size() << " of " << pictures_.size() << " pictures drawn (part "
                     << options_.shard << "); after all parts give --resume instead of --shard\n";
        return false;
    }

    void draw_shard(const host::FrameDraft& draft) {
        ProgressBar bar(streams_, "drawing");
        const std::span<const film::NumberedPicture> mine = shard();
        const auto show = [&](std::size_t there) {
            bar.show(static_cast<double>(there) / static_cast<double>(mine.size()));
        };
        const int jobs = jobs_for(mine.size());
        if (jobs <= 1) {
            film::draw_missing(drawn_, mine, draft, show);
            return;
        }
        film::run_parts(streams_.command_line, jobs, draft.folder(), [&] {
            show(static_cast<std::size_t>(std::ranges::count_if(mine, [&](const auto& numbered) {
                return fs::exists(draft.folder() / host::frame_name(numbered.number));
            })));
        });
    }

    int jobs_for(std::size_t pictures) const {
        const bool can_start = !streams_.command_line.empty() && fs::is_regular_file(options_.file);
        if (!can_start) {
            if (options_.jobs <= 1) { return 1; }
            throw bad_input("--jobs needs a lesson in a file: each process reads it");
        }
        if (options_.jobs > 0) { return static_cast<int>(std::min(pictures, std::size_t(options_.jobs))); }
        const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
        return static_cast<int>(std::min(cores, pictures / kPicturesWorthAJob));
    }

    std::span<const film::NumberedPicture> shard() const {
        return film::part_of(pictures_, checked_.shard.part, checked_.shard.parts);
    }

    fs::path draft_folder() const {
        return options_.format() ? fs::path(options_.out + ".unfinished")
                                 : host::FrameFolder::draft_folder(options_.out);
    }

    /// Everything that the pictures depend on.
    Json run() const {
        const bool is_file = fs::is_regular_file(options_.file);
        if (!is_file && (options_.resume || !options_.shard.empty())) {
            throw bad_input("--resume and --shard need a lesson in a file: it is compared");
        }
        return {
            {"format", "jointwise run"},
            {"lesson_sha256", is_file ? host::sha256_of(options_.file) : "none"},
            {"tried", changed_.done},
            {"size", {checked_.size.width, checked_.size.height}},
            {"fps", options_.fps},
            {"range", {range_.first, range_.last}},
            {"tween", options_.format() && !options_.no_tween},
            {"film", options_.format().has_value()},
            {"look", look()},
            {"camera", options_.camera},
            {"language", language()},
            {"drawn_with", drawn_with_}};
    }

    Json look() const {
        return {
            {"dark", options_.dark},
            {"text", options_.text},
            {"panels", !options_.no_panel},
            {"transparent", options_.transparent}};
    }

    static Json drawn_with() {
        Json with = Json::object();
        // read while Mesa is loaded
        render::settle_mesa();
        std::future<host::Environment> fonts = std::async(std::launch::async, host::font_environment);
        const std::string renderer = render::Offscreen(1, 1, 1).renderer();
        for (const auto& [name, version] : host::environment(renderer, fonts.get())) { with[name] = version; }
        return with;
    }

    Json manifest() const {
        Json manifest{
            {"format", "jointwise render"},
            {"version", kJsonVersion},
            {"lesson", {{"file", story_.lesson().file_name}, {"title", story_.lesson().title}}},
            {"size", {checked_.size.width, checked_.size.height}},
            {"fps", options_.fps},
            {"look", look()},
            {"drawn_with", drawn_with_},
            {"frames_in_all", story_.steps().size()}};
        add_done(manifest, changed_.done);
        return manifest;
    }

    std::string seconds_text() const { return fixed_text(film::seconds_of(film_), 1); }

    const RenderOptions& options_;
    const CheckedRender& checked_;
    const ChangedLesson& changed_;
    const Story& story_;
    FrameRange range_;
    const Streams& streams_;
    film::DrawnLesson drawn_;
    Json drawn_with_;
    std::vector<film::FilmPicture> film_;  ///< empty for a folder
    std::vector<film::NumberedPicture> pictures_;
};

/// The moments of the motion; empty (last before first) if the motion is not reached.
FrameRange motion_of(const Story& story) {
    const int frames = static_cast<int>(story.steps().size());
    FrameRange motion{frames, frames - 1};
    for (int k = frames - 1; k >= 0; --k) {
        const Step::Kind kind = story.steps()[static_cast<std::size_t>(k)].kind;
        if (kind == Step::Kind::motion) { motion.first = k; }
        if (kind == Step::Kind::answer && motion.last == k) { motion.last = k - 1; }
    }
    if (motion.first > motion.last && story.failure() == nullptr) {
        throw bad_input(
            "--motion-only, but nothing moves in this lesson; expected a lesson with [motion] or [dynamics]");
    }
    return motion;
}

/// The steps that are drawn; empty (last before first) if only the motion is wanted and it is not reached.
FrameRange range_of(const RenderOptions& options, const Story& story) {
    const int frames = static_cast<int>(story.steps().size());
    if (options.frames) { return frame_range(*options.frames, frames); }
    if (options.motion_only) { return motion_of(story); }
    const film::StepRange steps = film::steps_between(options.from, options.to, story);
    return {steps.first, steps.last};
}

Exit render_command(const RenderOptions& options, const Streams& streams) {
    const CheckedRender checked_options = checked(options);
    ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    if (checked_options.camera) {
        // only the direction of the eye is set; its distance and target are found again
        changed.lesson.camera.from = checked_options.camera;
    }
    const Lesson& lesson = changed.lesson;
    streams.err << done_text(changed.done);
    StoryOptions how;
    how.intervals = film::intervals_for(lesson, options.fps);
    const Story story(lesson, how);
    const FrameRange range = range_of(options, story);
    if (range.first > range.last) { throw not_reached(lesson, *story.failure()); }
    RenderRun(options, checked_options, changed, story, range, streams).carry_out();
    // a part reports nothing: the process that has started it tells the same story
    const Step* const failed = film::part_of_environment() ? nullptr : story.failure();
    if (failed == nullptr) { return Exit::done; }
    streams.err << not_reached(lesson, *failed).what() << '\n';
    return Exit::numerics;
}

}  // namespace

void add_render(const CommandLine& line) {
    auto [command, options] = add_command<RenderOptions>(
        line, "render", "draw a lesson as a film, or as PNG pictures", render_command,
        "Example: jointwise render lessons/catalogue/loops/four-bar.toml --out four-bar.mp4 --size "
        "1920x1080");
    add_render_options(command, options);
}

}  // namespace jw
