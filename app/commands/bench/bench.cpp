#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/commands/bench/bench.hpp"
#include "app/commands/options/dynamics_options.hpp"
#include "app/commands/options/shared_options.hpp"
#include "app/commands/plot_picture.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/panels/plot/comparison.hpp"
#include "app/session/benchmark/prices.hpp"
#include "app/session/output/export.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"
#include "lessons/files/catalogue.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"

namespace jw {

namespace {

struct BenchOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> methods;
    std::string treatment = "projection";
    std::string coordinates;
    std::string format;
    std::string picture;
    bool kinematics = false;
    bool render = false;
    std::string size = "1280x720";
};

struct SceneResult {
    std::string name;
    Reference reference;
    std::vector<BenchRun> runs;
};

/// Lesson files: paths as given, or names of shipped scenes of dynamics, including the large ones.
std::vector<std::filesystem::path> files_of(const std::vector<std::string>& scenes) {
    std::vector<std::filesystem::path> shipped = lessons_below(catalogue_folder() / "dynamics");
    const std::vector<std::filesystem::path> large =
        lessons_below(catalogue_folder().parent_path() / "benchmark");
    shipped.insert(shipped.end(), large.begin(), large.end());
    return scenes.empty() ? shipped : named_lessons(scenes, shipped);
}

/// Adds the shipped references of the lessons.
std::vector<std::filesystem::path> read_with(std::vector<std::filesystem::path> files) {
    const std::filesystem::path references = catalogue_folder().parent_path() / "reference";
    for (std::size_t k = 0, lessons = files.size(); k < lessons; ++k) {
        files.push_back(references / (files[k].stem().string() + ".csv"));
    }
    return files;
}

BenchPlan plan_of(const BenchOptions& options) {
    BenchPlan plan;
    for (const std::string& name : options.methods) {
        plan.methods.push_back(std::ranges::find(kMethods, name, &MethodName::name)->method);
    }
    plan.treatment = std::ranges::find(kTreatments, options.treatment, &TreatmentName::name)->treatment;
    for (const FormulationName& entry : kFormulations) {
        if (options.coordinates == entry.name) { plan.formulation = entry.formulation; }
    }
    return plan;
}

/// A column for the methods, and columns for numbers about them.
std::vector<TextColumn> columns_for(std::size_t numbers) {
    std::vector<TextColumn> columns(numbers + 1, {true, 10, 1});
    columns.front() = {false, 14, 0};
    return columns;
}

/// Table of all runs: cost and error.
std::string runs_text(const SceneResult& result) {
    TextRows table{
        {"method", "setting", "CPU ms", "position m", "velocity", "energy", "constraint", "evaluations",
         "steps", "rejected"}};
    for (const BenchRun& run : result.runs) {
        for (const BenchPoint& p : run.points) {
            table.push_back(
                {std::string(entry_of(run.method).name), number_cell("%.0e", p.setting),
                 number_cell("%.3g", 1e3 * p.cpu), number_cell("%.1e", p.position),
                 number_cell("%.1e", p.velocity), number_cell("%.1e", p.energy),
                 number_cell("%.1e", p.violation), std::to_string(p.counts.evaluations),
                 std::to_string(p.counts.steps), std::to_string(p.counts.rejected)});
        }
    }
    return text_table(table, columns_for(9));
}

std::string prices_text(const SceneResult& result) {
    TextRows table{{"ms to reach"}};
    for (std::size_t level = 0; level < kErrorLevels.size(); ++level) {
        table.front().push_back(level_text(level));
    }
    for (const PriceRow& row : prices_of(result.runs).rows) {
        table.push_back({row.name});
        for (const auto& time : row.milliseconds) {
            table.back().push_back(time ? number_cell("%.3g", *time) : "-");
        }
    }
    return text_table(table, columns_for(kErrorLevels.size()));
}

void write_table(const SceneResult& result, std::ostream& out) {
    out << result.name << "\n  reference: " << result.reference.origin << "\n";
    out << runs_text(result) << prices_text(result);
    for (const BenchRun& run : result.runs) {
        const auto failed =
            std::ranges::find_if(run.points, [](const auto& p) { return !p.failure.empty(); });
        if (failed == run.points.end()) { continue; }
        out << entry_of(run.method).name << " at " << number_cell("%.0e", failed->setting) << ": "
            << failed->failure << '\n';
    }
    out << '\n' << std::flush;
}

void write_csv_rows(const SceneResult& result, std::ostream& out) {
    for (const BenchRun& run : result.runs) {
        for (const BenchPoint& p : run.points) {
            out << csv_cell(result.name) << ',' << entry_of(run.method).name << ',' << csv_number(p.setting)
                << ',' << csv_number(1e3 * p.cpu) << ',' << csv_number(p.position) << ','
                << csv_number(p.velocity) << ',' << csv_number(p.energy) << ',' << csv_number(p.violation)
                << ',' << p.counts.evaluations << ',' << p.counts.steps << ',' << p.counts.rejected << '\n';
        }
    }
}

Json json_of(const SceneResult& result) {
    const auto number = [](double value) { return std::isnan(value) ? Json() : Json(value); };
    Json runs = Json::array();
    for (const BenchRun& run : result.runs) {
        Json points = Json::array();
        for (const BenchPoint& p : run.points) {
            points.push_back(
                {{"setting", p.setting},
                 {"cpu_s", p.cpu},
                 {"position_m", number(p.position)},
                 {"velocity_m_per_s", number(p.velocity)},
                 {"energy", number(p.energy)},
                 {"constraint", number(p.violation)},
                 {"evaluations", p.counts.evaluations},
                 {"steps", p.counts.steps},
                 {"rejected", p.counts.rejected},
                 {"failure", p.failure.empty() ? Json() : Json(p.failure)}});
        }
        runs.push_back({{"method", entry_of(run.method).name}, {"points", points}});
    }
    return {{"scene", result.name}, {"reference", result.reference.origin}, {"runs", runs}};
}

SceneResult bench_scene(const std::filesystem::path& file, const BenchPlan& plan, const Streams& streams) {
    const Lesson lesson = lesson_of(file, streams);
    if (!lesson.dynamics || !lesson.dynamics->point) {
        throw CommandError(
            Exit::bad_input, file.string() +
                                 ": error: no [dynamics] with a 'point' whose path can be compared\n"
                                 "hint: docs/writing-a-lesson.md");
    }
    SceneResult result;
    result.name = file.stem().string();
    const auto stored = stored_reference(file);
    try {
        result.reference = stored ? *stored : own_reference(lesson);
        result.runs = bench_dynamics(lesson, result.reference, plan);
    } catch (const std::invalid_argument& error) {
        throw CommandError(Exit::bad_input, file.string() + ": error: " + error.what());
    } catch (const std::runtime_error& error) {
        throw CommandError(Exit::numerics, file.string() + ": error: " + error.what());
    }
    return result;
}

Exit bench_command(const BenchOptions& options, const Streams& streams) {
    if (options.kinematics) { return bench_kinematics(options.scenes, options.format, streams); }
    if (options.render) {
        return bench_render(
            options.scenes, size_option(options.size, {960, 540}, {3840, 2160}), options.format, streams);
    }
    const BenchPlan plan = plan_of(options);
    const std::vector<std::filesystem::path> files = files_of(options.scenes);
    if (!options.picture.empty() && files.size() != 1) {
        throw bad_option("bench", "--picture draws one scene; name one");
    }
    if (!options.picture.empty()) { check_output("--picture", options.picture, read_with(files)); }
    Json scenes = Json::array();
    if (options.format == "csv") {
        streams.out << "scene,method,setting,cpu_ms,position_m,velocity_m_per_s,energy,constraint,"
                       "evaluations,steps,rejected\n";
    }
    for (const std::filesystem::path& file : files) {
        const SceneResult result = bench_scene(file, plan, streams);
        if (options.format == "table") { write_table(result, streams.out); }
        if (options.format == "csv") { write_csv_rows(result, streams.out); }
        if (options.format == "json") { scenes.push_back(json_of(result)); }
        if (!options.picture.empty()) {
            const Prices prices = prices_of(result.runs);
            const render::Image image =
                picture_of_panel(1280, 720, [&](const panels::Canvas& canvas, const panels::Box& box) {
                    panels::price_panel(canvas, box, prices, result.name, {});
                });
            render::write_file_atomically(options.picture, render::encode_png(image));
        }
    }
    if (options.format == "json") {
        const Json json{{"format", "jointwise bench"}, {"version", kJsonVersion}, {"scenes", scenes}};
        streams.out << json_document(json);
    }
    return Exit::done;
}

}  // namespace

void add_bench(const CommandLine& line) {
    auto [command, options] = add_command<BenchOptions>(
        line, "bench", "compare methods by time and error", bench_command,
        "Example: jointwise bench andrews --method explicit-8 --picture andrews.png");
    add_value(
        command, "SCENE", options.scenes, "",
        "lesson files or names of shipped scenes; default: all shipped scenes");
    CLI::Option* method =
        add_value(
            command, "--method", options.methods, "NAME",
            "one or several methods; default: explicit-5, explicit-8, implicit-5, implicit-9")
            ->check(CLI::IsMember(names_of(kMethods)));
    CLI::Option* treatment =
        add_value(command, "--treatment", options.treatment, "NAME", "treatment of the constraints")
            ->check(CLI::IsMember(names_of(kTreatments)));
    CLI::Option* coordinates =
        add_value(
            command, "--coordinates", options.coordinates, "NAME",
            "coordinates of explicit methods: joints or bodies; default: joints where they are faster")
            ->check(CLI::IsMember(names_of(kFormulations)));
    CLI::Option* picture =
        add_value(command, "--picture", options.picture, "FILE", "work-precision plot as PNG, for one scene");
    CLI::Option* kinematics = command.add_flag(
        "--kinematics", options.kinematics,
        "benchmark the kinematics instead: position, velocity and acceleration of driven lessons in every "
        "choice of coordinates and rows");
    CLI::Option* drawing = command.add_flag(
        "--render", options.render,
        "measure the time of each stage of a picture of the motion, beside a plain loop with "
        "stb_image_write");
    add_value(command, "--size", options.size, "WxH", "size in pixels of the pictures of --render")
        ->capture_default_str()
        ->needs(drawing);
    for (CLI::Option* other : {kinematics, drawing}) {
        other->excludes(method, treatment, coordinates, picture);
    }
    kinematics->excludes(drawing);
    add_format_option(command, options.format, {"table", "csv", "json"});
}

}  // namespace jw
