#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <system_error>
#include <utility>

#include "lessons/writer.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

/// A file under another name beside its target, removed again unless it was renamed.
class Draft {
public:
    explicit Draft(const fs::path& target) : name_(target.string() + ".part-" + std::to_string(::getpid())) {
        // O_EXCL: never write through a link that somebody left under this name
        file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        struct stat before {};
        // who may read and write the lesson stays as it was
        if (file_ >= 0 && ::stat(target.c_str(), &before) == 0) { ::fchmod(file_, before.st_mode & 0777U); }
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        if (file_ >= 0) { ::close(file_); }
        if (is_there_) { ::unlink(name_.c_str()); }
    }

    bool write(std::string_view text) {
        is_there_ = file_ >= 0;
        while (is_there_ && !text.empty()) {
            const ssize_t written = ::write(file_, text.data(), text.size());
            if (written < 0 && errno == EINTR) { continue; }
            if (written < 0) { return false; }
            text.remove_prefix(static_cast<std::size_t>(written));
        }
        return is_there_;
    }

    bool rename_to(const fs::path& target) {
        // what is renamed must be on the disk, or a power cut leaves an empty lesson; a full disk shows here
        if (::fsync(file_) != 0 || ::close(std::exchange(file_, -1)) != 0) { return false; }
        if (::rename(name_.c_str(), target.c_str()) != 0) { return false; }
        is_there_ = false;
        return true;
    }

private:
    std::string name_;
    int file_ = -1;
    bool is_there_ = false;
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
