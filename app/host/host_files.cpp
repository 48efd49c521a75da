#include <imgui.h>

#include "app/host/host.hpp"
#include "app/session/output/export.hpp"
#include "lessons/reader.hpp"
#include "lessons/writer.hpp"

namespace jw::host {

std::filesystem::path Host::free_name(const std::string& suffix) const {
    const std::string stem = path_.stem().string();
    std::filesystem::path path = setup_.pictures / (stem + suffix);
    const std::filesystem::path tail(suffix);
    std::error_code error;
    for (int k = 2; std::filesystem::exists(path, error); ++k) {
        path = setup_.pictures /
               (stem + tail.stem().string() + "-" + std::to_string(k) + tail.extension().string());
    }
    return path;
}

std::filesystem::path Host::task_path() const {
    if (task_ == Task::record) { return free_name("-frames"); }
    return free_name("-step-" + std::to_string(session_->index() + 1) + ".png");
}

void Host::save_lesson() {
    const std::filesystem::path path = free_name("-changed.toml");
    std::string error;
    const std::string text = text_to_save(*session_);
    // what cannot be read back is not to be found out in the next lecture
    const ReadResult read = read_lesson(text, path.filename().string());
    if (!read.lesson) { return say("Not saved: " + read.report()); }
    if (!write_lesson_file(path, text, error)) { return say("Not saved: " + error); }
    unsaved_.saved(*session_);
    say("Saved " + path.string());
}

void Host::keep_unsaved() {
    if (!session_) { return; }
    const std::string problem = unsaved_.keep(*session_, path_.stem().string());
    if (!problem.empty()) { say("What you try is lost if the program ends: " + problem); }
}

void Host::save_csv() {
    const std::filesystem::path path = free_name(std::string("-") + tabs_.plot.name() + ".csv");
    std::string error;
    const bool written = write_lesson_file(path, tabs_.plot.csv(*session_), error);
    say(written ? "Saved " + path.string() : "Not saved: " + error);
}

void Host::copy(const std::string& text, const std::string& what) {
    ImGui::SetClipboardText(text.c_str());
    say(what);
}

void Host::copy_view(Command command) {
    const View& view = session_->view();
    if (command == Command::copy_matrix) {
        return copy(matrix_latex(view.matrix, MatrixStyle::labelled), "Φq copied as LaTeX.");
    }
    if (command == Command::copy_matrix_csv) { return copy(matrix_csv(view.matrix), "Φq copied as CSV."); }
    if (command != Command::copy_equation) { return; }
    if (view.equations.empty()) { return say("There is no equation at this step."); }
    std::string text;
    for (const EquationGroup& group : view.equations) { text += equation_latex(group) + '\n'; }
    copy(text, "The equations copied as LaTeX.");
}

/// Experiments of sessions before this one that were not saved.
std::vector<std::filesystem::path> Host::copies_of_others() const {
    if (setup_.unsaved.empty()) { return {}; }
    std::vector<std::filesystem::path> copies = unsaved_copies(setup_.unsaved);
    std::erase(copies, unsaved_.path());
    return copies;
}

std::vector<CatalogueEntry> Host::refreshed_catalogue() const {
    std::vector<CatalogueEntry> entries = catalogue_of(setup_.catalogue, recent_.paths(), copies_of_others());
    for (CatalogueEntry& entry : entries) {
        for (const CatalogueEntry& before : entries_) {
            // a picture is drawn once per run
            std::error_code error;
            if (std::filesystem::equivalent(before.path, entry.path, error) && entry.error.empty()) {
                entry.thumbnail = before.thumbnail;
            }
        }
    }
    return entries;
}

}  // namespace jw::host
