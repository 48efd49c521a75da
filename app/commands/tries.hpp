#pragma once

#include <string>
#include <vector>

#include "app/commands/command.hpp"
#include "app/session/json.hpp"
#include "app/session/session.hpp"

namespace CLI {
class App;
}

/// Experiments on the command line: the option --try of several commands.
namespace jw {

void add_try_option(CLI::App& command, std::vector<std::string>& tries);

/// A lesson as it is after all experiments, and what they did in words.
struct LessonTried {
    Lesson lesson;
    std::vector<std::string> done;
};

/// Carries out all of `tries` and says in words what they did.
/// @throws CommandError (bad_input) for what cannot be done
std::vector<std::string> try_all(Session& session, const std::vector<std::string>& tries);

/// The lesson in `path` with everything in `tries` done to it, one after the other.
/// @throws CommandError (bad_input) for a lesson with mistakes and as try_all
LessonTried lesson_of(
    const std::filesystem::path& path, const std::vector<std::string>& tries, const Streams& streams);

/// A line each, "tried: hinge: drop x"; empty if nothing was.
std::string tried_text(const std::vector<std::string>& done);
/// Adds key "tried" if something was.
void add_tried(Json& json, const std::vector<std::string>& done);

}  // namespace jw
