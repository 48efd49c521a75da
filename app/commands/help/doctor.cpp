#include "app/commands/help/doctor.hpp"

#include <imgui.h>
#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "render/files/png.hpp"
#include "render/fonts/font_face.hpp"

namespace jw {

namespace {

using Outcome = SurfaceReport::State;

const char* word_for(Outcome state) {
    switch (state) {
        case Outcome::right: return "right";
        case Outcome::draws_wrong: return "draws wrong";
        case Outcome::missing: return "missing";
        case Outcome::damaged: return "damaged";
        case Outcome::absent: break;
    }
    return "absent";
}

const char* word_for(render::FontSource::State state) {
    using State = render::FontSource::State;
    return state == State::right ? "right" : state == State::missing ? "missing" : "damaged";
}

std::string version(int major, int minor, int patch) {
    return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

std::vector<std::pair<std::string, std::string>> versions() {
    return {
        {"jointwise", JW_VERSION},
        {"Eigen", version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"toml++", toml_version()},
        {"CLI11", CLI11_VERSION},
        {"nlohmann-json",
         version(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
        {"Dear ImGui", ImGui::GetVersion()},
        {"FreeType", render::freetype_version()},
        {"libdeflate", render::libdeflate_version()}};
}

/// True if somebody has chosen the folder of lessons.
bool folder_is_own() {
    const char* const chosen = std::getenv("JOINTWISE_LESSONS");
    return chosen != nullptr && *chosen != '\0';
}

SurfaceReport examine_window(const SurfaceDoctor& doctor_window) {
    if (doctor_window) { return doctor_window(); }
    SurfaceReport report;
    report.name = "window";
    report.problem = "this build has no window";
    return report;
}

std::vector<SurfaceReport> surfaces(const SurfaceDoctor& doctor_window) {
    std::vector<SurfaceReport> all{examine_offscreen(), examine_window(doctor_window), examine_egl()};
    SurfaceReport& offscreen = all.front();
    if (offscreen.state == Outcome::missing && all.back().state == Outcome::right) {
        offscreen.state = Outcome::absent;
        offscreen.problem = "no OSMesa here; EGL draws in its place";
        offscreen.packages.clear();
        offscreen.remedy.clear();
    }
    return all;
}

/// Packages to install, each once.
std::set<std::string> packages_of(const Diagnosis& diagnosis) {
    std::set<std::string> packages;
    for (const SurfaceReport& surface : diagnosis.surfaces) {
        if (!surface.packages.empty()) { packages.insert(surface.packages); }
    }
    for (const render::FontSource& font : diagnosis.fonts) {
        if (font.state == render::FontSource::State::missing) { packages.insert(font.package); }
    }
    return packages;
}

std::string describe(const SurfaceReport& surface) {
    std::string text = surface.state == Outcome::right ? "draws correctly" : surface.problem;
    if (!surface.renderer.empty()) {
        text += "\n             " + surface.renderer + ", OpenGL " + surface.gl_version + ", " +
                std::to_string(surface.samples) + (surface.samples == 1 ? " sample" : " samples");
    }
    return text;
}

std::string describe(const render::FontSource& font) {
    std::string text = font.problem.empty() ? font.path.string() : font.problem;
    if (!font.remedy.empty()) { text += "; " + font.remedy; }
    return text + " (package " + font.package + (font.optional ? ", for texts in Chinese)" : ")");
}

std::string describe(const LessonsReport& lessons) {
    if (!lessons.problem.empty()) { return lessons.problem + "; " + lessons.remedy; }
    return std::to_string(lessons.count) + " in " + lessons.folder.string();
}

/// Describes missing optional parts.
std::string wishes_of(const Diagnosis& diagnosis) {
    std::string text;
    for (const render::FontSource& font : diagnosis.fonts) {
        if (!font.optional || font.problem.empty()) { continue; }
        text += "; texts in Chinese need more:\n  apt-get install " + font.package;
    }
    return text;
}

/// True if nothing is missing and nothing draws incorrectly: at most, parts are damaged.
bool only_damaged(const Diagnosis& diagnosis) {
    const auto fits = [](Outcome state) {
        return state != Outcome::missing && state != Outcome::draws_wrong;
    };
    return std::ranges::all_of(diagnosis.surfaces, fits, &SurfaceReport::state) &&
           std::ranges::none_of(
               diagnosis.fonts,
               [](const auto& font) {
                   return font.state == render::FontSource::State::missing && !font.optional;
               }) &&
           diagnosis.lessons.state != LessonsReport::State::missing;
}

struct DoctorOptions {
    std::string format;
    SurfaceDoctor window;
};

Exit doctor(const DoctorOptions& options, const Streams& streams) {
    const Diagnosis diagnosis = diagnose(options.window);
    if (options.format == "json") {
        streams.out << json_document(json_of(diagnosis));
    } else {
        streams.out << describe(diagnosis);
    }
    const Exit exit = exit_of(diagnosis);
    if (exit != Exit::done) {
        const std::string verdict = verdict_of(diagnosis);
        streams.err << "jointwise: error: " << verdict.substr(0, verdict.find_first_of(";\n"))
                    << "; 'jointwise doctor' says what and why\n";
    }
    return exit;
}

}  // namespace

Diagnosis diagnose(const SurfaceDoctor& doctor_window) {
    return {surfaces(doctor_window), render::find_fonts(), examine_lessons(catalogue_folder()), versions()};
}

LessonsReport examine_lessons(const std::filesystem::path& folder) {
    LessonsReport report;
    report.folder = folder;
    std::string first_fault;
    int faults = 0;
    const std::vector<std::filesystem::path> files = lessons_below(folder);
    for (const std::filesystem::path& file : files) {
        const ReadResult read = read_lesson_file(file);
        if (read.lesson) {
            ++report.count;
        } else if (++faults == 1) {
            const std::string fault = read.report();
            first_fault = fault.substr(0, fault.find('\n'));
        }
    }
    if (files.empty()) {
        report.state = LessonsReport::State::missing;
        report.problem = "there is no lesson (*.toml) below " + in_quotes(folder.string());
    } else if (faults > 0) {
        report.state = LessonsReport::State::damaged;
        report.problem = std::to_string(faults) + " of " + std::to_string(files.size()) +
                         " lessons cannot be read, the first: " + first_fault;
    }
    if (report.problem.empty()) { return report; }
    const bool own = folder_is_own();
    report.remedy =
        own ? "name another folder in JOINTWISE_LESSONS, or unset the variable" : "install Jointwise again";
    return report;
}

Exit exit_of(const Diagnosis& diagnosis) {
    const auto any = [&](Outcome state) {
        return std::ranges::any_of(diagnosis.surfaces, [=](const auto& s) { return s.state == state; });
    };
    if (any(Outcome::draws_wrong)) { return Exit::numerics; }
    const bool no_font = std::ranges::any_of(
        diagnosis.fonts, [](const auto& font) { return !font.problem.empty() && !font.optional; });
    const bool bad =
        any(Outcome::missing) || any(Outcome::damaged) || no_font || !diagnosis.lessons.problem.empty();
    return bad ? Exit::bad_input : Exit::done;
}

std::string verdict_of(const Diagnosis& diagnosis) {
    if (exit_of(diagnosis) == Exit::done) { return "everything needed is there" + wishes_of(diagnosis); }
    std::string text = "something needed is missing";
    if (only_damaged(diagnosis)) { text = "something needed is damaged"; }
    if (exit_of(diagnosis) == Exit::numerics) { text = "a surface draws incorrectly"; }
    const std::set<std::string> packages = packages_of(diagnosis);
    if (!packages.empty()) {
        text += "; install it:\n  apt-get install";
        for (const std::string& package : packages) { text += ' ' + package; }
    }
    for (const SurfaceReport& surface : diagnosis.surfaces) {
        if (!surface.remedy.empty()) { text += "\n  " + surface.name + ": " + surface.remedy; }
    }
    for (const render::FontSource& font : diagnosis.fonts) {
        if (!font.remedy.empty()) { text += "\n  " + font.name + ": " + font.remedy; }
    }
    if (!diagnosis.lessons.remedy.empty()) { text += "\n  lessons: " + diagnosis.lessons.remedy; }
    return text;
}

std::string describe(const Diagnosis& diagnosis) {
    std::ostringstream text;
    text << "Surfaces\n";
    for (const SurfaceReport& surface : diagnosis.surfaces) {
        text << "  " << surface.name << std::string(11 - std::min<std::size_t>(10, surface.name.size()), ' ')
             << describe(surface) << '\n';
    }
    text << "Fonts\n";
    for (const render::FontSource& font : diagnosis.fonts) { text << "  " << describe(font) << '\n'; }
    if (!diagnosis.lessons.folder.empty()) { text << "Lessons\n  " << describe(diagnosis.lessons) << '\n'; }
    text << "Made of\n ";
    for (const auto& [name, number] : diagnosis.versions) {
        text << (name == diagnosis.versions.front().first ? " " : ", ") << name << ' ' << number;
    }
    text << "\n\n" << verdict_of(diagnosis) << '\n';
    return text.str();
}

Json json_of(const Diagnosis& diagnosis) {
    Json surfaces = Json::array();
    for (const SurfaceReport& s : diagnosis.surfaces) {
        surfaces.push_back(
            {{"name", s.name},
             {"state", word_for(s.state)},
             {"problem", s.problem},
             {"remedy", s.remedy},
             {"packages", s.packages},
             {"renderer", s.renderer},
             {"gl_version", s.gl_version},
             {"samples", s.samples}});
    }
    Json fonts = Json::array();
    for (const render::FontSource& f : diagnosis.fonts) {
        fonts.push_back(
            {{"name", f.name},
             {"package", f.package},
             {"state", word_for(f.state)},
             {"path", f.path.empty() ? Json() : Json(f.path.string())},
             {"problem", f.problem},
             {"remedy", f.remedy}});
    }
    const LessonsReport& lessons = diagnosis.lessons;
    const Json lessons_json{
        {"folder", lessons.folder.empty() ? Json() : Json(lessons.folder.string())},
        {"state", word_for(lessons.state)},
        {"count", lessons.count},
        {"problem", lessons.problem},
        {"remedy", lessons.remedy}};
    Json versions_json = Json::object();
    for (const auto& [name, number] : diagnosis.versions) { versions_json[name] = number; }
    return {
        {"format", "jointwise doctor"},
        {"version", kJsonVersion},
        {"exit_status", static_cast<int>(exit_of(diagnosis))},
        {"verdict", verdict_of(diagnosis)},
        {"surfaces", surfaces},
        {"fonts", fonts},
        {"lessons", lessons_json},
        {"versions", versions_json}};
}

void add_doctor(const CommandLine& line, const SurfaceDoctor& doctor_window) {
    auto [command, options] = add_command<DoctorOptions>(
        line, "doctor", "check that pictures, windows and fonts work on this machine", doctor,
        "Example: jointwise doctor");
    options.window = doctor_window;
    add_format_option(command, options.format, {"text", "json"});
}

}  // namespace jw
