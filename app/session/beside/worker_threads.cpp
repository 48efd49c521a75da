#include <thread>

#include "app/session/beside/worker.hpp"

namespace jw {

struct Worker::Running {
    std::jthread thread;
};

Worker::Worker(Work work)
    : running_(std::make_unique<Running>(
          Running{std::jthread([work = std::move(work)](const std::stop_token& stop) { work(stop); })})) {}

Worker::~Worker() = default;

void Worker::request_stop() { running_->thread.request_stop(); }

void Worker::wait() {
    if (running_->thread.joinable()) { running_->thread.join(); }
}

bool run_waiting_work() { return false; }

}  // namespace jw
