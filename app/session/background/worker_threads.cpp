#include <thread>

#include "app/session/background/worker.hpp"

namespace jw {

struct Worker::Running {
    std::jthread thread;
};

Worker::Worker(Piece piece)
    : running_(
          std::make_unique<Running>(Running{std::jthread([piece = std::move(piece)](std::stop_token stop) {
              while (piece(stop)) {}
          })})) {}

Worker::~Worker() = default;

void Worker::request_stop() { running_->thread.request_stop(); }

void Worker::wait() {
    if (running_->thread.joinable()) { running_->thread.join(); }
}

bool run_waiting_work(double) { return false; }

}  // namespace jw
