#include "app/commands/bench/bench.hpp"

#include <cmath>

#include "app/session/benchmark/kinematics_bench.hpp"
#include "app/session/output/export.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/text_table.hpp"
#include "lessons/files/catalogue.hpp"

namespace jw {

namespace {

/// Files: paths as given, or names in the catalogue; by default the whole catalogue except lessons that fail
/// on purpose.
std::vector<std::filesystem::path> driven_files_of(const std::vector<std::string>& scenes) {
    std::vector<std::filesystem::path> shipped = lessons_below(catalogue_folder());
    if (!scenes.empty()) { return named_lessons(scenes, shipped); }
    std::erase_if(shipped, [](const auto& file) { return file.parent_path().filename() == "hard"; });
    return shipped;
}

void write_table(const KinematicsScene& scene, std::ostream& out) {
    out << scene.name << ": " << scene.bodies << " moving bodies, " << scene.equations << " equations, "
        << scene.moments << " moments\n";
    TextRows table{
        {"coordinates", "rows", "us/moment", "ratio", "rounds", "position", "velocity", "acceleration",
         "missed"}};
    const double first = scene.runs.front().microseconds;
    for (const KinematicsRun& run : scene.runs) {
        table.push_back(
            {run.coordinates, run.rows, number_cell("%.1f", run.microseconds),
             number_cell("%.2f", run.microseconds / first), number_cell("%.1f", run.iterations),
             number_cell("%.1e", run.position), number_cell("%.1e", run.velocity),
             number_cell("%.1e", run.acceleration), std::to_string(run.missed)});
    }
    std::vector<TextColumn> columns(table.front().size());
    columns[0] = columns[1] = {false, 0, 2};
    out << text_table(table, columns) << '\n' << std::flush;
}

void write_csv_rows(const KinematicsScene& scene, std::ostream& out) {
    for (const KinematicsRun& run : scene.runs) {
        out << csv_cell(scene.name) << ',' << run.coordinates << ',' << run.rows << ','
            << csv_number(run.microseconds) << ',' << csv_number(run.iterations) << ','
            << csv_number(run.position) << ',' << csv_number(run.velocity) << ','
            << csv_number(run.acceleration) << ',' << run.missed << '\n';
    }
}

Json json_of(const KinematicsScene& scene) {
    Json runs = Json::array();
    for (const KinematicsRun& run : scene.runs) {
        runs.push_back(
            {{"coordinates", run.coordinates},
             {"rows", run.rows},
             {"us_per_moment", run.microseconds},
             {"newton_iterations", std::isnan(run.iterations) ? Json() : Json(run.iterations)},
             {"position", run.position},
             {"velocity", run.velocity},
             {"acceleration", run.acceleration},
             {"missed", run.missed}});
    }
    return {
        {"scene", scene.name},
        {"bodies", scene.bodies},
        {"equations", scene.equations},
        {"moments", scene.moments},
        {"runs", runs}};
}

}  // namespace

Exit bench_kinematics(
    const std::vector<std::string>& scenes, const std::string& format, const Streams& streams) {
    Json all = Json::array();
    if (format == "csv") {
        streams.out << "scene,coordinates,rows,us_per_moment,newton_iterations,position,velocity,"
                       "acceleration,missed\n";
    }
    for (const std::filesystem::path& file : driven_files_of(scenes)) {
        const auto scene = bench_kinematics(lesson_of(file, streams), file.stem().string());
        if (!scene) {
            if (scenes.empty()) { continue; }
            throw CommandError(
                Exit::bad_input, file.string() +
                                     ": error: no motion by drivers that can be followed to its end\n"
                                     "hint: docs/writing-a-lesson.md, [[driver]] and [motion]");
        }
        if (format == "table") { write_table(*scene, streams.out); }
        if (format == "csv") { write_csv_rows(*scene, streams.out); }
        if (format == "json") { all.push_back(json_of(*scene)); }
    }
    if (format == "json") {
        const Json json{{"format", "jointwise bench kinematics"}, {"version", kJsonVersion}, {"scenes", all}};
        streams.out << json_document(json);
    }
    return Exit::done;
}

}  // namespace jw
