#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"
#include "app/session/output/json.hpp"
#include "app/session/try/session.hpp"

namespace CLI {
class App;
}

/// Experiments on the command line: the option --try of several commands.
namespace jw {

void add_try_option(CLI::App& command, std::vector<std::string>& experiments);

/// Adds the argument FILE, and --try.
void add_lesson_options(
    CLI::App& command, std::string& file, std::vector<std::string>& experiments,
    const std::string& about = "lesson file");

/// A lesson after all experiments, and what these did in words.
struct ChangedLesson {
    Lesson lesson;
    std::vector<std::string> done;
};

/// Carries out all of `experiments` and says in words what they did.
/// @throws CommandError (bad_input) for an experiment that cannot be carried out
std::vector<std::string> carry_out_all(Session& session, const std::vector<std::string>& experiments);

/// The lesson in `path` after all of `experiments`, one after the other.
/// @throws CommandError (bad_input) for a lesson with mistakes, and as carry_out_all does
ChangedLesson lesson_of(
    const std::filesystem::path& path, const std::vector<std::string>& experiments, const Streams& streams);

/// One line each, "tried: hinge: without x"; empty if nothing was done.
std::string done_text(const std::vector<std::string>& done);
/// Adds the key "tried" if something was done.
void add_done(Json& json, const std::vector<std::string>& done);

/// The document with the key "tried" if something was done.
std::string document_of(Json json, const std::vector<std::string>& done);

}  // namespace jw
