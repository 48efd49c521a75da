#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>

#include "app/commands/check/check_report.hpp"
#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/exercises/check_exercise.hpp"
#include "app/session/claims/checks.hpp"
#include "app/session/try/trials.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

struct CheckOptions {
    std::vector<std::string> paths;  ///< lesson files and folders
    std::vector<std::string> experiments;
    std::string format;
    CheckStyle style;
};

/// Carries out the experiments; the lesson keeps the claims that can still be judged.
Lesson changed_lesson(const Lesson& written, const CheckOptions& options, CheckedLesson& checked) {
    Session session(written);
    checked.tried = carry_out_all(session, options.experiments);
    Lesson changed = session.lesson();
    changed.claims = carried_claims(written, changed);
    checked.not_judged = static_cast<int>(written.claims.size() - changed.claims.size());
    return changed;
}

/// Number of students for whom variants of an exercise are drawn and solved.
constexpr int kStudents = 5;

/// Warns about texts of a lesson, or of exercises, after reading.
template <class Read>
void warn_about_texts(
    const std::string& file, const Read& read, CheckedLesson& checked, const Streams& streams) {
    for (Diagnostic& warning : warnings_about_texts(file, read.texts)) {
        streams.err << to_string(warning, read.source);
        checked.diagnostics.push_back(std::move(warning));
    }
}

/// The exercises of a lesson or of a file of exercises.
void check_exercises_of(const std::string& file, CheckedLesson& checked, const Streams& streams) {
    const ExercisesRead read = read_exercise_file(file);
    if (!read.diagnostics.empty()) { throw FaultyFile(read.report(), read.diagnostics); }
    warn_about_texts(file, read, checked, streams);
    if (checked.title.empty()) { checked.title = read.title; }
    std::ranges::move(check_exercises(read.exercises, kStudents), std::back_inserter(checked.claims));
}

CheckedLesson checked_lesson(const std::string& file, const CheckOptions& options, const Streams& streams) {
    CheckedLesson checked;
    checked.file = file;
    const ExerciseTables tables = exercise_tables_in(file);
    if (tables == ExerciseTables::alone) {
        check_exercises_of(file, checked, streams);
        return checked;
    }
    Lesson lesson = lesson_of(file, streams);
    checked.title = lesson.title;
    if (std::error_code error; fs::is_regular_file(file, error)) {
        warn_about_texts(file, read_lesson_file(file), checked, streams);
    }
    if (!options.experiments.empty()) { lesson = changed_lesson(lesson, options, checked); }
    checked.claims = check_claims(lesson);
    // the user's experiments replace those that the author proposes
    if (options.experiments.empty()) {
        std::ranges::move(check_trials(lesson), std::back_inserter(checked.claims));
        if (tables == ExerciseTables::in_lesson) { check_exercises_of(file, checked, streams); }
    }
    return checked;
}

/// The lesson files of a path: the file itself, or the lessons below a folder.
/// @throws CommandError (bad_input) for a folder without lessons
std::vector<std::string> files_of(const std::string& path) {
    std::error_code error;
    if (!fs::is_directory(path, error)) { return {path}; }
    std::vector<std::string> files;
    for (const fs::path& file : lessons_below(path)) { files.push_back(file.string()); }
    if (files.empty()) {
        throw CommandError(
            Exit::bad_input, path + ": error: there is no lesson below this folder; expected files *.toml");
    }
    return files;
}

Exit exit_of(const CheckedLesson& checked, const CheckStyle& style) {
    if (!checked.error.empty()) { return Exit::bad_input; }
    const bool lacks_claims = style.require_claims && checked.claims_nothing();
    return checked.failed() > 0 || lacks_claims ? Exit::check_failed : Exit::done;
}

/// Checks the files that the options name, lesson by lesson; text is written as soon as it is known.
class Checker {
public:
    Checker(const CheckOptions& options, const Streams& streams) : options_(options), streams_(streams) {}

    Exit check_all() {
        for (const std::string& path : options_.paths) {
            guarded(path, [&] {
                for (const std::string& file : files_of(path)) {
                    guarded(file, [&] { add(checked_lesson(file, options_, streams_)); });
                }
            });
        }
        if (options_.format == "json") {
            write_json(lessons_, options_.style, static_cast<int>(exit_), streams_.out);
        } else if (options_.format == "junit") {
            write_junit(lessons_, options_.style, streams_.out);
        }
        return exit_;
    }

private:
    /// If one file cannot be checked, the others are checked all the same.
    template <class Work>
    void guarded(const std::string& path, Work work) {
        try {
            work();
        } catch (const CommandError& error) {
            CheckedLesson checked;
            checked.file = path;
            checked.error = error.what();
            while (checked.error.ends_with('\n')) { checked.error.pop_back(); }
            if (const auto* faulty = dynamic_cast<const FaultyFile*>(&error)) {
                checked.diagnostics = faulty->diagnostics();
            }
            streams_.err << checked.error << '\n';
            exit_ = std::max(exit_, error.exit());
            add(std::move(checked));
        }
    }

    void add(CheckedLesson checked) {
        exit_ = std::max(exit_, exit_of(checked, options_.style));
        if (options_.format == "text") {
            write_text(checked, options_.style, streams_.out);
            streams_.out.flush();
        }
        if (options_.style.require_claims && checked.claims_nothing()) {
            streams_.err << checked.file
                         << ": error: the lesson claims nothing; expected an [[expect]] block\n";
        }
        lessons_.push_back(std::move(checked));
    }

    const CheckOptions& options_;
    const Streams& streams_;
    std::vector<CheckedLesson> lessons_;
    Exit exit_ = Exit::done;
};

Exit check_command(const CheckOptions& options, const Streams& streams) {
    return Checker(options, streams).check_all();
}

}  // namespace

void add_check(const CommandLine& line) {
    auto [command, options] = add_command<CheckOptions>(
        line, "check", "prove the claims ([[expect]]) of lessons", check_command,
        "Example: jointwise check lessons/catalogue/loops");
    add_value(command, "FILE", options.paths, "", "lesson files, or folders: all lessons below them")
        ->required();
    add_try_option(command, options.experiments);
    command.add_flag("--quiet", options.style.quiet, "show only claims that fail");
    command.add_flag("--require-claims", options.style.require_claims, "fail if a lesson has no claims");
    add_format_option(command, options.format, {"text", "json", "junit"});
}

}  // namespace jw
