#include "app/exercises/run/handles.hpp"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace jw::exercises {

Handle& Handle::operator=(Handle&& other) noexcept {
    if (this != &other) {
        close();
        fd_ = std::exchange(other.fd_, -1);
    }
    return *this;
}

void Handle::close() {
    if (fd_ >= 0) { ::close(fd_); }
    fd_ = -1;
}

Pipe open_pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) { return {}; }
    Pipe pipe{Handle(ends[0]), Handle(ends[1])};
    ::fcntl(pipe.read.fd(), F_SETFL, O_NONBLOCK);
    // a program may open /dev/stdout again, as a user that does not own the pipe
    ::fchmod(pipe.write.fd(), 0666);
    return pipe;
}

Handle memory_file(const std::string& content) {
    Handle file(::memfd_create("input", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!file) { return file; }
    std::size_t written = 0;
    while (written < content.size()) {
        const ssize_t count = ::write(file.fd(), content.data() + written, content.size() - written);
        if (count < 0 && errno == EINTR) { continue; }
        if (count <= 0) { return {}; }
        written += static_cast<std::size_t>(count);
    }
    const bool sealed =
        ::fcntl(file.fd(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) == 0;
    if (!sealed || ::lseek(file.fd(), 0, SEEK_SET) != 0) { return {}; }
    ::fchmod(file.fd(), 0444);
    return file;
}

Handle process_handle(int pid) { return Handle(static_cast<int>(::syscall(SYS_pidfd_open, pid, 0))); }

void kill_process(const Handle& process) {
    if (process) { ::syscall(SYS_pidfd_send_signal, process.fd(), SIGKILL, nullptr, 0); }
}

}  // namespace jw::exercises
