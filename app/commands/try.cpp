#include <optional>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/try/possible_experiments.hpp"

namespace jw {

namespace {

struct TryOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::string format;
};

/// Writes each group as soon as its effects are known.
void write_text(const Session& session, const std::vector<std::string>& done, const Streams& streams) {
    std::optional<ExperimentsText> text;
    const auto write = [&](const std::string& piece) { streams.out << piece << std::flush; };
    const PossibleExperiments all = possible_experiments_of(
        session, {[&](const PossibleExperiments& outline) {
                      text.emplace(outline, session.as_written());
                      write(done_text(done) + text->head());
                  },
                  [&](const ExperimentGroup& group) { write(text->group(group)); }});
    write(text->rest(all));
}

Exit try_command(const TryOptions& options, const Streams& streams) {
    const Lesson lesson = lesson_of(options.file, streams);
    // only experiments can lead into the motion
    Session session(lesson, !options.experiments.empty());
    session.apply(GoTo{session.story().last_assembled()});
    const std::vector<std::string> done = carry_out_all(session, options.experiments);
    if (options.format == "json") {
        streams.out << document_of(json_of(possible_experiments_of(session), lesson), done);
    } else {
        write_text(session, done, streams);
    }
    return Exit::done;
}

}  // namespace

void add_try(const CommandLine& line) {
    auto [command, options] = add_command<TryOptions>(
        line, "try", "list the experiments of a lesson, with their effect on rank and condition", try_command,
        "Example: jointwise try lessons/catalogue/loops/four-bar.toml --try \"take out D p1 x\"");
    add_lesson_options(command, options.file, options.experiments);
    add_format_option(command, options.format, {"text", "json"});
}

}  // namespace jw
