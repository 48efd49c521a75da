#include "app/commands/program/command.hpp"

#include <algorithm>
#include <cmath>

#include <sys/stat.h>
#include <unistd.h>

#include "app/host/frames/frame_draft.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/read/reader.hpp"
#include "render/files/atomic_file.hpp"
#include "render/fonts/fonts.hpp"

namespace jw {

namespace fs = std::filesystem;

CommandError bad_input(const std::string& message, const std::string& hint) {
    return CommandError(
        Exit::bad_input, "jointwise: error: " + message + (hint.empty() ? "" : "\nhint: " + hint));
}

CommandError bad_option(const std::string& command, const std::string& message) {
    return bad_input(message, "jointwise " + command + " --help");
}

std::size_t place_in(
    const std::vector<std::string>& names, const std::string& name, const std::string& fault) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
        throw bad_input(fault + "; expected one of " + comma_list(names), did_you_mean(name, names));
    }
    return static_cast<std::size_t>(found - names.begin());
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) { throw bad_input("cannot make the folder '" + folder.string() + "': " + error.message()); }
}

Lesson lesson_of(const std::filesystem::path& path, const Streams& streams) {
    if (streams.goes_into && streams.goes_into(path)) {
        throw CommandError(
            Exit::bad_input, path.string() +
                                 ": error: the output of this command would overwrite the lesson that it "
                                 "reads; expected another file after '>'");
    }
    ReadResult read = read_lesson_file(path);
    if (!read.lesson) { throw FaultyFile(read.report(), read.diagnostics); }
    if (!read.diagnostics.empty()) { streams.err << read.report(); }
    return shown_lesson(std::move(*read.lesson));
}

void check_output(const std::string& option, const fs::path& output, const std::vector<fs::path>& inputs) {
    render::check_can_be_written(output);
    std::error_code error;
    if (!fs::exists(output, error)) { return; }
    const auto refuse = [&](const fs::path& input, const std::string& what) {
        if (!fs::equivalent(output, input, error) || error) { return; }
        throw bad_input(
            option + ' ' + in_quotes(output.string()) + " is " + what +
            ", and would be overwritten; expected another file");
    };
    for (const fs::path& input : inputs) { refuse(input, "a file that is read here"); }
    for (const render::FontSource& font : render::find_fonts()) { refuse(font.path, "a font"); }
}

bool is_own_output(const fs::path& path) {
    struct stat file {};
    if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) { return false; }
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat into {};
        if (::fstat(stream, &into) == 0 && into.st_dev == file.st_dev && into.st_ino == file.st_ino) {
            return true;
        }
    }
    return false;
}

void write_proof(
    const std::filesystem::path& file, const ProofRecord& proof, const System& system, const Lesson& lesson) {
    std::string text = json_document(json_of(proof, system, lesson), -1);
    text.resize(text.rfind('}'));
    const std::string hash = host::sha256_of(render::bytes_of(text));
    render::write_file_atomically(file, text + ",\"sha256\":\"" + hash + "\"}\n");
}

std::string fault_of_step(const std::string& text) {
    if (!text.starts_with('-')) { return {}; }  // the conversion reports what is not a number at all
    return text + " is below 0; expected a step, counted from 0";
}

void check_step(const std::string& option, int step, int last) {
    if (step <= last) { return; }
    throw bad_input(
        option + " " + std::to_string(step) + ": the lesson has steps 0 to " + std::to_string(last));
}

ProgressBar::ProgressBar(const Streams& streams, std::string what)
    : streams_(&streams), what_(std::move(what)) {}

ProgressBar::~ProgressBar() {
    if (shown_ >= 0) { streams_->err << "\r\033[K" << std::flush; }
}

void ProgressBar::show(double fraction) {
    if (!streams_->err_is_terminal) { return; }
    const int percent = static_cast<int>(std::lround(100.0 * fraction));
    if (percent == shown_) { return; }
    shown_ = percent;
    constexpr int width = 30;
    const int filled = width * percent / 100;
    streams_->err << "\r" << what_ << " [";
    for (int k = 0; k < width; ++k) { streams_->err << (k < filled ? "#" : "."); }
    streams_->err << "] " << percent << " %" << std::flush;
}

}  // namespace jw
