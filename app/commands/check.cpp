#include <CLI/CLI.hpp>

#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/session/checks.hpp"
#include "app/session/describe.hpp"
#include "lessons/reader.hpp"

namespace jw {

namespace {

struct Tally {
    int held = 0;
    int failed = 0;
};

void print(const ClaimResult& result, const Lesson& lesson, const Streams& streams) {
    const SourceSpan& span = result.claim->span;
    streams.out << "  " << (result.holds ? "holds " : "FAILS ") << padded(result.moment, 18) << ' '
                << padded(result.subject, 22) << ' ';
    if (result.holds) {
        streams.out << result.expected << '\n';
        return;
    }
    streams.out << "expected " << result.expected << ", found " << result.found << '\n';
    streams.out << "        " << lesson.file_name << ':' << span.line << ':' << span.column << '\n';
    if (!result.claim->why.empty()) { streams.out << "        " << result.claim->why << '\n'; }
}

Tally check_one(const std::string& file, bool quiet, const Streams& streams) {
    const Lesson lesson = lesson_of(file, streams);
    Tally tally;
    const std::vector<ClaimResult> results = check_claims(lesson);
    for (const ClaimResult& result : results) { ++(result.holds ? tally.held : tally.failed); }
    streams.out << lesson.file_name << ": " << tally.held << " of " << results.size()
                << (results.size() == 1 ? " claim holds" : " claims hold") << '\n';
    for (const ClaimResult& result : results) {
        if (!quiet || !result.holds) { print(result, lesson, streams); }
    }
    if (results.empty()) {
        streams.err << file << ": warning: the lesson claims nothing; add [[expect]] blocks\n";
    }
    return tally;
}

Exit check(const std::vector<std::string>& files, bool quiet, const Streams& streams) {
    Exit exit = Exit::done;
    for (const std::string& file : files) {
        // the other files are checked all the same
        try {
            if (check_one(file, quiet, streams).failed > 0) { exit = std::max(exit, Exit::check_failed); }
        } catch (const CommandError& error) {
            streams.err << error.what();
            exit = std::max(exit, error.exit());
        }
    }
    return exit;
}

}  // namespace

void add_check(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("check", "prove the claims ([[expect]]) of lessons");
    struct Options {
        std::vector<std::string> files;
        bool quiet = false;
    };
    auto options = std::make_shared<Options>();
    command->add_option("FILE", options->files, "lesson files")->required()->type_name("");
    command->add_flag("--quiet", options->quiet, "show only claims that fail");
    command->footer("Example: jointwise check lessons/catalogue/loops/*.toml");
    command->callback([options, &streams, &run] {
        run = [options, &streams] { return check(options->files, options->quiet, streams); };
    });
}

}  // namespace jw
