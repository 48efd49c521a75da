#include "app/exercises/practice/progress.hpp"

#include <cstdlib>
#include <system_error>
#include <utility>

#include "app/session/wording/messages.hpp"
#include "lessons/files/file_text.hpp"
#include "lessons/write/writer.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestProgress = 4U << 20U;
constexpr const char* kProgressFile = "progress.toml";
constexpr int kMostSetAside = 100;

/// A free name beside the file: "progress.toml.set-aside", "progress.toml.set-aside-2".
fs::path name_to_set_aside(const fs::path& file) {
    for (int k = 1; k <= kMostSetAside; ++k) {
        fs::path path = file;
        path += k == 1 ? ".set-aside" : ".set-aside-" + std::to_string(k);
        std::error_code error;
        if (!fs::exists(fs::symlink_status(path, error))) { return path; }
    }
    return {};
}

}  // namespace

fs::path Progress::usual_file() {
    if (const char* data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
        return fs::path(data) / "jointwise" / kProgressFile;
    }
    const char* const home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') { return {}; }
    return fs::path(home) / ".local" / "share" / "jointwise" / kProgressFile;
}

Progress::Progress(fs::path file) : file_(std::move(file)) { read(); }

ExerciseRecord Progress::of(const std::string& key) const {
    const auto found = records_.find(key);
    return found == records_.end() ? ExerciseRecord() : found->second;
}

void Progress::read() {
    std::error_code error;
    if (file_.empty() || !fs::exists(fs::symlink_status(file_, error))) { return; }
    if (!fs::is_regular_file(file_, error)) { return set_aside(tr("it is not a file")); }
    FileText text = read_file_text(file_, kLargestProgress);
    if (!text.problem.empty()) { return set_aside(text.problem); }
    ProgressRead read = read_progress(std::move(text.text));
    if (!read.problem.empty()) { return set_aside(read.problem); }
    records_ = std::move(read.records);
}

void Progress::set_aside(const std::string& why) {
    const fs::path other = name_to_set_aside(file_);
    std::error_code error;
    if (!other.empty()) { fs::rename(file_, other, error); }
    if (other.empty() || error) {
        writable_ = false;
        notice_ = tr(
            "The progress file '{0}' cannot be read ({1}) or renamed; what you solve now will not be saved.",
            file_.string(), why);
        return;
    }
    notice_ =
        tr("The progress in '{0}' could not be read ({1}); the file was renamed '{2}', and progress starts "
           "again.",
           file_.string(), why, other.filename().string());
}

void Progress::keep(const std::string& key, const ExerciseRecord& record) {
    // another window may have written to the file
    if (writable_) { read(); }
    records_[key] = record;
    if (writable_) { write(); }
}

void Progress::write() {
    if (file_.empty()) { return; }
    std::error_code ignored;
    fs::create_directories(file_.parent_path(), ignored);
    std::string error;
    if (write_lesson_file(file_, progress_text(records_), error)) { return; }
    if (!std::exchange(complained_, true)) {
        notice_ = tr("What you solve now will not be saved: {0}", error);
    }
}

std::string Progress::take_notice() { return std::exchange(notice_, {}); }

}  // namespace jw
