#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <set>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/snapshot/deleted_lessons.hpp"
#include "app/snapshot/reports.hpp"
#include "lessons/files/file_text.hpp"
#include "render/files/atomic_file.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

struct SnapshotOptions {
    std::vector<std::string> paths;
    std::string golden;
    std::string size = "960x540";
    int moments = snapshot::kMoments;
    std::string format = "text";
    std::string out;
    std::vector<std::string> only;
    std::string reason;
};

constexpr PixelSize kSmallestShot{snapshot::kSmallestSize.width, snapshot::kSmallestSize.height};
constexpr PixelSize kLargestShot{snapshot::kLargestSize.width, snapshot::kLargestSize.height};
constexpr const char* kPage = "index.html";
constexpr const char* kJunit = "junit.xml";
constexpr const char* kJson = "report.json";
constexpr std::array kReports{kPage, kJunit, kJson};
constexpr std::size_t kLargestLesson = 1U << 26U;

/// A lesson with its text, as the commands read it.
struct Opened {
    Lesson lesson;
    std::string text;
};

Opened opened(const fs::path& file, const Streams& streams) {
    Opened result{lesson_of(file, streams), {}};
    result.text = read_file_text(file, kLargestLesson).text;
    return result;
}

snapshot::GoldenFolder folder_of(const SnapshotOptions& options, const snapshot::SuiteLesson& lesson) {
    return snapshot::GoldenFolder(fs::path(options.golden) / lesson.name);
}

SnapshotRules rules_of(const SnapshotOptions& options) {
    const SnapshotRulesRead read = read_snapshot_rules(fs::path(options.golden) / "rules.toml");
    if (!read.rules) { throw FaultyFile(read.report(), read.diagnostics); }
    return *read.rules;
}

/// Checks that a lesson is recorded, in the present language.
/// @throws std::runtime_error saying what to do
void check_head(const snapshot::GoldenFolder& folder) {
    if (!folder.exists()) {
        throw std::runtime_error(
            "'" + folder.path().string() +
            "' has no snapshots of this lesson; 'jointwise snapshot record' takes them");
    }
    const snapshot::GoldenHead head = folder.head();
    if (head.language != language()) {
        throw std::runtime_error(
            "the snapshots in '" + folder.path().string() + "' were taken in the language '" + head.language +
            "'; give --language " + head.language);
    }
}

/// Settings for snapshots in a folder: those of existing snapshots, with the newly chosen names added.
snapshot::GoldenHead head_for(const snapshot::GoldenFolder& folder, const snapshot::GoldenHead& wanted) {
    if (!folder.exists()) { return wanted; }
    check_head(folder);
    snapshot::GoldenHead head = folder.head();
    if (head.choice.only.empty()) { return head; }
    for (const std::string& name : wanted.choice.only) {
        if (std::ranges::find(head.choice.only, name) == head.choice.only.end()) {
            head.choice.only.push_back(name);
        }
    }
    return head;
}

Exit record_command(const SnapshotOptions& options, const Streams& streams) {
    const PixelSize size = size_option(options.size, kSmallestShot, kLargestShot);
    const snapshot::GoldenHead wanted{
        {size.width, size.height}, {options.moments, options.only}, std::string(language())};
    snapshot::RecordResult all;
    for (const snapshot::SuiteLesson& lesson : snapshot::suite_of(options.paths)) {
        const Opened now = opened(lesson.file, streams);
        const snapshot::GoldenFolder folder = folder_of(options, lesson);
        const snapshot::RecordResult result =
            snapshot::record(now.lesson, now.text, folder, head_for(folder, wanted));
        all.written += result.written;
        all.kept += result.kept;
        streams.err << lesson.name << ": " << result.written << " taken, " << result.kept << " were there\n";
    }
    streams.err << count_text(all.written, "snapshot", "snapshots") << " taken into " << options.golden;
    streams.err
        << (all.kept > 0 ? "; those that were there stay as they are ('snapshot bless' changes them)\n"
                         : "\n");
    return Exit::done;
}

/// Compares one lesson; if it cannot be compared, the result says why.
snapshot::LessonResult compared(
    const SnapshotOptions& options, const snapshot::SuiteLesson& lesson, const SnapshotRules& rules,
    const std::set<snapshot::Fault>& controls, const Streams& streams) {
    snapshot::LessonResult result;
    result.lesson = lesson;
    try {
        const Opened now = opened(lesson.file, streams);
        const snapshot::GoldenFolder folder = folder_of(options, lesson);
        check_head(folder);
        return snapshot::compare(now.lesson, now.text, lesson, folder, rules, controls);
    } catch (const FaultyFile& error) { result.problem = error.what(); } catch (const CommandError& error) {
        result.problem = error.what();
    } catch (const std::runtime_error& error) { result.problem = error.what(); }
    return result;
}

/// Compares the suite. If `tells`, each result is written as soon as it is known.
std::vector<snapshot::LessonResult> compared(
    const SnapshotOptions& options, bool tells, const Streams& streams) {
    const SnapshotRules rules = rules_of(options);
    std::vector<snapshot::LessonResult> results;
    const auto add = [&](snapshot::LessonResult result) {
        results.push_back(std::move(result));
        if (tells) { streams.out << snapshot::describe(results.back()) << std::flush; }
    };
    const std::vector<snapshot::SuiteLesson> suite =
        snapshot::suite_or_emptied(options.paths, options.golden);
    std::set<snapshot::Fault> controls = snapshot::all_faults();
    for (const snapshot::SuiteLesson& lesson : suite) {
        add(compared(options, lesson, rules, controls, streams));
        if (!results.back().problem.empty()) { continue; }
        // a fault that could not be made in this lesson is tried in the next one
        controls.clear();
        for (const auto& skipped : results.back().controls.skipped) { controls.insert(skipped.kind); }
    }
    for (const std::string& name : snapshot::deleted_lessons(options.paths, suite, options.golden)) {
        add(snapshot::result_of_deleted(name, options.golden));
    }
    return results;
}

Exit exit_of(const std::vector<snapshot::LessonResult>& results) {
    const auto is_unread = [](const snapshot::LessonResult& result) { return !result.problem.empty(); };
    if (std::ranges::any_of(results, is_unread)) { return Exit::bad_input; }
    return std::ranges::any_of(results, &snapshot::LessonResult::fails) ? Exit::check_failed : Exit::done;
}

Exit compare_command(const SnapshotOptions& options, const Streams& streams) {
    const std::vector<snapshot::LessonResult> results = compared(options, options.format == "text", streams);
    if (options.format == "json") {
        streams.out << json_document(snapshot::json_of(results));
    } else if (options.format == "junit") {
        streams.out << snapshot::junit_of(results);
    } else {
        streams.out << snapshot::summary(results) << '\n';
    }
    return exit_of(results);
}

/// Makes the folder of the report if it does not exist.
fs::path report_folder(const SnapshotOptions& options) {
    std::error_code error;
    fs::create_directories(options.out, error);
    if (error || !fs::is_directory(options.out, error)) {
        throw bad_input(
            "--out '" + options.out + "' cannot be made a folder" + (error ? ": " + error.message() : ""));
    }
    return options.out;
}

Exit report_command(const SnapshotOptions& options, const Streams& streams) {
    const fs::path folder = report_folder(options);
    for (const char* const name : kReports) { render::check_can_be_written(folder / name); }
    const std::vector<snapshot::LessonResult> results = compared(options, true, streams);
    render::write_file_atomically(folder / kPage, snapshot::html_of(results));
    render::write_file_atomically(folder / kJunit, snapshot::junit_of(results));
    render::write_file_atomically(folder / kJson, json_document(snapshot::json_of(results)));
    streams.out << snapshot::summary(results) << '\n';
    streams.err << kPage << ", " << kJunit << " and " << kJson << " in " << options.out << '\n';
    return exit_of(results);
}

/// @return how many snapshots of deleted lessons were removed
std::size_t bless_deletions(
    const SnapshotOptions& options, const std::vector<snapshot::SuiteLesson>& suite, const Streams& streams) {
    std::size_t removed = 0;
    for (const std::string& name : snapshot::deleted_lessons(options.paths, suite, options.golden)) {
        removed += snapshot::GoldenFolder(fs::path(options.golden) / name).names().size();
        snapshot::bless_deletion(name, options.golden, options.reason);
        streams.out << name << ": the lesson is deleted, its snapshots are removed\n";
    }
    return removed;
}

Exit bless_command(const SnapshotOptions& options, const Streams& streams) {
    if (options.reason.find_first_not_of(" \t\n") == std::string::npos) {
        throw bad_input(
            "--reason is empty; expected why the snapshots may change, for those who read it later");
    }
    const SnapshotRules rules = rules_of(options);
    std::size_t changed = 0;
    const std::vector<snapshot::SuiteLesson> suite =
        snapshot::suite_or_emptied(options.paths, options.golden);
    for (const snapshot::SuiteLesson& lesson : suite) {
        const Opened now = opened(lesson.file, streams);
        const snapshot::GoldenFolder folder = folder_of(options, lesson);
        check_head(folder);
        for (const std::string& name :
             snapshot::bless(now.lesson, now.text, folder, rules, options.only, options.reason)) {
            streams.out << lesson.name << ": " << name << '\n';
            ++changed;
        }
    }
    if (options.only.empty()) { changed += bless_deletions(options, suite, streams); }
    streams.err << count_text(static_cast<int>(changed), "snapshot", "snapshots") << " blessed\n";
    if (changed == 0 && !options.only.empty()) {
        throw bad_input(
            "of " + comma_list(options.only) +
            " nothing differs in these lessons; 'jointwise snapshot compare' says what does");
    }
    return Exit::done;
}

using Verb = NewCommand<SnapshotOptions>;

Verb add_verb(
    const CommandLine& line, const char* name, const char* about,
    Exit (*what)(const SnapshotOptions&, const Streams&)) {
    const Verb verb = add_command<SnapshotOptions>(line, name, about, what);
    auto& [command, options] = verb;
    add_value(command, "LESSONS", options.paths, "", "lesson files, and folders with lessons")->required();
    add_value(
        command, "--golden", options.golden, "DIR",
        "folder of the golden snapshots, with rules.toml if there are rules")
        ->required()
        ->check(CLI::Validator(
            [](const std::string& folder) {
                return folder.empty() ? std::string("it is empty; expected a folder") : std::string();
            },
            ""));
    return verb;
}

}  // namespace

void add_snapshot(const CommandLine& line) {
    CLI::App* command = line.app.add_subcommand("snapshot", "compare lessons with earlier snapshots of them");
    command->require_subcommand(1);
    command->footer(
        "Example: jointwise snapshot record lessons/ --golden golden/\n"
        "         jointwise snapshot compare lessons/ --golden golden/\n"
        "docs/snapshots.md describes layers, rules and files.");
    const CommandLine verbs{*command, line.streams, line.run};

    const Verb record = add_verb(verbs, "record", "take the snapshots that do not exist yet", record_command);
    add_value(record.command, "--size", record.options.size, "WxH", "size in pixels")->capture_default_str();
    add_value(record.command, "--moments", record.options.moments, "N", "number of moments of the motion")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    add_value(
        record.command, "--only", record.options.only, "NAME",
        "names of the steps to record, instead of the default steps");

    const Verb compare = add_verb(
        verbs, "compare", "compare with the snapshots; status 1 if something differs", compare_command);
    add_format_option(compare.command, compare.options.format, {"text", "json", "junit"});

    const Verb report = add_verb(
        verbs, "report", "compare, and write a page with pictures, JUnit and JSON; status as for compare",
        report_command);
    add_value(
        report.command, "--out", report.options.out, "DIR",
        "folder for index.html, junit.xml and report.json; created if needed")
        ->required();

    const Verb bless = add_verb(verbs, "bless", "replace snapshots that differ by new ones", bless_command);
    add_value(bless.command, "--only", bless.options.only, "NAME", "names of snapshots");
    add_value(bless.command, "--reason", bless.options.reason, "TEXT", "reason; it is recorded")->required();
}

}  // namespace jw
