#include "app/commands/tries.hpp"

#include <CLI/CLI.hpp>

#include "app/session/trial.hpp"
#include "lessons/diagnostics.hpp"

namespace jw {

void add_try_option(CLI::App& command, std::vector<std::string>& tries) {
    command
        .add_option(
            "--try", tries,
            "an experiment first, as 'jointwise try FILE' lists them; may be given several times")
        ->type_name("TEXT")
        ->type_size(1)
        ->allow_extra_args(false);
}

std::vector<std::string> try_all(Session& session, const std::vector<std::string>& tries) {
    std::vector<std::string> done;
    for (const std::string& text : tries) {
        const Trial trial = try_out(session, text);
        if (!trial.done) {
            throw CommandError(
                Exit::bad_input, "jointwise: error: --try " + in_quotes(text) + ": " + trial.said);
        }
        done.push_back(trial.said);
    }
    return done;
}

LessonTried lesson_of(
    const std::filesystem::path& path, const std::vector<std::string>& tries, const Streams& streams) {
    Lesson lesson = lesson_of(path, streams);
    if (tries.empty()) { return {std::move(lesson), {}}; }
    Session session(std::move(lesson));
    std::vector<std::string> done = try_all(session, tries);
    return {session.lesson(), std::move(done)};
}

std::string tried_text(const std::vector<std::string>& done) {
    std::string text;
    for (const std::string& one : done) { text += "tried: " + one + '\n'; }
    return text;
}

void add_tried(Json& json, const std::vector<std::string>& done) {
    if (!done.empty()) { json["tried"] = done; }
}

}  // namespace jw
