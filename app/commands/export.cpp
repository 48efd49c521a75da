#include <optional>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/export/moving_scene.hpp"
#include "app/host/frames/frame_painter.hpp"
#include "app/session/output/export.hpp"
#include "render/files/atomic_file.hpp"

namespace jw {

namespace {

struct ExportOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::optional<int> step;
    std::string latex;  ///< file, or "-" for standard output; likewise `csv`
    std::string csv;
    std::string svg;
    std::string pdf;
    std::string size = "1280x720";
    std::string gltf;

    bool wants_picture() const { return !svg.empty() || !pdf.empty(); }
    bool wants_step() const { return !latex.empty() || !csv.empty() || wants_picture(); }
    /// Options that name files, with their values.
    std::vector<std::pair<const char*, std::string>> outputs() const {
        return {{"--latex", latex}, {"--csv", csv}, {"--svg", svg}, {"--pdf", pdf}, {"--gltf", gltf}};
    }
};

// the same as for `render`
constexpr PixelSize kSmallestPicture{960, 540};
constexpr PixelSize kLargestPicture{3840, 2160};
constexpr const char* kStandardOutput = "-";

void check(const ExportOptions& options) {
    if (!options.wants_step() && options.gltf.empty()) {
        throw bad_option("export", "nothing to write; expected --latex, --csv, --svg, --pdf or --gltf");
    }
    if (options.step && !options.wants_step()) {
        throw bad_option(
            "export", "--step selects one step, but --gltf exports the whole motion; give one of them");
    }
    if (options.latex == kStandardOutput && options.csv == kStandardOutput) {
        throw bad_option("export", "--latex and --csv both go to standard output; expected a file for one");
    }
    for (const auto& [name, file] : options.outputs()) {
        if (file.empty()) { continue; }
        const bool is_text = name == std::string_view("--latex") || name == std::string_view("--csv");
        if (file != kStandardOutput) {
            check_output(name, file, {options.file});
        } else if (!is_text) {
            throw bad_option(
                "export",
                std::string(name) + " cannot go to standard output, because it is not text; expected a file");
        }
    }
}

void write_file(const std::string& file, const std::string& text, const Streams& streams) {
    if (file == kStandardOutput) {
        streams.out << text;
    } else if (!file.empty()) {
        render::write_file_atomically(file, text);
    }
}

void write_pictures(
    const ExportOptions& options, const PixelSize& size, const Story& story, const View& view) {
    if (!options.wants_picture()) { return; }
    host::FramePainter painter(story, size.width, size.height);
    const auto write_picture = [&](const std::string& file, render::VectorFormat format) {
        if (!file.empty()) { render::write_file_atomically(file, painter.vector_file(view, format)); }
    };
    write_picture(options.svg, render::VectorFormat::svg);
    write_picture(options.pdf, render::VectorFormat::pdf);
}

/// The chosen step; by default the one at which everything is assembled.
int step_of(const ExportOptions& options, const Story& story) {
    if (options.step) { check_step("--step", *options.step, static_cast<int>(story.steps().size()) - 1); }
    return options.step.value_or(story.last_assembled());
}

Exit export_command(const ExportOptions& options, const Streams& streams) {
    check(options);
    const PixelSize size = size_option(options.size, kSmallestPicture, kLargestPicture);
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    streams.err << done_text(changed.done);
    StoryOptions how;
    how.with_motion = !options.gltf.empty() || options.wants_picture() || options.step.has_value();
    const Story story(changed.lesson, how);
    if (options.wants_step()) {
        const View view = view_of(story, step_of(options, story));
        write_file(
            options.latex,
            "% " + std::filesystem::path(changed.lesson.file_name).filename().string() + ", step " +
                std::to_string(view.step) + "\n" + equations_latex(view) +
                matrix_latex(view.matrix, MatrixStyle::labelled),
            streams);
        write_file(options.csv, matrix_csv(view.matrix), streams);
        write_pictures(options, size, story, view);
    }
    if (!options.gltf.empty()) {
        render::write_file_atomically(options.gltf, gltf::encode(moving_scene_of(story)));
    }
    if (const Step* failed = story.failure(); failed != nullptr && !options.gltf.empty()) {
        streams.err << not_reached(changed.lesson, *failed).what() << '\n';
        return Exit::numerics;
    }
    return Exit::done;
}

}  // namespace

void add_export(const CommandLine& line) {
    auto [command, options] = add_command<ExportOptions>(
        line, "export", "write a lesson for papers, slides and other programs", export_command,
        "Example: jointwise export lessons/catalogue/loops/four-bar.toml --gltf four-bar.glb");
    add_lesson_options(command, options.file, options.experiments);
    add_value(command, "--step", options.step, "N", "step of the lesson; default: all joints assembled")
        ->check(&fault_of_step);
    add_value(
        command, "--latex", options.latex, "FILE",
        "equations and Jacobian of the step in LaTeX (amsmath); - for standard output");
    add_value(command, "--csv", options.csv, "FILE", "the Jacobian as a table; - for standard output");
    add_value(
        command, "--svg", options.svg, "FILE",
        "picture of the step as vector graphics; its 3D part is pixels");
    add_value(command, "--pdf", options.pdf, "FILE", "the same as PDF; text stays text");
    add_value(command, "--size", options.size, "WxH", "size of --svg and --pdf in pixels")
        ->capture_default_str();
    add_value(
        command, "--gltf", options.gltf, "FILE",
        "the mechanism with its motion as a scene, binary glTF 2.0 (.glb)");
}

}  // namespace jw
