#include "lessons/files/file_text.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = 1U << 16U;
// a writer that is just starting opens the pipe within this time [ms]
constexpr int kWaitForWriter = 2000;
// a program that generates the lesson while it is read may need this time for a part of it [ms]
constexpr int kWaitForText = 8000;

class Descriptor {
public:
    explicit Descriptor(const fs::path& path)
        // a pipe opens at once, even without a writer
        : file_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (file_ >= 0) { ::close(file_); }
    }
    int get() const { return file_; }

private:
    int file_;
};

std::string why_not_opened(const fs::path& path, int error) {
    std::error_code ignored;
    switch (error) {
        case ENOENT:
            if (!fs::is_symlink(path, ignored)) { return "there is no such file"; }
            return "this is a link to " + in_quotes(fs::read_symlink(path, ignored).string()) +
                   ", and there is no such file";
        case ELOOP: return "this is a link that leads back to itself";
        case ENOTDIR: return "a part of the path is a file, not a folder";
        case ENAMETOOLONG: return "the name is too long for a file";
        case EACCES:
        case EPERM: return "the file cannot be opened: no permission to read it";
        default: return "the file cannot be opened: " + std::generic_category().message(error);
    }
}

std::string in_seconds(int milliseconds) { return std::to_string(milliseconds / 1000) + " s"; }

/// Waits until there is something to read, or the end.
/// @return why there will be nothing to read; empty otherwise
std::string wait_for(int file, bool nobody_writes) {
    const int patience = nobody_writes ? kWaitForWriter : kWaitForText;
    pollfd waiting{file, POLLIN, 0};
    int ready = 0;
    do { ready = ::poll(&waiting, 1, patience); } while (ready < 0 && errno == EINTR);
    if (ready != 0) { return {}; }
    return nobody_writes ? "this is a pipe that nothing is written into (waited " + in_seconds(patience) + ")"
                         : "nothing more was written into this pipe for " + in_seconds(patience);
}

}  // namespace

FileText read_file_text(const fs::path& path, std::size_t most) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) { return {{}, "this is a folder"}; }
    const Descriptor file(path);
    if (file.get() < 0) { return {{}, why_not_opened(path, errno)}; }
    FileText result;
    bool waited = false;
    while (result.text.size() <= most) {
        const std::size_t before = result.text.size();
        result.text.resize(before + kChunk);
        const ssize_t count = ::read(file.get(), result.text.data() + before, kChunk);
        const int error = errno;
        result.text.resize(before + static_cast<std::size_t>(count > 0 ? count : 0));
        if (count > 0) { continue; }
        const bool nobody_writes = count == 0 && before == 0 && fs::is_fifo(status);
        if (count == 0 && (!nobody_writes || waited)) { return result; }
        if (count < 0 && error == EINTR) { continue; }
        if (count < 0 && error != EAGAIN) {
            return {{}, "the file cannot be read to its end: " + std::generic_category().message(error)};
        }
        waited = true;
        if (std::string problem = wait_for(file.get(), nobody_writes); !problem.empty()) {
            return {{}, std::move(problem)};
        }
    }
    return {{}, "the file is larger than " + std::to_string(most >> 20U) + " MB"};
}

}  // namespace jw
