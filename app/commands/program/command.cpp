#include "app/commands/program/command.hpp"

#include <cmath>

#include "app/session/wording/shown_lesson.hpp"
#include "lessons/read/reader.hpp"

namespace jw {

CommandError bad_input(const std::string& message, const std::string& hint) {
    return CommandError(
        Exit::bad_input, "jointwise: error: " + message + (hint.empty() ? "" : "\nhint: " + hint));
}

CommandError bad_option(const std::string& command, const std::string& message) {
    return bad_input(message, "jointwise " + command + " --help");
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
