#pragma once

#include <functional>
#include <memory>
#include <stop_token>

/// Work beside whatever else goes on. The one place that knows threads; a page in a browser has none.
namespace jw {

/// A function that runs beside whatever else goes on: in a thread of its own, or, where there are no threads,
/// in `run_waiting_work`. It must not throw. Destroyed, it is told to stop and waited for.
class Worker {
public:
    using Work = std::function<void(const std::stop_token&)>;

    explicit Worker(Work work);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Tells the function to stop; one that has not begun never begins.
    void request_stop();
    /// Returns when the function has ended.
    void wait();

private:
    struct Running;
    std::unique_ptr<Running> running_;
};

/// Runs one of the functions that wait because there are no threads, to its end.
/// @return false if none waits
bool run_waiting_work();

}  // namespace jw
