#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "lessons/write/writer.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

// number of drafts that killed programs may have left behind; more are not an accident
constexpr int kMostDrafts = 100;

/// A file under another name beside its target, removed again unless it was renamed.
class Draft {
public:
    explicit Draft(const fs::path& target) {
        // "x": always a new file, and never through a link that somebody left there
        for (int k = 1; file_ == nullptr && k <= kMostDrafts; ++k) {
            name_ = target.string() + ".part-" + std::to_string(k);
            file_ = std::fopen(name_.c_str(), "wbx");
            if (file_ == nullptr && errno != EEXIST) { return; }
        }
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        if (file_ == nullptr && !is_closed_) { return; }
        if (file_ != nullptr) { std::fclose(file_); }
        if (!is_renamed_) { std::remove(name_.c_str()); }
    }

    bool write(const std::string& text) {
        if (file_ == nullptr || std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
            return false;
        }
        // a full disk may be reported only here
        is_closed_ = true;
        return std::fclose(std::exchange(file_, nullptr)) == 0;
    }

    bool rename_to(const fs::path& target) {
        std::error_code ignored;
        // the permissions of the lesson stay unchanged
        const fs::file_status before = fs::status(target, ignored);
        if (fs::exists(before)) { fs::permissions(name_, before.permissions(), ignored); }
        is_renamed_ = std::rename(name_.c_str(), target.c_str()) == 0;
        return is_renamed_;
    }

private:
    std::string name_;
    std::FILE* file_ = nullptr;
    bool is_closed_ = false;
    bool is_renamed_ = false;
};

}  // namespace

bool write_lesson_file(const fs::path& path, const std::string& text, std::string& error) {
    const auto fail = [&](const std::string& why, const std::string& expected) {
        error = "cannot write '" + path.string() + "': " + why + "; expected " + expected;
        return false;
    };
    std::error_code ignored;
    if (path.filename().empty() || fs::is_directory(path, ignored)) {
        return fail("this is a folder", "the name of a lesson file (.toml)");
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored)) {
        return fail("there is no folder '" + folder.string() + "'", "a folder that is there");
    }
    // through links, so that a lesson kept elsewhere stays there
    const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
    Draft draft(target);
    if (!draft.write(text) || !draft.rename_to(target)) {
        const std::string why = std::generic_category().message(errno);
        return fail(why, "a folder with room in which files may be written");
    }
    return true;
}

}  // namespace jw
