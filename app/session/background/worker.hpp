#pragma once

#include <functional>
#include <memory>
#include <stop_token>

/// Work in the background. This is the only place that uses threads; a page in a browser has none.
namespace jw {

/// Work in the background: in its own thread, or, where there are no threads, piece by piece in
/// `run_waiting_work`. The destructor tells it to stop, and waits for it.
class Worker {
public:
    /// Does a piece of the work. Where somebody may wait for the next picture, a piece takes only some
    /// milliseconds. It must not throw. @return true while there is more to do
    using Piece = std::function<bool(const std::stop_token&)>;

    explicit Worker(Piece piece);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void request_stop();
    /// Returns when all is done.
    void wait();

private:
    friend bool run_waiting_work(double seconds);
    struct Running;
    std::unique_ptr<Running> running_;
};

/// Does work that waits because there are no threads: one piece, then more until `seconds` have passed.
/// @return false if nothing waited
bool run_waiting_work(double seconds);

}  // namespace jw
