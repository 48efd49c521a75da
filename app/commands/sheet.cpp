#include <CLI/CLI.hpp>

#include <filesystem>

#include "app/commands/exercise_figure.hpp"
#include "app/commands/options/course_option.hpp"
#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/exercises/grading/sheet.hpp"
#include "app/exercises/starters.hpp"
#include "render/files/atomic_file.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

struct SheetOptions {
    std::vector<std::string> files;
    std::string student;
    std::string roster;
    int variants = 0;
    std::string key;
    std::string out;
    std::string format;
    bool solution = false;
    bool without_figures = false;
};

std::vector<std::string> students_of(const SheetOptions& options) {
    const int ways =
        (options.student.empty() ? 0 : 1) + (options.roster.empty() ? 0 : 1) + (options.variants > 0 ? 1 : 0);
    if (ways != 1) { throw bad_input("expected one of --student ID, --class FILE and --variants N"); }
    if (!options.student.empty()) {
        const std::string fault = fault_of_student(options.student);
        if (!fault.empty()) { throw bad_input(fault); }
        return {options.student};
    }
    std::vector<std::string> students;
    for (int k = 1; k <= options.variants; ++k) { students.push_back("variant-" + std::to_string(k)); }
    if (options.variants > 0) { return students; }
    Roster roster = read_roster(options.roster);
    if (!roster.problem.empty()) { throw CommandError(Exit::bad_input, roster.problem); }
    return std::move(roster.students);
}

void write_text(const fs::path& path, const std::string& text) { render::write_file_atomically(path, text); }

/// For each exercise that asks for a program: a starter in every language, and the input.
void write_starters(const Sheet& sheet, const fs::path& folder) {
    for (const SheetEntry& entry : sheet.entries) {
        const Exercise& exercise = entry.task.exercise();
        if (exercise.kind != ExerciseKind::code) { continue; }
        make_folder(folder);
        for (const std::string_view ending : kStarterEndings) {
            write_text(folder / (exercise.name + std::string(ending)), starter_text(entry.task, ending));
        }
        write_text(folder / (exercise.name + "-input.json"), program_input(entry.task));
    }
}

void write_sheet(const Sheet& sheet, const fs::path& folder, bool solution) {
    make_folder(folder);
    bool figures = false;
    for (const SheetEntry& entry : sheet.entries) {
        if (!entry.file.empty()) { write_text(folder / entry.file, entry.file_text); }
        if (entry.figure.empty()) { continue; }
        if (!figures) { make_folder(folder / "figures"); }
        figures = true;
        render::write_file_atomically(
            folder / "figures" / (entry.task.exercise().name + ".png"), entry.figure);
    }
    write_starters(sheet, folder / kStartersFolder);
    write_text(folder / "sheet.md", sheet_markdown(sheet, false));
    write_text(folder / "sheet.html", sheet_html(sheet, false));
    write_text(folder / kAnswersFile, answers_template(sheet, false));
    if (!solution) { return; }
    make_folder(folder / "solution");
    write_text(folder / "solution" / "sheet.html", sheet_html(sheet, true));
    write_text(folder / "solution" / kAnswersFile, answers_template(sheet, true));
    for (const SheetEntry& entry : sheet.entries) {
        const KindOfExercise& kind = kind_of(entry.task.exercise().kind);
        if (std::string(kind.file) == ".toml") {
            write_text(folder / "solution" / entry.file, kind.right(entry.task).text);
        }
    }
}

void write_quiz(
    const std::vector<Sheet>& sheets, const std::string& title, const fs::path& out, const Streams& streams) {
    make_folder(out);
    write_text(out / "moodle.xml", moodle_xml(sheets, title));
    for (const std::string& name : not_for_quizzes(sheets.front())) {
        streams.err << "jointwise: note: exercise '" << name
                    << "' cannot be asked in a quiz; it is left out\n";
    }
}

Exit make_sheets(const SheetOptions& options, const Streams& streams) {
    const std::vector<std::string> students = students_of(options);
    const ExerciseSet set = exercises_of(options.files);
    const CourseKey key = key_of(options.key);
    const ReadyCourse course = ready_or_refused(key, set);
    std::unique_ptr<ExerciseFigures> figures;
    FigureOf figure;
    if (!options.without_figures) {
        figures = std::make_unique<ExerciseFigures>(640, 400);
        figure = [&](const Lesson& lesson, bool as_given) { return figures->png_of(lesson, as_given); };
    }
    ProgressBar progress(streams, "sheets");
    std::vector<Sheet> sheets;
    std::string problems;
    for (std::size_t k = 0; k < students.size(); ++k) {
        progress.show(static_cast<double>(k) / static_cast<double>(students.size()));
        Sheet sheet = sheet_of(course, students[k], set.title, figure);
        problems += sheet.problem;
        if (options.format == "moodle") {
            sheets.push_back(std::move(sheet));
        } else {
            write_sheet(sheet, fs::path(options.out) / students[k], options.solution);
        }
    }
    if (options.format == "moodle") { write_quiz(sheets, set.title, options.out, streams); }
    if (!problems.empty()) { throw CommandError(Exit::numerics, problems); }
    const std::string what = options.format == "moodle" ? "moodle.xml is"
                             : students.size() == 1     ? "1 sheet is"
                                                        : std::to_string(students.size()) + " sheets are";
    streams.out << what << " in '" << options.out << "'\n";
    return Exit::done;
}

}  // namespace

void add_sheet(const CommandLine& line) {
    auto [command, options] = add_command<SheetOptions>(
        line, "sheet", "write sheets of exercises, with different numbers for each student", make_sheets,
        "Example: jointwise sheet lessons/exercises/vectors.toml --student s1 --key key.toml --out sheets");
    add_value(command, "FILE", options.files, "", "files of exercises, or lessons with [[exercise]]")
        ->required();
    add_value(command, "--student", options.student, "ID", "a sheet for one student");
    add_value(
        command, "--class", options.roster, "FILE",
        "a sheet for each student in the first column of a list (CSV)");
    add_value(
        command, "--variants", options.variants, "N", "N sheets without a student, for example for a quiz")
        ->check(CLI::Range(1, 1000));
    add_value(command, "--key", options.key, "FILE", "key file of the course; it contains a secret")
        ->required();
    add_value(command, "--out", options.out, "FOLDER", "folder that gets a folder for each student")
        ->required();
    command.add_flag("--solution", options.solution, "write the solutions, too");
    command.add_flag("--no-figures", options.without_figures, "do not draw figures");
    add_format_option(command, options.format, {"files", "moodle"});
}

}  // namespace jw
