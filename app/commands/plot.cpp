#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/plot_picture.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/view/series.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"

namespace jw {

namespace {

struct PlotOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::string of = "quantities";  ///< a word of kPlotted
    std::string joint;
    std::vector<std::string> curves;
    std::string out;
    std::string size = "1280x720";
};

constexpr PixelSize kSmallestPlot{320, 320};
constexpr PixelSize kLargestPlot{3840, 3840};

/// The joint whose pairs are plotted: the named joint, or else the joint that the story is about.
int joint_of(const PlotOptions& options, const Story& story) {
    if (options.joint.empty()) { return std::max(0, story.featured_joint()); }
    return static_cast<int>(place_in(
        names_of(story.lesson().mechanism.joints), options.joint,
        "--joint " + in_quotes(options.joint) + ": no such joint"));
}

enum class Plotted { quantities, residuals, singular_values, conditions };
constexpr std::array kPlotted{
    EnumWord<Plotted>{Plotted::quantities, "quantities", "quantities over time"},
    EnumWord<Plotted>{Plotted::residuals, "residuals", "‖Φ‖ over all iterations"},
    EnumWord<Plotted>{Plotted::singular_values, "singular-values", "singular values over time"},
    EnumWord<Plotted>{Plotted::conditions, "conditions", "condition of the pairs over time"}};

Plotted plotted(const PlotOptions& options) { return *value_of(kPlotted, options.of); }

SeriesSet set_of(const PlotOptions& options, const Story& story) {
    switch (plotted(options)) {
        case Plotted::quantities: return motion_series(story);
        case Plotted::residuals: return newton_series(story);
        case Plotted::singular_values: return singular_value_series(story);
        case Plotted::conditions: break;
    }
    return condition_series(story, joint_of(options, story));
}

std::vector<int> chosen(const SeriesSet& set, const std::vector<std::string>& curves) {
    std::vector<int> shown;
    for (const std::string& curve : curves) {
        shown.push_back(
            static_cast<int>(place_in(names_of(set.series), curve, "no curve " + in_quotes(curve))));
    }
    std::ranges::sort(shown);
    return shown;
}

/// The chosen curves by their present names; quantities that are plotted only on request are added to `set`.
std::vector<std::string> found_curves(
    const PlotOptions& options, const Story& story, SeriesSet& set, const Streams& streams) {
    if (plotted(options) != Plotted::quantities) { return options.curves; }
    std::vector<std::string> names;
    for (const std::string& curve : options.curves) {
        names.push_back(curve);
        if (std::ranges::find(set.series, curve, &Series::name) != set.series.end()) { continue; }
        const Mechanism& mechanism = story.lesson().mechanism;
        const std::vector<NamedQuantity> found = quantities_named("--curves", {curve}, mechanism, streams);
        add_series(set, story, found);
        names.back() = name_of(found[0].quantity, found[0].derivative, mechanism);
    }
    return names;
}

/// The set with only the chosen curves, from which a table is made.
SeriesSet only(SeriesSet set, const std::vector<int>& shown) {
    if (shown.empty()) { return set; }
    std::vector<Series> series;
    for (const int k : shown) { series.push_back(set.series[static_cast<std::size_t>(k)]); }
    set.series = std::move(series);
    set.telling.clear();
    return set;
}

Exit plot(const PlotOptions& options, const Streams& streams) {
    const PixelSize size = size_option(options.size, kSmallestPlot, kLargestPlot);
    const bool is_csv = options.out.ends_with(".csv");
    if (!is_csv && !options.out.ends_with(".png")) {
        throw bad_input("--out " + in_quotes(options.out) + "; expected a name that ends in .png or .csv");
    }
    check_output("--out", options.out, {options.file});
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    streams.err << done_text(changed.done);
    StoryOptions how;
    how.with_ranks = false;
    const Story story(changed.lesson, how);
    SeriesSet set = set_of(options, story);
    if (set.at.empty() && story.failure() != nullptr) { throw not_reached(changed.lesson, *story.failure()); }
    if (set.at.empty()) { throw bad_input("nothing to plot: " + set.why_empty); }
    panels::PlotState state;
    state.shown = chosen(set, found_curves(options, story, set, streams));
    if (is_csv) {
        render::write_file_atomically(options.out, csv_of(only(set, state.shown)));
    } else {
        const std::string title = changed.lesson.title + ": " + label_of(kPlotted, plotted(options));
        render::write_file_atomically(
            options.out, render::encode_png(picture_of_plot(set, state, title, size.width, size.height)));
    }
    streams.err << options.out << ": " << set.at.size() << " points\n";
    if (const Step* failed = story.failure()) {
        streams.err << not_reached(changed.lesson, *failed).what() << '\n';
        return Exit::numerics;
    }
    return Exit::done;
}

}  // namespace

void add_plot(const CommandLine& line) {
    auto [command, options] = add_command<PlotOptions>(
        line, "plot", "plot curves over time or iterations, as a picture or a table", plot,
        "Example: jointwise plot lessons/catalogue/loops/four-bar.toml --of singular-values --out sigma.png");
    add_lesson_options(command, options.file, options.experiments);
    add_value(command, "--of", options.of, "WHAT", "quantities, residuals, singular-values or conditions")
        ->check(CLI::IsMember(words_of(kPlotted)))
        ->capture_default_str();
    add_value(
        command, "--joint", options.joint, "NAME",
        "joint for --of conditions; default: the one that the lesson is about");
    add_value(
        command, "--curves", options.curves, "A,B",
        "names of curves, separated by commas; default: the most important ones")
        ->delimiter(',')
        ->allow_extra_args(false);
    add_value(command, "--out", options.out, "FILE", "FILE.png or FILE.csv")->required();
    add_value(command, "--size", options.size, "WxH", "size of the picture in pixels")->capture_default_str();
}

}  // namespace jw
