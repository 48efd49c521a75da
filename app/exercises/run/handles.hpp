#pragma once

#include <string>
#include <utility>

namespace jw::exercises {

/// A file descriptor that is closed with its owner; -1: none.
class Handle {
public:
    Handle() = default;
    explicit Handle(int fd) : fd_(fd) {}
    Handle(Handle&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Handle& operator=(Handle&& other) noexcept;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { close(); }

    int fd() const { return fd_; }
    explicit operator bool() const { return fd_ >= 0; }
    void close();

private:
    int fd_ = -1;
};

/// A pipe: this process reads without waiting, the sandbox writes. Both handles are none if the system cannot
/// open any more pipes.
struct Pipe {
    Handle read;
    Handle write;
};

Pipe open_pipe();

/// A file in memory that nobody can change, read from its beginning. None if the system refuses it.
Handle memory_file(const std::string& content);

/// Handle of a process, which becomes readable when the process has ended. None if there is no such process.
Handle process_handle(int pid);

/// SIGKILL to the process of a handle.
void kill_process(const Handle& process);

}  // namespace jw::exercises
