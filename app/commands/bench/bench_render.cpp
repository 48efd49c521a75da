#include "app/commands/bench/bench.hpp"

#include <array>
#include <chrono>
#include <cstdlib>
#include <numeric>

#include "app/host/frames/frame_painter.hpp"
#include "app/session/output/export.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/text_table.hpp"
#include "lessons/files/catalogue.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/plain_png.hpp"
#include "render/files/png.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kFps = 30.0;
constexpr int kMostPictures = 150;

enum Stage { view, shadow, scene, panels, read, encode, write };
constexpr std::array<const char*, 7> kStages{"view and picture", "shadow", "scene", "panels",
                                             "read back",        "encode", "write"};

struct RenderTimes {
    std::string name;
    int pictures = 0;
    double first = 0.0;                           ///< from the start to the first file [s], without the story
    std::array<double, kStages.size()> stages{};  ///< per picture, one after the other [s]
    double loop = 0.0;                            ///< per picture from end to end, by a separate clock [s]
    double plain = 0.0;                           ///< per picture in the plain loop [s]

    double all() const { return std::accumulate(stages.begin(), stages.end(), 0.0); }
};

double seconds_since(Clock::time_point& last) {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last).count();
    last = now;
    return seconds;
}

/// A folder that is removed at the end.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "jointwise-bench-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) { throw std::runtime_error("there is no room in " + name); }
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    fs::path file() const { return path_ / "picture.png"; }

private:
    fs::path path_;
};

/// Steps of the motion at equal distances.
std::vector<int> moments_of(const Story& story) {
    std::vector<int> moments;
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        if (story.steps()[k].kind == Step::Kind::motion) { moments.push_back(static_cast<int>(k)); }
    }
    std::vector<int> chosen;
    const std::size_t count = std::min<std::size_t>(kMostPictures, moments.size());
    for (std::size_t k = 0; k < count; ++k) { chosen.push_back(moments[k * moments.size() / count]); }
    return chosen;
}

void measure_stages(
    const Story& story, host::FramePainter& painter, const std::vector<int>& steps, const fs::path& file,
    RenderTimes& times) {
    render::PngEncoder encoder;
    Clock::time_point begin = Clock::now();
    for (const int step : steps) {
        Clock::time_point last = Clock::now();
        const View shown = view_of(story, step);
        const Picture picture = painter.picture(shown);
        times.stages[Stage::view] += seconds_since(last);
        const render::Image image = painter.paint(shown, picture, [&](host::PaintStage stage) {
            times.stages[static_cast<std::size_t>(Stage::shadow) + static_cast<std::size_t>(stage)] +=
                seconds_since(last);
        });
        const std::vector<std::uint8_t>& png = encoder.encode(image);
        times.stages[Stage::encode] += seconds_since(last);
        render::write_file_atomically(file, png);
        times.stages[Stage::write] += seconds_since(last);
    }
    times.loop = seconds_since(begin) / times.pictures;
    for (double& stage : times.stages) { stage /= times.pictures; }
}

RenderTimes measure(const fs::path& file, const PixelSize& size, const Streams& streams) {
    const Lesson lesson = lesson_of(file, streams);
    StoryOptions how;
    const std::optional<MotionPlan> motion = shown_motion(lesson);
    how.intervals = motion ? std::max(1, static_cast<int>(motion->duration * kFps)) : 0;
    const Story story(lesson, how);
    const std::vector<int> steps = moments_of(story);
    if (steps.empty()) {
        throw CommandError(
            Exit::bad_input,
            file.string() +
                ": error: nothing moves in this lesson; expected one with [motion] or [dynamics]");
    }
    RenderTimes times;
    times.name = file.stem().string();
    times.pictures = static_cast<int>(steps.size());
    const ScratchFolder folder;

    Clock::time_point last = Clock::now();
    host::FramePainter painter(story, size.width, size.height);
    const auto paint = [&](int step) { return painter.paint(view_of(story, step)); };
    render::write_file_atomically(folder.file(), render::encode_png(paint(steps.front())));
    times.first = seconds_since(last);

    measure_stages(story, painter, steps, folder.file(), times);

    last = Clock::now();
    for (const int step : steps) {
        render::write_file_atomically(folder.file(), render::encode_png_plainly(paint(step)));
    }
    times.plain = seconds_since(last) / times.pictures;
    return times;
}

void write_table(const RenderTimes& times, const PixelSize& size, std::ostream& out) {
    out << times.name << ": " << times.pictures << " pictures of the motion, " << size.width << "x"
        << size.height << "; first picture after " << number_cell("%.0f", 1e3 * times.first) << " ms\n";
    TextRows table{{"stage", "ms", "share"}};
    for (std::size_t k = 0; k < kStages.size(); ++k) {
        table.push_back(
            {kStages[k], number_cell("%.2f", 1e3 * times.stages[k]),
             number_cell("%.0f", 100.0 * times.stages[k] / times.all()) + " %"});
    }
    // the time that the clocks of the stages have missed
    table.push_back({"between them", number_cell("%.2f", 1e3 * (times.loop - times.all())), ""});
    table.push_back(
        {"all, one after the other", number_cell("%.2f", 1e3 * times.all()),
         number_cell("%.1f", 1.0 / times.all()) + " a second"});
    table.push_back(
        {"plain loop", number_cell("%.2f", 1e3 * times.plain),
         number_cell("%.2f", times.plain / times.all()) + " times as long"});
    std::vector<TextColumn> columns(3);
    columns[0] = {false, 24, 2};
    out << text_table(table, columns) << '\n' << std::flush;
}

Json json_of(const RenderTimes& times) {
    Json stages = Json::object();
    for (std::size_t k = 0; k < kStages.size(); ++k) { stages[kStages[k]] = times.stages[k]; }
    return {
        {"scene", times.name},
        {"pictures", times.pictures},
        {"first_picture_s", times.first},
        {"stages_s", stages},
        {"all_s", times.all()},
        {"loop_s", times.loop},
        {"plain_loop_s", times.plain},
        {"speedup", times.plain / times.all()}};
}

}  // namespace

Exit bench_render(
    const std::vector<std::string>& scenes, const PixelSize& size, const std::string& format,
    const Streams& streams) {
    std::vector<fs::path> files{catalogue_folder() / "loops" / "four-bar.toml"};
    if (!scenes.empty()) { files = named_lessons(scenes, lessons_below(catalogue_folder())); }
    Json results = Json::array();
    if (format == "csv") { streams.out << "scene,stage,ms\n"; }
    for (const fs::path& file : files) {
        const RenderTimes times = measure(file, size, streams);
        if (format == "table") { write_table(times, size, streams.out); }
        if (format == "json") { results.push_back(json_of(times)); }
        if (format != "csv") { continue; }
        for (std::size_t k = 0; k < kStages.size(); ++k) {
            streams.out << csv_cell(times.name) << ',' << kStages[k] << ','
                        << csv_number(1e3 * times.stages[k]) << '\n';
        }
        streams.out << csv_cell(times.name) << ",plain loop," << csv_number(1e3 * times.plain) << '\n';
    }
    if (format == "json") {
        streams.out << json_document(
            {{"format", "jointwise bench --render"},
             {"version", kJsonVersion},
             {"size", {size.width, size.height}},
             {"scenes", std::move(results)}});
    }
    return Exit::done;
}

}  // namespace jw
