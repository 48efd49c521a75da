#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/program/command.hpp"
#include "app/commands/program/surface.hpp"
#include "app/session/output/json.hpp"
#include "render/fonts/fonts.hpp"

/// Checks of `jointwise doctor`, and its report.
namespace jw {

/// The lessons that the program offers.
struct LessonsReport {
    using State = SurfaceReport::State;
    State state = State::right;    ///< or missing, or damaged
    std::filesystem::path folder;  ///< empty if it was not looked for
    int count = 0;                 ///< of lessons that can be read
    std::string problem;           ///< empty if there is none
    std::string remedy;            ///< likewise
};

/// Reads all lessons below a folder.
LessonsReport examine_lessons(const std::filesystem::path& folder);

struct Diagnosis {
    std::vector<SurfaceReport> surfaces;
    std::vector<render::FontSource> fonts;
    LessonsReport lessons;
    std::vector<std::pair<std::string, std::string>> versions;  ///< of the program's components
};

/// Checks everything; takes about a second.
Diagnosis diagnose(const SurfaceDoctor& doctor_window);

/// numerics (3) if a surface draws incorrectly, bad_input (2) if something is missing or damaged, otherwise
/// done.
Exit exit_of(const Diagnosis& diagnosis);
/// "everything needed is there", or what to do.
std::string verdict_of(const Diagnosis& diagnosis);
std::string describe(const Diagnosis& diagnosis);
Json json_of(const Diagnosis& diagnosis);

}  // namespace jw
