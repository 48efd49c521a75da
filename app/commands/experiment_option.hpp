#pragma once

#include <string>
#include <vector>

#include "app/commands/command.hpp"
#include "app/session/output/json.hpp"
#include "app/session/try/session.hpp"

namespace CLI {
class App;
}

/// Experiments on the command line: the option --try of several commands.
namespace jw {

void add_try_option(CLI::App& command, std::vector<std::string>& experiments);

/// A lesson as it is after all experiments, and what they did in words.
struct ChangedLesson {
    Lesson lesson;
    std::vector<std::string> done;
};

/// Carries out all of `experiments` and says in words what they did.
/// @throws CommandError (bad_input) for what cannot be done
std::vector<std::string> carry_out_all(Session& session, const std::vector<std::string>& experiments);

/// The lesson in `path` with everything in `experiments` done to it, one after the other.
/// @throws CommandError (bad_input) for a lesson with mistakes and as carry_out_all
ChangedLesson lesson_of(
    const std::filesystem::path& path, const std::vector<std::string>& experiments, const Streams& streams);

/// A line each, "tried: hinge: drop x"; empty if nothing was.
std::string done_text(const std::vector<std::string>& done);
/// Adds key "tried" if something was.
void add_done(Json& json, const std::vector<std::string>& done);

}  // namespace jw
