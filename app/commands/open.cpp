#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/exercises/grading/grade.hpp"
#include "app/exercises/practice/lesson_exercises.hpp"
#include "app/host/lesson/destination.hpp"
#include "app/host/screen.hpp"
#include "app/session/story/timeline.hpp"
#include "app/session/wording/messages.hpp"
#include "app/window.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/files/catalogue.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"
#include "render/surface/offscreen.hpp"

namespace jw {

namespace {

struct OpenOptions {
    std::string file;
    std::string at;
    std::vector<std::string> experiments;
    std::string size = "1280x720";
    bool dark = false;
    double text = 1.0;
    double density = 0.0;
    std::string tab = "step";
    std::string exercise;
    std::string picture;
};

// smaller windows have no room for a picture and a panel; larger sizes are typing errors
constexpr PixelSize kSmallestWindow{320, 200};
constexpr PixelSize kLargestWindow{7680, 7680};

/// @throws CommandError if the lesson has no such exercise
void begin(host::Host& host, const std::string& exercise) {
    if (host.begin_exercise(exercise)) { return; }
    std::string names;
    for (const PracticeExercise& offered : host.exercises().practice().exercises()) {
        names += (names.empty() ? "" : ", ") + offered.exercise->name;
    }
    throw bad_input(
        "--exercise '" + exercise + "'; the lesson has " +
        (names.empty() ? "no exercises" : "these: " + names));
}

/// Draws the window into a file, without a display.
void draw_window(const WindowSetup& setup, const std::string& path) {
    render::Offscreen surface(16, 16);
    host::Host host(setup.host);
    show_first(host, setup);
    if (!setup.exercise.empty()) { begin(host, setup.exercise); }
    host.wait_for_exercises();
    host::Screen screen(surface.gl(), host);
    // some frames for ImGui to find its sizes, and one per small picture of the browser
    constexpr int most = 2000;
    for (int k = 0; k < most && (k < 3 || host.seconds_to_change() <= 0.0 || !screen.is_complete()); ++k) {
        host.frame(1.0 / 60.0);
        host.wait_for_rest();
        screen.draw();
    }
    render::write_file_atomically(path, render::encode_png(screen.read()));
}

/// True for an address, or the URL of a page with an address; files do not have such names.
bool is_address(const std::string& text) {
    std::error_code error;
    return (text.starts_with('#') || text.find("://") != std::string::npos) &&
           !std::filesystem::exists(text, error);
}

/// @param name  empty: no exercise is wanted
/// @throws std::runtime_error if the lesson has no such exercise
void check_exercise(const std::filesystem::path& lesson, const std::string& name) {
    if (name.empty()) { return; }
    LessonExercisesReader reader(lesson, catalogue_folder());
    while (reader.read()) {}
    const auto is_it = [&](const PracticeExercise& offered) { return offered.exercise->name == name; };
    if (std::ranges::none_of(reader.found().exercises, is_it)) {
        throw std::runtime_error(tr("the lesson has no exercise '{0}'", name));
    }
}

/// The address given as FILE, with the additions of other options. Checks that all of it can be shown.
/// @param others  lessons outside the catalogue
host::Address address_in(
    const OpenOptions& options, const std::vector<std::filesystem::path>& others, const Streams& streams) {
    try {
        host::Address address = host::read_address(options.file);
        if (!options.at.empty()) { address.at = options.at; }
        std::ranges::copy(options.experiments, std::back_inserter(address.experiments));
        if (options.tab != word_of(host::kTabs, host::Tab::step)) { address.tab = options.tab; }
        if (address.lesson.empty()) { return {}; }
        host::tab_of(address);
        const auto file = host::lesson_at_address(address.lesson, catalogue_folder(), others);
        host::destination_of(lesson_of(file, streams), address);
        check_exercise(file, address.exercise);
        return address;
    } catch (const CommandError&) { throw; } catch (const std::runtime_error& error) {
        throw bad_input("address " + in_quotes(options.file) + ": " + error.what());
    }
}

Exit open(const OpenOptions& options, const Streams& streams) {
    const PixelSize size = size_option(options.size, kSmallestWindow, kLargestWindow);
    if (!std::isfinite(options.text)) { throw bad_input("--text is not finite; expected 0.75 to 1.5"); }
    if (!std::isfinite(options.density)) { throw bad_input("--density is not finite; expected 0 to 8"); }
    if (!options.picture.empty()) { check_output("--picture", options.picture, {options.file}); }
    WindowSetup setup;
    setup.host.catalogue = catalogue_folder();
    setup.host.recent_file = host::RecentLessons::usual_file();
    setup.host.unsaved = setup.host.recent_file.empty() ? "jointwise-unsaved"
                                                        : setup.host.recent_file.parent_path() / "unsaved";
    setup.host.progress = Progress::usual_file();
    setup.host.judge_program = judge_program_file;
    setup.exercise = options.exercise;
    setup.log = &streams.err;
    setup.host.dark = options.dark;
    setup.host.text_scale = static_cast<float>(options.text);
    setup.host.width = size.width;
    setup.host.height = size.height;
    setup.host.density = static_cast<float>(options.density);
    setup.host.tab = *value_of(host::kTabs, options.tab);
    if (is_address(options.file)) {
        // pictures must not depend on what was opened before
        const host::RecentLessons recent(options.picture.empty() ? setup.host.recent_file : "");
        setup.address = address_in(options, recent.paths(), streams);
    } else if (!options.file.empty()) {
        // mistakes are reported before a window opens
        const Lesson lesson = lesson_of(options.file, options.experiments, streams).lesson;
        if (!options.at.empty() && !step_at(Story(lesson), options.at)) {
            throw bad_input(
                "--at '" + options.at +
                "'; expected a step from 1 on, a joint or driver of the lesson, or t=SECONDS");
        }
        setup.file = options.file;
        setup.at = options.at;
        setup.experiments = options.experiments;
    }
    if (!options.picture.empty()) {
        // the picture must not depend on what was opened before
        setup.host.recent_file.clear();
        setup.host.unsaved.clear();
        setup.host.progress.clear();
        draw_window(setup, options.picture);
        return Exit::done;
    }
    run_window(setup);
    return Exit::done;
}

}  // namespace

void add_open(const CommandLine& line) {
    auto [command, options] = add_command<OpenOptions>(
        line, "open", "open the window, with a lesson or the list of lessons", open,
        "Example: jointwise open lessons/catalogue/loops/four-bar.toml --at B\n"
        "         jointwise open '#four-bar/D?try=form+D+drop+x'");
    add_value(
        command, "FILE", options.file, "",
        "lesson file, or address of a page; without it, the list of lessons is shown");
    add_value(command, "--at", options.at, "STEP", "where to begin: a step, a joint or driver, or t=SECONDS");
    add_try_option(command, options.experiments);
    add_value(command, "--size", options.size, "WxH", "size of the window")->capture_default_str();
    command.add_flag("--dark", options.dark, "light text on a dark background");
    add_value(command, "--text", options.text, "X", "size of text, 0.75 to 1.5")
        ->check(CLI::Range(0.75, 1.5))
        ->capture_default_str();
    add_value(
        command, "--density", options.density, "X",
        "pixels of the screen per pixel of a web page: 3 on most phones; 0: not known")
        ->check(CLI::Range(0.0, 8.0))
        ->capture_default_str();
    add_value(
        command, "--tab", options.tab, "TAB",
        "tab beside the picture: step, try, plots, newton, price, exercises or rest")
        ->check(CLI::IsMember(words_of(host::kTabs)))
        ->capture_default_str();
    add_value(command, "--exercise", options.exercise, "NAME", "exercise of the lesson to begin with");
    add_value(
        command, "--picture", options.picture, "FILE", "draw what the window shows into a PNG file instead");
}

}  // namespace jw
