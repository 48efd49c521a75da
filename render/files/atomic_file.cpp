#include "render/files/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <deque>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace jw::render {
namespace {

namespace fs = std::filesystem;

// number of drafts that killed programs may have left behind; more are not an accident
constexpr int kMostDrafts = 100;

[[noreturn]] void fail_to_write(const fs::path& path, const std::string& why) {
    throw std::runtime_error("cannot write '" + path.string() + "': " + why);
}

[[noreturn]] void fail_to_write(const fs::path& path, int error) {
    fail_to_write(path, std::generic_category().message(error));
}

fs::path folder_of(const fs::path& target) {
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// A file that is being written. It is removed again unless `finish` and then `publish` were reached.
class Draft {
public:
    explicit Draft(const fs::path& target) : target_(target) {
        check_can_be_written(target);
#ifdef O_TMPFILE
        // without /proc, the file could not be given a name later
        if (::access("/proc/self/fd", X_OK) == 0) {
            file_ = ::open(folder_of(target).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
        }
#endif
        if (file_ >= 0) { return; }
        with_free_name([this](const char* name) {
            // O_EXCL: never write through a link that somebody left under this name
            file_ = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            return file_ >= 0;
        });
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        if (file_ >= 0) { ::close(file_); }
        if (!name_.empty()) { ::unlink(name_.c_str()); }
    }

    void write(std::span<const std::uint8_t> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(file_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) { continue; }
            if (written < 0) { fail_to_write(target_, errno); }
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
    }

    /// Completes the content and gives the file the name of a draft.
    void finish() {
        if (name_.empty()) {
            const std::string nameless = "/proc/self/fd/" + std::to_string(file_);
            with_free_name([&](const char* name) {
                return ::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
            });
        }
        // a full disk may be reported only here
        if (::close(std::exchange(file_, -1)) != 0) { fail_to_write(target_, errno); }
    }

    void publish() {
        if (std::rename(name_.c_str(), target_.c_str()) != 0) { fail_to_write(target_, errno); }
        name_.clear();
    }

private:
    /// @param make  uses a name; returns false with errno if this fails
    template <class Make>
    void with_free_name(const Make& make) {
        const std::string stem = target_.string() + ".part-" + std::to_string(::getpid());
        for (int k = 1; k <= kMostDrafts; ++k) {
            const std::string name = k == 1 ? stem : stem + "-" + std::to_string(k);
            if (make(name.c_str())) {
                name_ = name;
                return;
            }
            if (errno != EEXIST) { break; }
        }
        fail_to_write(target_, errno);
    }

    fs::path target_;
    std::string name_;  ///< empty while the file has no name
    int file_ = -1;
};

}  // namespace

void check_can_be_written(const fs::path& path) {
    std::error_code error;
    switch (fs::status(path, error).type()) {
        case fs::file_type::directory: fail_to_write(path, EISDIR);
        // renaming would replace a device by a file, for everybody on the machine
        case fs::file_type::block:
        case fs::file_type::character: fail_to_write(path, "this is a device; expected the name of a file");
        case fs::file_type::fifo:
        case fs::file_type::socket: fail_to_write(path, "this is a pipe; expected the name of a file");
        default: break;
    }
    if (path.filename().empty()) { fail_to_write(path, "expected the name of a file"); }
    const fs::file_status folder = fs::status(folder_of(path), error);
    if (!fs::exists(folder)) { fail_to_write(path, ENOENT); }
    if (!fs::is_directory(folder)) { fail_to_write(path, ENOTDIR); }
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void write_files_atomically(std::span<const WholeFile> files) {
    std::deque<Draft> drafts;
    for (const WholeFile& file : files) { drafts.emplace_back(file.path).write(file.bytes); }
    for (Draft& draft : drafts) { draft.finish(); }
    for (Draft& draft : drafts) { draft.publish(); }
}

void write_file_atomically(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const WholeFile file{path, bytes};
    write_files_atomically({&file, 1});
}

void write_file_atomically(const fs::path& path, std::string_view text) {
    write_file_atomically(path, bytes_of(text));
}

}  // namespace jw::render
