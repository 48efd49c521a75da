#pragma once

#include <functional>
#include <memory>
#include <stop_token>

/// Work beside whatever else goes on. The one place that knows threads; a page in a browser has none.
namespace jw {

/// Work that is done beside whatever else goes on: in a thread of its own, or, where there are no threads,
/// piece by piece in `run_waiting_work`. Destroyed, it is told to stop and waited for.
class Worker {
public:
    /// Does a piece of the work, some milliseconds long where somebody may wait for the next picture. It must
    /// not throw. @return true while there is more to do
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

/// Does what waits because there are no threads: one piece, and more until so many seconds have passed.
/// @return false if nothing waited
bool run_waiting_work(double seconds);

}  // namespace jw
