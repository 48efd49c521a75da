#include "app/commands/options/experiment_option.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/program/commands.hpp"
#include "app/session/try/carry_out.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

void add_try_option(CLI::App& command, std::vector<std::string>& experiments) {
    add_value(
        command, "--try", experiments, "TEXT",
        "experiment to carry out first, as listed by 'jointwise try FILE'; can be given several times")
        ->type_size(1)
        ->allow_extra_args(false);
}

void add_lesson_options(
    CLI::App& command, std::string& file, std::vector<std::string>& experiments, const std::string& about) {
    add_value(command, "FILE", file, "", about)->required();
    add_try_option(command, experiments);
}

std::vector<std::string> carry_out_all(Session& session, const std::vector<std::string>& experiments) {
    std::vector<std::string> done;
    for (const std::string& text : experiments) {
        const ExperimentResult result = carry_out(session, text);
        if (!result.done) { throw bad_input("--try " + in_quotes(text) + ": " + result.said); }
        done.push_back(result.said);
    }
    return done;
}

ChangedLesson lesson_of(
    const std::filesystem::path& path, const std::vector<std::string>& experiments, const Streams& streams) {
    Lesson lesson = lesson_of(path, streams);
    if (experiments.empty()) { return {std::move(lesson), {}}; }
    Session session(std::move(lesson));
    std::vector<std::string> done = carry_out_all(session, experiments);
    return {session.lesson(), std::move(done)};
}

std::string done_text(const std::vector<std::string>& done) {
    std::string text;
    for (const std::string& one : done) { text += "tried: " + one + '\n'; }
    return text;
}

void add_done(Json& json, const std::vector<std::string>& done) {
    if (!done.empty()) { json["tried"] = done; }
}

std::string document_of(Json json, const std::vector<std::string>& done) {
    add_done(json, done);
    return json_document(json);
}

}  // namespace jw
