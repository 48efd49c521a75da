#include <CLI/CLI.hpp>

#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/commands/experiment_option.hpp"
#include "app/session/claims/carried_claims.hpp"
#include "app/session/claims/checks.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/reader.hpp"

namespace jw {

namespace {

struct CheckOptions {
    std::vector<std::string> files;
    std::vector<std::string> experiments;
    bool quiet = false;
};

struct Tally {
    int held = 0;
    int failed = 0;
};

void print(const ClaimResult& result, const Lesson& lesson, const Streams& streams) {
    const SourceSpan& span = result.span;
    streams.out << "  " << (result.holds ? "holds " : "FAILS ") << padded(result.moment, 18) << ' '
                << padded(result.subject, 22) << ' ';
    if (result.holds) {
        streams.out << result.expected << '\n';
        return;
    }
    streams.out << "expected " << result.expected << ", found " << result.found << '\n';
    streams.out << "        " << lesson.file_name << ':' << span.line << ':' << span.column << '\n';
    if (!result.why.empty()) { streams.out << "        " << result.why << '\n'; }
}

/// The lesson after `experiments`, with the claims that can still be judged; says what was done.
Lesson changed_lesson(const Lesson& written, const CheckOptions& options, const Streams& streams) {
    Session session(written);
    streams.out << done_text(carry_out_all(session, options.experiments));
    Lesson changed = session.lesson();
    changed.claims = carried_claims(written, changed);
    if (const std::size_t gone = written.claims.size() - changed.claims.size(); gone > 0) {
        streams.out << "not judged: " << gone << (gone == 1 ? " claim" : " claims")
                    << " about what was taken out\n";
    }
    return changed;
}

Tally check_one(const std::string& file, const CheckOptions& options, const Streams& streams) {
    Lesson lesson = lesson_of(file, streams);
    const bool proves_end = lesson.dynamics && lesson.dynamics->point_at_end;
    const bool claims_nothing = lesson.claims.empty() && !proves_end;
    if (!options.experiments.empty()) { lesson = changed_lesson(lesson, options, streams); }
    Tally tally;
    const std::vector<ClaimResult> results = check_claims(lesson);
    for (const ClaimResult& result : results) { ++(result.holds ? tally.held : tally.failed); }
    streams.out << lesson.file_name << ": " << tally.held << " of " << results.size()
                << (results.size() == 1 ? " claim holds" : " claims hold") << '\n';
    for (const ClaimResult& result : results) {
        if (!options.quiet || !result.holds) { print(result, lesson, streams); }
    }
    if (claims_nothing) {
        streams.err << file << ": warning: the lesson claims nothing; add [[expect]] blocks\n";
    }
    return tally;
}

Exit check(const CheckOptions& options, const Streams& streams) {
    Exit exit = Exit::done;
    for (const std::string& file : options.files) {
        // the other files are checked all the same
        try {
            if (check_one(file, options, streams).failed > 0) { exit = std::max(exit, Exit::check_failed); }
        } catch (const CommandError& error) {
            const std::string text = error.what();
            streams.err << text << (text.ends_with('\n') ? "" : "\n");
            exit = std::max(exit, error.exit());
        }
    }
    return exit;
}

}  // namespace

void add_check(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("check", "prove the claims ([[expect]]) of lessons");
    auto options = std::make_shared<CheckOptions>();
    command->add_option("FILE", options->files, "lesson files")->required()->type_name("");
    add_try_option(*command, options->experiments);
    command->add_flag("--quiet", options->quiet, "show only claims that fail");
    command->footer("Example: jointwise check lessons/catalogue/loops/*.toml");
    command->callback(
        [options, &streams, &run] { run = [options, &streams] { return check(*options, streams); }; });
}

}  // namespace jw
