#include "app/commands/doctor.hpp"

#include <imgui.h>
#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <algorithm>
#include <set>
#include <sstream>

#include "app/commands/commands.hpp"
#include "lessons/reader.hpp"
#include "render/font_face.hpp"
#include "render/png.hpp"

namespace jw {

namespace {

using Outcome = SurfaceReport::State;

const char* word_for(Outcome state) {
    switch (state) {
        case Outcome::right: return "right";
        case Outcome::draws_wrong: return "draws wrong";
        case Outcome::missing: return "missing";
        case Outcome::absent: break;
    }
    return "absent";
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

SurfaceReport examine_window(const SurfaceDoctor& doctor_window) {
    if (doctor_window) { return doctor_window(); }
    SurfaceReport report;
    report.name = "window";
    report.problem = "this build has no window";
    return report;
}

/// What to install, each package once.
std::set<std::string> packages_of(const Diagnosis& diagnosis) {
    std::set<std::string> packages;
    for (const SurfaceReport& surface : diagnosis.surfaces) {
        if (!surface.packages.empty()) { packages.insert(surface.packages); }
    }
    for (const render::FontSource& font : diagnosis.fonts) {
        if (!font.problem.empty()) { packages.insert(font.package); }
    }
    return packages;
}

std::string describe(const SurfaceReport& surface) {
    std::string text = surface.state == Outcome::right ? "draws right" : surface.problem;
    if (!surface.renderer.empty()) {
        text += "\n             " + surface.renderer + ", OpenGL " + surface.gl_version + ", " +
                std::to_string(surface.samples) + (surface.samples == 1 ? " sample" : " samples");
    }
    return text;
}

Exit doctor(bool as_json, const SurfaceDoctor& doctor_window, const Streams& streams) {
    const Diagnosis diagnosis = diagnose(doctor_window);
    if (as_json) {
        streams.out << json_of(diagnosis).dump(1) << '\n';
    } else {
        streams.out << describe(diagnosis);
    }
    return exit_of(diagnosis);
}

}  // namespace

Diagnosis diagnose(const SurfaceDoctor& doctor_window) {
    return {{examine_offscreen(), examine_window(doctor_window)}, render::find_fonts(), versions()};
}

Exit exit_of(const Diagnosis& diagnosis) {
    const auto any = [&](Outcome state) {
        return std::ranges::any_of(diagnosis.surfaces, [=](const auto& s) { return s.state == state; });
    };
    if (any(Outcome::draws_wrong)) { return Exit::numerics; }
    const bool font_missing =
        std::ranges::any_of(diagnosis.fonts, [](const auto& font) { return !font.problem.empty(); });
    return any(Outcome::missing) || font_missing ? Exit::bad_input : Exit::done;
}

std::string verdict_of(const Diagnosis& diagnosis) {
    if (exit_of(diagnosis) == Exit::done) { return "everything that is needed is there"; }
    std::string text = "not everything that is needed is there";
    const std::set<std::string> packages = packages_of(diagnosis);
    if (!packages.empty()) {
        text += "; install it:\n  apt-get install";
        for (const std::string& package : packages) { text += ' ' + package; }
    }
    for (const SurfaceReport& surface : diagnosis.surfaces) {
        if (!surface.remedy.empty()) { text += "\n  " + surface.name + ": " + surface.remedy; }
    }
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
    for (const render::FontSource& font : diagnosis.fonts) {
        text << "  " << (font.problem.empty() ? font.path.string() : font.problem) << " (package "
             << font.package << ")\n";
    }
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
             {"path", f.path.empty() ? Json() : Json(f.path.string())},
             {"problem", f.problem}});
    }
    Json versions_json = Json::object();
    for (const auto& [name, number] : diagnosis.versions) { versions_json[name] = number; }
    return {
        {"format", "jointwise doctor"},
        {"version", kJsonVersion},
        {"exit_status", static_cast<int>(exit_of(diagnosis))},
        {"verdict", verdict_of(diagnosis)},
        {"surfaces", surfaces},
        {"fonts", fonts},
        {"versions", versions_json}};
}

void add_doctor(CLI::App& app, const Streams& streams, Run& run, const SurfaceDoctor& doctor_window) {
    CLI::App* command =
        app.add_subcommand("doctor", "look whether pictures, windows and fonts work on this machine");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "as JSON");
    command->footer("Example: jointwise doctor");
    command->callback([as_json, doctor_window, &streams, &run] {
        run = [as_json, doctor_window, &streams] { return doctor(*as_json, doctor_window, streams); };
    });
}

}  // namespace jw
